// Meshing real land, in one file as in dist/ (vite-node would look imports up at each use):
//   npx esbuild --bundle --platform=node --format=esm test/bench/mesher.bench.ts --outfile=/tmp/mesher.mjs && node /tmp/mesher.mjs DIR
// where DIR is what `talus-gen export --origin 0,0 --size 320,320 -o DIR` wrote.
import { readFileSync } from 'node:fs';
import { LIQUID, SOLID, meshChunk } from '../../src/engine/mesh/mesher.js';
import { PADDED_VOXELS, SIDE, paddedIndex } from '../../src/engine/mesh/volume.js';

const directory = process.argv[2]!;
const file = readFileSync(`${directory}/voxels.npy`);
const header = file.subarray(10, 10 + file.readUInt16LE(8)).toString();
const [height, depth, width] = header.match(/\((\d+), (\d+), (\d+)\)/)!.slice(1).map(Number) as [number, number, number];
const voxels = new Uint8Array(file.buffer, file.byteOffset + 10 + file.readUInt16LE(8));
const kinds = new Uint8Array(256).fill(SOLID);
kinds[0] = 0;
kinds[1] = LIQUID;
const places = Uint16Array.from({ length: 65536 }, (_, i) => i & 255);

const at = (x: number, y: number, z: number) => (y >= height ? 0 : y < 0 ? 2 : voxels[(y * depth + z) * width + x]!);
const padded = new Uint16Array(PADDED_VOXELS);
let chunks = 0;
let quads = 0;
let skirts = 0;
let liquid = 0;
const times: number[] = [];
for (let round = 0; round < 3; round++) {
  for (let cy = 0; cy * 32 < height; cy++)
    for (let cz = 1; cz + 1 < depth / 32 - 1; cz++)
      for (let cx = 1; cx + 1 < width / 32 - 1; cx++) {
        for (let y = -1; y <= SIDE; y++)
          for (let z = -1; z <= SIDE; z++)
            for (let x = -1; x <= SIDE; x++) padded[paddedIndex(x, y, z)] = at(cx * 32 + x, cy * 32 + y, cz * 32 + z);
        const start = process.cpuUsage().user;
        const mesh = meshChunk(padded, { kinds, places, slot: 1, occlusion: true, grounded: false, kept: null });
        if (round === 0) continue;
        times.push((process.cpuUsage().user - start) / 1000);
        chunks++;
        quads += mesh.counts.subarray(0, 6).reduce((a, b) => a + b);
        skirts += mesh.counts.subarray(6, 10).reduce((a, b) => a + b);
        liquid += mesh.counts[10]!;
      }
}
times.sort((a, b) => a - b);
const ms = (q: number) => times[Math.floor(times.length * q)]!.toFixed(3);
console.log(`${chunks / 2} chunks of ${height} rows: mean ${(times.reduce((a, b) => a + b) / times.length).toFixed(3)} ms, ` +
  `median ${ms(0.5)}, p95 ${ms(0.95)}, p99 ${ms(0.99)}; per chunk ${(quads / chunks) | 0} quads, ${(skirts / chunks) | 0} of skirts, ${(liquid / chunks) | 0} of liquid`);
