// Payloads and runs that this package writes and reads, against the decoder and against FORMAT.md's own example.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeChunk, encodeChunk, TalusError } from '../dist/index.js';
import { readRuns } from '../dist/edits/runs.js';
import { mutate, random } from './support/random.js';
import { fromHex, payloads } from './support/repository.js';

const dense = (voxels) => ({ uniform: null, voxels });
const runsOf = (bytes) => {
  const runs = [];
  readRuns(bytes, (first, end, material) => runs.push([first, end, material]));
  return runs;
};

test('what is encoded decodes to the same voxels: all chunks of the vectors', () => {
  for (const { name, payload, kind } of payloads()) {
    if (kind !== 'chunk') continue;
    const chunk = decodeChunk(payload);
    assert.deepEqual(decodeChunk(encodeChunk(chunk)), chunk, name);
  }
});

test('what is encoded decodes to the same voxels: random ones', () => {
  const next = random('encoded chunks');
  const voxels = new Uint16Array(32_768);
  for (let round = 0; round < 150; ++round) {
    const materials = Array.from({ length: 1 + next([1, 2, 5, 40, 256, 300][next(6)]) }, () => next(65_536));
    const longest = 1 + next([1, 2, 3, 30, 1_000, 32_768][next(6)]);
    for (let at = 0; at < voxels.length; ) {
      const end = Math.min(voxels.length, at + 1 + next(longest));
      voxels.fill(materials[next(materials.length)], at, end);
      at = end;
    }
    const payload = encodeChunk(dense(voxels));
    const decoded = decodeChunk(payload);
    assert.deepEqual(decoded.voxels ?? voxels.slice().fill(decoded.uniform), voxels);
    assert(payload.length <= 65_538);
  }
});

test('a chunk of one material is encoded as uniform, noise raw', () => {
  assert.deepEqual([...encodeChunk(dense(new Uint16Array(32_768).fill(300)))], [...fromHex('030001ac02')]);
  assert.equal(encodeChunk(dense(Uint16Array.from({ length: 32_768 }, (_, i) => i))).length, 65_538);
  assert.throws(() => encodeChunk(dense(new Uint16Array(5))), { name: 'TalusError', kind: 'out_of_range' });
});

test("runs: FORMAT.md's example, the empty set, a whole chunk", () => {
  assert.deepEqual(runsOf(fromHex('0203ac020305040001' + '1f01')), [[5, 8, 3], [8, 9, 300], [40, 41, 300]]);
  assert.deepEqual(runsOf(fromHex('0000')), []);
  assert.deepEqual(runsOf(fromHex('01070100ffff01')), [[0, 32_768, 7]]);
});

for (const [what, hex] of [
  ['no bytes', '-'],
  ['bytes after the last run', '000000'],
  ['materials that do not rise', '020303' + '02' + '0000' + '0001'],
  ['a material of no run', '020304' + '01' + '0000'],
  ['a run of no material', '00' + '01' + '0000'],
  ['two runs that are one', '0103' + '02' + '0000' + '0000'],
  ["a run past the chunk's end", '0103' + '01' + '01' + 'ffff01'],
  ['a varint longer than need be', '0103' + '01' + '8000' + '00'],
  ['runs that end too early', '0103' + '02' + '0000'],
]) {
  test(`runs: ${what} are refused`, () => assert.throws(() => runsOf(fromHex(hex)), { name: 'TalusError', kind: 'broken_protocol' }));
}

test('broken runs are TalusErrors or runs in order, and nothing else', () => {
  const next = random('broken runs');
  const whole = fromHex('0203ac0203050400011f01');
  for (let round = 0; round < 20_000; ++round) {
    let last = 0;
    try {
      for (const [first, end, material] of runsOf(mutate(whole, next))) {
        assert(last <= first && first < end && end <= 32_768 && material <= 0xffff);
        last = end;
      }
    } catch (error) {
      if (!(error instanceof TalusError)) throw error;
    }
  }
});
