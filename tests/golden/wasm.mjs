// node wasm.mjs MODULE.wasm INPUTS.json GOLDEN.txt: INPUTS is what talus_golden_inputs prints.
import { readFileSync } from 'node:fs';
import { World } from '../../client_sample/web/talus-js/wasm/world.js';
import { goldenText } from './golden_text.mjs';

const [modulePath, inputsPath, expectedPath] = process.argv.slice(2);
const module = await WebAssembly.compile(readFileSync(modulePath));
let set;
const open = async (toml, files) => {
  const world = await World.open(toml, { files, module });
  set = world.instructionSet;
  return world;
};
const text = await goldenText(open, JSON.parse(readFileSync(inputsPath, 'utf8')));
const expected = readFileSync(expectedPath, 'utf8');
if (text === expected) {
  console.log(`as in ${expectedPath}, by ${set}`);
} else {
  console.log(`${text}differs from ${expectedPath}:\n${expected}`);
  process.exitCode = 1;
}
