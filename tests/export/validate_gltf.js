// Fails when the Khronos validator has an error or a warning about one of the files.
const fs = require('fs');
const validator = require('gltf-validator');

// Pictures of any size are fine for every engine of today.
const options = {ignoredIssues: ['IMAGE_NPOT_DIMENSIONS']};

async function main(files) {
  if (files.length === 0) throw new Error('no files to check');
  let failures = 0;
  for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), options);
    const {numErrors, numWarnings, numInfos, messages} = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos`);
    for (const m of messages) console.log(`  ${m.code} ${m.pointer}: ${m.message}`);
    failures += numErrors + numWarnings;
  }
  process.exit(failures === 0 ? 0 : 1);
}

main(process.argv.slice(2)).catch(error => {
  console.error(error.message);
  process.exit(1);
});
