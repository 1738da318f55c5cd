// What is packed for a worker arrives there in order, whole, and once.
import { expect, it } from 'vitest';
import { apply, ChangeList } from '../../../src/engine/stream/changes.js';

it('brings chunks and drops in their order', () => {
  const list = new ChangeList();
  const at = (x: number) => ({ lod: 2, x, y: -3, z: 40_000 });
  const said: unknown[] = [];
  const to = { add: (chunk: unknown) => said.push(chunk), drop: (chunk: unknown) => said.push(['drop', chunk]) };

  list.add({ ...at(-7), payload: Uint8Array.of(1, 2, 3), material: null });
  list.drop(at(-7));
  list.add({ ...at(8), payload: null, material: 65_535 });
  list.add({ ...at(9), payload: Uint8Array.of(4), material: null });
  apply(list.take(), to);
  expect(said).toEqual([
    { ...at(-7), payload: Uint8Array.of(1, 2, 3), material: null },
    ['drop', at(-7)],
    { ...at(8), payload: null, material: 65_535 },
    { ...at(9), payload: Uint8Array.of(4), material: null },
  ]);

  expect(list.isEmpty).toBe(true);
  said.length = 0;
  list.add({ ...at(0), payload: Uint8Array.of(9), material: null });
  apply(list.take(), to);
  expect(said).toEqual([{ ...at(0), payload: Uint8Array.of(9), material: null }]);
});
