// Chunks come and go in any order; meshes follow, and nothing is left behind.
import { describe, expect, it } from 'vitest';
import type { ChunkMesh } from '../../../src/engine/mesh/mesher.js';
import type { Chunk, Drawable } from '../../../src/engine/stream/column.js';
import { Land } from '../../../src/engine/stream/land.js';
import type { Job } from '../../../src/engine/stream/messages.js';
import { hasColumn, ringsFor, shapeOf, type Shape } from '../../../src/engine/stream/shape.js';

const world = { minY: 0, maxY: 64 };
const shapeAt = (x: number, z: number): Shape =>
  shapeOf({ centre: { x, y: 32, z }, horizontalRadius: 2, verticalRadius: 1, rings: ringsFor(2, 200), horizon: true }, world);

function* chunksIn(shape: Shape): Generator<[number, number, number, number]> {
  for (const level of shape) {
    if (!level) continue;
    for (let z = level.z0; z <= level.z1; z++)
      for (let x = level.x0; x <= level.x1; x++)
        if (hasColumn(shape, level.lod, x, z)) for (let y = level.y0; y <= level.y1; y++) yield [level.lod, x, y, z];
  }
}

function random(seed: number): (below: number) => number {
  let s = seed;
  return (below) => {
    s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
    return Math.floor((s / 2 ** 32) * below);
  };
}

function stage(room = 4) {
  const slots = new Set<number>();
  const drawn = new Set<Drawable>();
  const sent = new Map<string, number>();
  const jobs: Job[] = [];
  let free = 0;
  const key = (c: { lod: number; x: number; y: number; z: number }) => `${c.lod} ${c.x} ${c.y} ${c.z}`;
  const meshes = {
    send: (chunk: Chunk) => void sent.set(key(chunk), 1),
    drop: (chunk: Chunk) => expect(sent.delete(key(chunk)), `dropped but not sent: ${key(chunk)}`).toBe(true),
    hasRoom: () => jobs.length < room,
    mesh: (chunk: Chunk, job: Job) => {
      expect(sent.has(key(chunk)), 'meshed but not sent').toBe(true);
      const level = land.shape[job.lod]!;
      for (let bit = 0; bit < 27; bit++) {
        const [x, y, z] = [job.x + (bit % 3) - 1, job.y + Math.floor(bit / 9) - 1, job.z + (Math.floor(bit / 3) % 3) - 1];
        const inView = bit !== 13 && hasColumn(land.shape, job.lod, x, z) && y >= level.y0 && y <= level.y1;
        if (inView) expect((job.known >>> bit) & 1, `without its neighbour ${bit}`).toBe(1);
      }
      jobs.push(job);
    },
  };
  const land: Land<Drawable> = new Land<Drawable>({
    drawer: {
      takeSlot: () => {
        slots.add(++free);
        return free;
      },
      freeSlot: (slot) => expect(slots.delete(slot), 'slot freed twice').toBe(true),
      add: (slot) => {
        const drawable = { slot, bottom: 0, top: 32 };
        drawn.add(drawable);
        return drawable;
      },
      remove: (drawable) => {
        expect(drawn.delete(drawable), 'mesh removed twice').toBe(true);
        slots.delete(drawable.slot);
      },
    },
    meshers: meshes,
    kindOf: (material) => (material === 0 ? 'gas' : 'solid'),
    now: () => 0,
    heights: () => {},
    arrivedToDrawn: () => {},
  });
  // A clock that stands would hold back the cover.
  let clock = 0;
  (land as unknown as { options: { now: () => number } }).options.now = () => (clock += 100);
  return { land, slots, drawn, sent, jobs };
}

const mesh = (): ChunkMesh => ({
  quads: new Uint32Array(2), counts: new Uint32Array(11), tops: new Uint8Array(1024).fill(8), liquidTops: null, low: 0, high: 8,
});

const camera = { x: 0, y: 40, z: 0 };

describe('Land', () => {
  for (const seed of [1, 2, 3, 4]) {
    it(`meshes each chunk with all of its neighbours in the View, and frees all in the end (seed ${seed})`, () => {
      const next = random(seed);
      const { land, slots, drawn, sent, jobs } = stage();
      let shape: Shape = [];
      let held = new Set<string>();
      const finish = (all: boolean) => {
        while (jobs.length > 0 && (all || next(2) === 0)) {
          const job = jobs.splice(next(jobs.length), 1)[0]!;
          land.meshed(job.id, mesh());
          if (all) land.update(camera);
        }
      };
      for (let move = 0; move < 5; move++) {
        shape = shapeAt(move * 40 - 60, move * 25);
        land.setShape(shape);
        const wanted = new Map([...chunksIn(shape)].map((c) => [c.join(' '), c]));
        for (const name of held) {
          if (!wanted.has(name)) land.leave(...(name.split(' ').map(Number) as [number, number, number, number]));
        }
        held = new Set([...held].filter((name) => wanted.has(name)));
        const missing = [...wanted.values()].filter((c) => !held.has(c.join(' ')));
        while (missing.length > 0) {
          const [lod, x, y, z] = missing.splice(next(missing.length), 1)[0]!;
          const uniform = next(4) === 0;
          land.add(lod, x, y, z, uniform ? null : Uint8Array.of(1), uniform ? next(2) : null);
          held.add(`${lod} ${x} ${y} ${z}`);
          land.update(camera);
          finish(false);
          // Sometimes the player moves on before all is here.
          if (move < 4 && next(400) === 0) break;
        }
      }
      for (let i = 0; i < 2000 && !land.settled; i++) {
        land.update(camera);
        finish(true);
      }
      expect(land.settled).toBe(true);
      expect(land.held).toBe(held.size);
      expect(land.nearestMissing(0, 0)).toBe(null);
      for (const column of land.values()) {
        expect(column.wanted || column.drawn).toBe(true);
        for (const chunk of column.chunks.values()) {
          if (chunk.left) continue;
          expect(chunk.meshedWith & chunk.known, `${chunk.lod} ${chunk.x} ${chunk.y} ${chunk.z}`).toBe(chunk.known);
        }
      }
      land.setShape([]);
      land.clear();
      expect([slots.size, drawn.size, sent.size, land.held, land.payloadBytes]).toEqual([0, 0, 0, 0, 0]);
    });
  }
});
