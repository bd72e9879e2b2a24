// The protocol's official TypeScript client furnishes a room, changes it, looks at it and asks for wrong things.
// typescript_client.mjs ROOMGEN FOLDER: FOLDER is emptied and used.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { Client } from '@modelcontextprotocol/sdk/client/index.js';
import { StdioClientTransport } from '@modelcontextprotocol/sdk/client/stdio.js';

const [roomgen, folder] = process.argv.slice(2);
fs.rmSync(folder, { recursive: true, force: true });
const root = path.join(folder, 'root');
fs.mkdirSync(root, { recursive: true });

const client = new Client({ name: 'roomgen-test', version: '1' });
await client.connect(new StdioClientTransport({
  command: roomgen,
  args: ['mcp', '--root', root, '--no-default-libraries', '--cache', path.join(folder, 'cache')],
}));

const text = (result) => result.content.filter((part) => part.type === 'text').map((part) => part.text).join('\n');
const call = (name, args) => client.callTool({ name, arguments: args });

async function done(name, args) {
  const result = await call(name, args);
  assert.ok(!result.isError, name + ': ' + text(result));
  return result;
}

async function refused(name, args, part) {
  const result = await call(name, args);
  assert.ok(result.isError, name + ' was not refused');
  assert.match(text(result), part);
}

const { tools } = await client.listTools();
assert.equal(tools.length, 21);

const made = await done('generate', { folder: 'study', prompt: 'a small study with a desk and a chair' });
assert.equal(made.structuredContent.room, 'study');
const picture = made.content.find((part) => part.type === 'image');
assert.ok(Buffer.from(picture.data, 'base64').subarray(1, 4).equals(Buffer.from('PNG')));

const scene = path.join(root, 'study', 'scene.json');
const first = fs.readFileSync(scene);
const edited = await done('edit', { room: 'study', change: 'turn the desk chair by 10 degrees' });
assert.ok(edited.structuredContent.changes.length > 0);
assert.ok(!fs.readFileSync(scene).equals(first));
await done('undo', { room: 'study', picture: 'none' });
assert.ok(fs.readFileSync(scene).equals(first));
assert.equal((await done('check', { room: 'study' })).structuredContent.valid, true);
await done('render', { room: 'study', view: 'top' });
await done('export', { room: 'study', file: 'study.glb' });

// As clients in strict mode call: every property, null or empty for what is left out, and values as texts.
const everything = await done('explain', { room: 'study', object: null, skip: '0' });
assert.ok(everything.structuredContent.objects.length >= 2 && everything.structuredContent.next === undefined);
await done('render', { room: 'study', view: '', pixels: '128', file: null });
await refused('edit', { room: 'study', change: '', operations: [] }, /either change or operations/);

const { resources } = await client.listResources();
assert.equal(resources.filter(({ uri }) => !uri.startsWith('roomgen:///docs/')).length, 2);
const ledger = await client.readResource({ uri: 'roomgen:///study/ledger.json' });
assert.ok(JSON.parse(ledger.contents[0].text).requirements.length > 0);
await assert.rejects(client.readResource({ uri: 'roomgen:///none/scene.json' }));

const composed = await done('compose', { folder: 'waiting', prompt: 'a waiting room', seats: '4', steps: 2000, rounds: 1 });
assert.equal(composed.structuredContent.measures[0].name, 'seats');
await refused('optimise', { folder: 'other', program: { format: 'roomgen-program' } }, /program/);

await refused('check', { room: '..' }, /leads out of the root folder/);
await refused('check', { room: 7 }, /expected a text/);
await refused('edit', { room: 'study', change: 'sing a song' }, /./);
await assert.rejects(call('fly', {}), /unknown tool/);
await client.ping();
await client.close();
