// An array of rows does what a Map does.
import { expect, it } from 'vitest';
import { ByRow } from '../../../src/engine/stream/by_row.js';

it('holds what a Map holds, whatever comes and goes', () => {
  let state = 7;
  const next = (below: number) => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) % below;
  const rows = new ByRow<number>();
  const map = new Map<number, number>();
  for (let i = 0; i < 20_000; i++) {
    const y = next(40) - 20;
    if (next(2) === 0) {
      rows.set(y, i);
      map.set(y, i);
    } else {
      rows.delete(y);
      map.delete(y);
    }
    expect(rows.get(y)).toBe(map.get(y));
    expect(rows.size).toBe(map.size);
    if (i % 100 === 0) expect(rows.values()).toEqual([...map].sort(([a], [b]) => a - b).map(([, value]) => value));
    if (i % 1000 === 999) for (const at of [...map.keys()]) (map.delete(at), rows.delete(at));
  }
});
