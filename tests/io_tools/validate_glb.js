// Checks GLB files by the Khronos glTF validator and prints what it says, as JSON.
// node validate_glb.js FILE ..    (finds the package gltf-validator through NODE_PATH)
const fs = require('fs');
const validator = require('gltf-validator');

async function main() {
  const results = [];
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    const messages = report.issues.messages.map((m) => `${m.code} ${m.pointer}: ${m.message}`);
    results.push({
      file,
      errors: report.issues.numErrors,
      warnings: report.issues.numWarnings,
      infos: report.issues.numInfos + report.issues.numHints,
      messages,
      info: report.info,
    });
  }
  console.log(JSON.stringify(results, null, 1));
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
