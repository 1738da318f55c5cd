// Every place of the View is drawn by one level at any time, whatever came first.
import { describe, expect, it } from 'vitest';
import { coverOf, nearestMissing, type CoverColumn } from '../../../src/engine/stream/cover.js';
import { columnKey } from '../../../src/engine/stream/keys.js';
import { chunksOf, hasColumn, ringsFor, shapeOf, type Shape } from '../../../src/engine/stream/shape.js';

class HeldChunks {
  readonly map = new Map<number, CoverColumn>();
  get = (lod: number, x: number, z: number) => this.map.get(columnKey(lod, x, z));
  values = () => this.map.values();
  put(lod: number, x: number, z: number, ready = true) {
    this.map.set(columnKey(lod, x, z), { lod, x, z, ready, begun: true });
  }
}

const world = { minY: 0, maxY: 832 };
const shapeAt = (x: number, z: number, radius = 3, horizon = 700): Shape =>
  shapeOf({ centre: { x, y: 416, z }, horizontalRadius: radius, verticalRadius: 13, rings: ringsFor(radius, horizon), horizon: true }, world);

function* columnsOf(shape: Shape): Generator<[number, number, number]> {
  for (const level of shape) {
    if (!level) continue;
    for (let z = level.z0; z <= level.z1; z++)
      for (let x = level.x0; x <= level.x1; x++) if (hasColumn(shape, level.lod, x, z)) yield [level.lod, x, z];
  }
}

/** Of each base column of chunks, how many drawn columns cover it. */
function times(drawn: Iterable<CoverColumn>): Map<string, number> {
  const count = new Map<string, number>();
  for (const { lod, x, z } of drawn) {
    const size = 2 ** lod;
    for (let dz = 0; dz < size; dz++)
      for (let dx = 0; dx < size; dx++) {
        const key = `${x * size + dx} ${z * size + dz}`;
        count.set(key, (count.get(key) ?? 0) + 1);
      }
  }
  return count;
}

function shuffled<T>(items: T[], seed: number): T[] {
  let s = seed;
  for (let i = items.length - 1; i > 0; i--) {
    s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
    const j = s % (i + 1);
    [items[i], items[j]] = [items[j]!, items[i]!];
  }
  return items;
}

describe('coverOf', () => {
  for (const seed of [1, 2, 3]) {
    it(`never draws a place twice, nor opens a hole where something was, while columns come in any order (seed ${seed})`, () => {
      const shape = shapeAt(seed * 1000, -seed * 777, 2, 200);
      const held = new HeldChunks();
      let before = new Set<string>();
      for (const [lod, x, z] of shuffled([...columnsOf(shape)], seed)) {
        held.put(lod, x, z);
        const covered = times(coverOf(shape, held));
        expect(Math.max(...covered.values())).toBe(1);
        expect([...before].filter((place) => !covered.has(place))).toEqual([]);
        before = new Set(covered.keys());
      }
    });
  }

  it('draws the whole square of the coarsest level in the end, and level 0 around the centre', () => {
    const shape = shapeAt(100, 100);
    const held = new HeldChunks();
    for (const [lod, x, z] of columnsOf(shape)) held.put(lod, x, z);
    const drawn = coverOf(shape, held);
    const top = shape.at(-1)!;
    expect(times(drawn).size).toBe((top.x1 - top.x0 + 1) * (top.z1 - top.z0 + 1) * 4 ** top.lod);
    const centre = Math.floor(100 / 32);
    for (let dz = -2; dz <= 2; dz++) for (let dx = -2; dx <= 2; dx++) expect(drawn.includes(held.get(0, centre + dx, centre + dz)!)).toBe(true);
    expect(nearestMissing(shape, held, 100, 100)).toBe(null);
  });

  it('keeps what was fine until the coarse that replaces it has come', () => {
    const here = shapeAt(0, 0);
    const held = new HeldChunks();
    for (const [lod, x, z] of columnsOf(here)) held.put(lod, x, z);
    const before = times(coverOf(here, held));
    const there = shapeAt(64 * 5, 0);
    // All that was held is still held; nothing new has come.
    const moved = times(coverOf(there, held));
    const top = there.at(-1)!;
    for (const place of before.keys()) {
      const [x, z] = place.split(' ').map(Number) as [number, number];
      const inside = x >> top.lod >= top.x0 && x >> top.lod <= top.x1 && z >> top.lod >= top.z0 && z >> top.lod <= top.z1;
      if (inside) expect(moved.get(place), place).toBe(1);
    }
    for (const [lod, x, z] of columnsOf(there)) held.put(lod, x, z);
    const after = coverOf(there, held);
    expect([...after].every(({ lod, x, z }) => hasColumn(there, lod, x, z))).toBe(true);
  });

  it('says how far away the nearest missing column is', () => {
    const shape = shapeAt(16, 16);
    const held = new HeldChunks();
    for (const [lod, x, z] of columnsOf(shape)) if (!(lod === 0 && x === 2 && z === 0)) held.put(lod, x, z);
    expect(nearestMissing(shape, held, 16, 16)).toBe(48);
  });
});

describe('the shape of a View', () => {
  it('has rings out to the horizon, each twice as far as the one before', () => {
    expect(ringsFor(12, 4096)).toEqual([1, 2, 3, 4].map((lod) => ({ lod, radius: [24, 48, 96, 128][lod - 1] })));
  });

  it('counts the chunks that talusd sends for it', () => {
    // As talusd counts a View of radius 1, one row up and down, and a ring of level 1 to 4, without a horizon:
    // level 0 has 27; the ring 5 x 5 columns, less those wholly inside level 0, in 2 rows.
    const shape = shapeOf({ centre: { x: 0, y: 0, z: 0 }, horizontalRadius: 1, verticalRadius: 1, rings: [{ lod: 1, radius: 4 }] }, world);
    expect(chunksOf(shape)).toBe(27 + (25 - 1) * 2);
  });
});
