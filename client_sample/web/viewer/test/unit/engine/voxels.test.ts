// What the page knows of voxels, and what a broken payload does to it: nothing more than that they are not known.
import { describe, expect, it } from 'vitest';
import { encodeChunk, hashVoxels } from 'talus';
import { Chunk, Column } from '../../../src/engine/stream/column.js';
import { decodeChunk } from '../../../src/engine/stream/decode.js';
import { Voxels } from '../../../src/engine/stream/voxels.js';
import { WorkerChunks } from '../../../src/engine/stream/worker_chunks.js';
import { Player } from '../../../src/controls/player.js';
import type { Engine } from '../../../src/engine/engine.js';

const voxels = new Uint16Array(32_768).map((_, i) => i % 3);
const payload = encodeChunk({ uniform: null, voxels });
const hash = hashVoxels({ uniform: null, voxels });
const OTHER = 'f'.repeat(32);

function chunkOf(content: { payload?: Uint8Array; hash?: string; material?: number }): Chunk {
  return Object.assign(new Chunk(new Column(0, 0, 0), 1), content);
}

describe('voxels for the page', () => {
  const voxelsWith = (chunk: Chunk) => new Voxels((x, y, z) => (x === 0 && y === 1 && z === 0 ? chunk : undefined));

  it('are those of the payload', () => {
    const page = voxelsWith(chunkOf({ payload, hash }));
    expect([0, 1, 2, 3].map((x) => page.atBlock(x, 32, 0, 64))).toEqual([0, 1, 2, 0]);
    expect(page.atBlock(0, 31, 0, 64)).toBeUndefined();
  });
  it('are not known where the payload does not decode, which is tried once', () => {
    let reads = 0;
    class Counted extends Uint8Array {
      override get length(): number {
        ++reads;
        return super.length;
      }
    }
    const page = voxelsWith(chunkOf({ payload: Counted.of(9, 9, 9) }));
    expect(page.atBlock(0, 32, 0, 64)).toBeUndefined();
    const before = reads;
    expect(before).toBeGreaterThan(0);
    expect(page.atBlock(1, 32, 0, 64)).toBeUndefined();
    expect(reads).toBe(before);
  });
  it('are not known where they have another hash', () => {
    expect(voxelsWith(chunkOf({ payload, hash: OTHER })).atBlock(0, 32, 0, 64)).toBeUndefined();
  });
  it('above the world as generated are what was built there, and air elsewhere', () => {
    const page = voxelsWith(chunkOf({ material: 5 }));
    expect([page.atBlock(3, 40, 3, 35), page.atBlock(3, 70, 3, 35), page.atBlock(40, 40, 3, 35)]).toEqual([5, 0, 0]);
  });
  it('in the workers are refused where they have another hash', () => {
    const chunks = new WorkerChunks(decodeChunk);
    const place = { lod: 0, x: 0, y: 0, z: 0 };
    chunks.add({ ...place, payload, material: null, hash });
    expect(chunks.centre(0, 0, 0, 0)).toEqual(voxels);
    chunks.add({ ...place, payload, material: null, hash: OTHER });
    expect(() => chunks.centre(0, 0, 0, 0)).toThrow(/hash/);
  });
});

describe('a player', () => {
  it('stands on what was built above the world, and not in what was dug beneath it', () => {
    const material = new Map([['0 70 0', 1], ['0 -5 0', 0]]);
    const engine = {
      world: { minY: 0, maxY: 64 },
      voxelAt: (x: number, y: number, z: number) => material.get(`${x} ${y} ${z}`) ?? (y >= 64 ? 0 : undefined),
      isSolid: (each: number) => each === 1,
      isLiquid: () => false,
    } as unknown as Engine;
    const player = new Player();
    player.enter(engine);
    const at = (y: number) => player.stuffAt(0, y, 0);
    expect([70, 71, 40, -5, -6].map(at)).toEqual(['solid', 'gas', 'unknown', 'gas', 'solid']);
  });
});
