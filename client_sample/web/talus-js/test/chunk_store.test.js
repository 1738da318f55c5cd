import assert from 'node:assert/strict';
import { test } from 'node:test';
import { apronVolume, ChunkStore, neighbourBit } from '../dist/index.js';
import { random } from './support/random.js';

const key = (x, y, z, lod = 0) => ({ lod, x, y, z });
const uniform = (material) => ({ uniform: material, voxels: null });
const dense = (fill) => ({ uniform: null, voxels: Uint16Array.from({ length: 32_768 }, fill) });

test('an apron has the voxels that are there, and tells of chunks that are not', () => {
  const next = random('aprons');
  for (let round = 0; round < 6; ++round) {
    const store = new ChunkStore(64 << 20);
    let missing = 0;
    for (let dy = -1; dy <= 1; ++dy) {
      for (let dz = -1; dz <= 1; ++dz) {
        for (let dx = -1; dx <= 1; ++dx) {
          const kind = next(4);
          if (kind === 0) missing |= neighbourBit(dx, dy, dz);
          else store.put(key(5 + dx, -1 + dy, dz), kind === 1 ? uniform(1 + next(99)) : dense(() => next(65_536)));
        }
      }
    }
    for (let width = 0; width <= 2; ++width) {
      const out = new Uint16Array(apronVolume(width));
      const gaps = store.apron(key(5, -1, 0), width, 777, out);
      assert.equal(gaps, width === 0 ? missing & neighbourBit(0, 0, 0) : missing);
      let at = 0;
      for (let y = -width; y < 32 + width; ++y) {
        for (let z = -width; z < 32 + width; ++z) {
          for (let x = -width; x < 32 + width; ++x) {
            const expected = store.at(0, 5 * 32 + x, -32 + y, z) ?? 777;
            if (out[at++] !== expected) assert.fail(`voxel ${x}, ${y}, ${z} of width ${width}`);
          }
        }
      }
    }
  }
});

test('chunks unused for longest go first, and the newest stays', () => {
  const store = new ChunkStore(3 * 66_000);
  for (let i = 0; i < 3; ++i) store.put(key(i, 0, 0), dense(() => i));
  store.find(key(0, 0, 0));
  store.put(key(3, 0, 0), dense(() => 3));
  assert.deepEqual([0, 1, 2, 3].map((i) => store.has(key(i, 0, 0))), [true, false, true, true]);
  store.erase(key(0, 0, 0));
  store.erase(key(9, 9, 9));
  assert.equal(store.size, 2);
  store.clear();
  assert.equal(store.bytes, 0);
  const tiny = new ChunkStore(1);
  tiny.put(key(0, 0, 0), dense(() => 1));
  assert.equal(tiny.size, 1);
});

test('chunks of other sizes and aprons of other widths are refused', () => {
  const store = new ChunkStore(1 << 20);
  assert.throws(() => store.put(key(0, 0, 0), { uniform: null, voxels: new Uint16Array(5) }), { name: 'TalusError', kind: 'out_of_range' });
  assert.throws(() => store.apron(key(0, 0, 0), 3, 0, new Uint16Array(apronVolume(3))), { name: 'TalusError', kind: 'out_of_range' });
  assert.throws(() => store.apron(key(0, 0, 0), 1, 0, new Uint16Array(5)), { name: 'TalusError', kind: 'out_of_range' });
});
