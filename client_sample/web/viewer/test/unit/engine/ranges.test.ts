// Rows of a page are never given twice, and come back in one piece.
import { expect, it } from 'vitest';
import { Ranges } from '../../../src/engine/draw/ranges.js';

for (const seed of [1, 2, 3]) {
  it(`gives no row twice, and is whole again when all came back (seed ${seed})`, () => {
    let s = seed;
    const next = (below: number) => {
      s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
      return Math.floor((s / 2 ** 32) * below);
    };
    const ranges = new Ranges(256);
    const owner = new Int32Array(256);
    const taken: { first: number; count: number }[] = [];
    for (let i = 1; i < 3000; i++) {
      if (next(2) === 0) {
        const count = 1 + next(24);
        const first = ranges.take(count);
        if (first < 0) continue;
        expect(owner.subarray(first, first + count).every((o) => o === 0)).toBe(true);
        owner.fill(i, first, first + count);
        taken.push({ first, count });
      } else if (taken.length > 0) {
        const { first, count } = taken.splice(next(taken.length), 1)[0]!;
        owner.fill(0, first, first + count);
        ranges.give(first, count);
      }
      expect(ranges.freeRows).toBe(owner.filter((o) => o === 0).length);
    }
    for (const { first, count } of taken) ranges.give(first, count);
    expect(ranges.take(256)).toBe(0);
  });
}
