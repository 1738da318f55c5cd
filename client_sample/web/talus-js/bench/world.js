// node bench/world.js WORLD.toml LOCAL_TIME: opening a world and the chunks of a View of radius 8, by WebAssembly beside the
// native program (target talus_local_time). Of each the best of five rounds counts, in milliseconds of CPU.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { World } from '../wasm/world.js';

const ROUNDS = 5;
const [file, native] = process.argv.slice(2);
const toml = readFileSync(file);
const cpuMs = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};

async function measure(simd) {
  const best = { openMs: Infinity, viewMs: Infinity, chunks: 0, firstOpenMs: 0, firstViewMs: 0, memory: 0 };
  for (let round = 0; round < ROUNDS; ++round) {
    let began = cpuMs();
    const world = await World.open(toml, { simd });
    const openMs = cpuMs() - began;
    began = cpuMs();
    let chunks = 0;
    for (let patchZ = -8; patchZ < 12; patchZ += 4)
      for (let patchX = -8; patchX < 12; patchX += 4)
        for (let z = patchZ; z < patchZ + 4 && z <= 8; ++z)
          for (let x = patchX; x < patchX + 4 && x <= 8; ++x) {
            const { first, last } = world.rows({ x, z });
            for (let y = first; y <= last; ++y, ++chunks) world.generate({ x, y, z }, { voxels: false });
          }
    const viewMs = cpuMs() - began;
    if (round === 0) Object.assign(best, { firstOpenMs: openMs, firstViewMs: viewMs });
    Object.assign(best, { openMs: Math.min(best.openMs, openMs), viewMs: Math.min(best.viewMs, viewMs), chunks, memory: world.memoryBytes });
    world.close();
  }
  return best;
}

const beside = JSON.parse(execFileSync(native, [file, String(ROUNDS)]));
const row = (name, { openMs, viewMs, chunks, firstOpenMs, firstViewMs, memory }) => {
  const times = `${(openMs / beside.openMs).toFixed(1)} and ${(viewMs / beside.viewMs).toFixed(1)} times`;
  const first = firstOpenMs === undefined ? '' : `; first ${firstOpenMs.toFixed(0)} and ${firstViewMs.toFixed(0)} ms; ${(memory / 2 ** 20).toFixed(0)} MiB`;
  console.log(`${name}: opened in ${openMs.toFixed(1)} ms, ${chunks} chunks in ${viewMs.toFixed(1)} ms, ${((1000 * viewMs) / chunks).toFixed(0)} us each: ${times}${first}`);
};
row('native', beside);
row('wasm, vectors', await measure(true));
row('wasm, scalar', await measure(false));
