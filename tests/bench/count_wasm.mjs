// node count_wasm.mjs MODULE.wasm PREFIX: what work such as bench_work's costs by WebAssembly; the module is count_wasm.awk's.
import { readFileSync } from 'node:fs';
import { World } from '../../client_sample/web/talus-js/wasm/world.js';

const [file, prefix] = process.argv.slice(2);
const module = await WebAssembly.compile(readFileSync(file));
const { instantiate } = WebAssembly;
let exported;
WebAssembly.instantiate = async (...all) => {
  const instance = await instantiate(...all);
  exported = instance.exports;
  return instance;
};
const open = (name) => World.open(readFileSync(new URL(`../../core/worlds/${name}.toml`, import.meta.url)), { module });

// The first work after open() has that counted too.
let before = 0n;
function count(stage, work) {
  const result = work();
  console.log(`${prefix}${stage} ${exported.counted.value - before}`);
  before = exported.counted.value;
  return result;
}

const patch = { x: -64, z: -194, width: 4, depth: 4 };
const classic = await open('classic');
before = exported.counted.value;
count('whole', () => classic.prepare(patch));

before = 0n;
const world = await open('default');
count('start', () => world.prepare({ ...patch, width: 1, depth: 1 }));
count('default_view', () => {
  for (const z of [0, 4, 8]) for (const x of [0, 4, 8]) world.prepare({ ...patch, x: -64 + x, z: -196 + z });
});
count('default_level_6', () => world.prepare({ lod: 6, x: -1, z: -4, width: 3, depth: 3 }));
world.prepare(patch);
before = exported.counted.value;
const payloads = count('default_chunks', () => {
  const made = [];
  for (let z = patch.z; z < patch.z + 4; ++z)
    for (let x = patch.x; x < patch.x + 4; ++x) {
      const { first, last } = world.rows({ x, z });
      for (let y = first; y <= last; ++y) made.push(world.generate({ x, y, z }, { voxels: false, payload: true }).payload);
    }
  return made;
});
count('decode', () => payloads.forEach((payload) => payload && world.decode(payload)));
