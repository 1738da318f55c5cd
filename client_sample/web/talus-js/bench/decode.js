// node bench/decode.js FILE [NATIVE]: what decoding takes here, and in the program made from native.cpp, by turns. Of each
// chunk the best of nine rounds counts, so that what else the machine does falls out. Exits 1 where a kind of chunk takes
// more than MARK times native's time.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { decodeChunk, hashVoxels } from '../dist/index.js';

const ROUNDS = 9;
const MARK = 12;
const ENOUGH = 100; // chunks of a kind, to say something about it
const [file, native] = process.argv.slice(2);
const bytes = readFileSync(file);
const payloads = [];
for (let at = 0; at < bytes.length; ) {
  const length = bytes.readUInt32LE(at);
  payloads.push(new Uint8Array(bytes.subarray(at + 4, at + 4 + length)));
  at += 4 + length;
}

const into = new Uint16Array(32_768);
const best = new Float64Array(payloads.length).fill(Infinity);
for (let round = 0; round < ROUNDS; ++round) {
  payloads.forEach((payload, i) => {
    const began = performance.now();
    decodeChunk(payload, { into });
    best[i] = Math.min(best[i], 1_000 * (performance.now() - began));
  });
}
let isOver = false;
const kinds = { layers: (p) => p[0] === 3, volume: (p) => p[0] === 4, all: () => true };
const times = native === undefined ? null : JSON.parse(execFileSync(native, [file, String(ROUNDS)]));
for (const [kind, has] of Object.entries(kinds)) {
  const mean = (all) => all.filter((_, i) => has(payloads[i])).reduce((sum, us, _, { length }) => sum + us / length, 0);
  const ours = mean([...best]);
  const count = payloads.filter(has).length;
  if (times !== null && count >= ENOUGH && ours > MARK * mean(times)) isOver = true;
  const beside = times === null ? '' : `, native ${mean(times).toFixed(2)} us: ${(ours / mean(times)).toFixed(1)} times`;
  console.log(`${kind}: ${count} chunks, ${ours.toFixed(1)} us a chunk${beside}`);
}
let hash = Infinity;
const chunk = decodeChunk(payloads[0]);
for (let i = 0; i < 2_000; ++i) {
  const began = performance.now();
  hashVoxels(chunk);
  hash = Math.min(hash, 1_000 * (performance.now() - began));
}
console.log(`hash: ${hash.toFixed(1)} us a chunk`);
if (isOver) {
  console.error(`more than ${MARK} times native's time`);
  process.exitCode = 1;
}
