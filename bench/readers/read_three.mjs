// What three.js finds in the GLB files named on standard input: a line of JSON each. After a tab may stand a thing to
// move and OUT: then the file is written again, with user data (OUT-extras.glb) and without (OUT-names.glb).
import {readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

// What browsers have and Node lacks; pictures are not looked at.
globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({width: 1, height: 1, close() {}});
globalThis.FileReader = class {
  readAsArrayBuffer(blob) {
    blob.arrayBuffer().then(result => {
      this.result = result;
      this.onloadend();
    });
  }
};

const addon = name => pathToFileURL(`${process.env.ROOMGEN_NODE_MODULES}/three/examples/jsm/${name}.js`);
const {GLTFLoader} = await import(addon('loaders/GLTFLoader'));
const {GLTFExporter} = await import(addon('exporters/GLTFExporter'));
const MOVE = 0.15;

async function load(file) {
  const bytes = readFileSync(file);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  return (await new GLTFLoader().parseAsync(buffer, '')).scene;
}

function things(scene) {
  const found = [];
  scene.traverse(one => {
    if ('id' in one.userData && !('shell' in one.userData)) found.push(one);
  });
  return found;
}

async function write(scene, file) {
  // Meshes only: there is no canvas to write pictures with.
  scene.traverse(one => {
    if (one.material) one.material.map = null;
  });
  writeFileSync(file, Buffer.from(await new GLTFExporter().parseAsync(scene, {binary: true})));
}

async function trip(scene, moved, out) {
  things(scene).find(one => one.userData.id === moved).position.x += MOVE;
  await write(scene, `${out}-extras.glb`);
  scene.traverse(one => (one.userData = {}));
  await write(scene, `${out}-names.glb`);
}

for (const task of readFileSync(0, 'utf8').split('\n').filter(line => line)) {
  const [file, moved, out] = task.split('\t');
  let line;
  try {
    const scene = await load(file);
    line = {file, nodes: things(scene).map(one => ({name: one.name, id: one.userData.id}))};
    if (moved) await trip(scene, moved, out);
  } catch (error) {
    line = {file, error: String(error)};
  }
  console.log(JSON.stringify(line));
}
