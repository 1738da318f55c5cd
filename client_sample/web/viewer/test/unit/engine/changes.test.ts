// What is packed for a worker arrives there in order, whole, and once.
import { expect, it } from 'vitest';
import { apply, ChangeList } from '../../../src/engine/stream/changes.js';

it('brings chunks and drops in their order', () => {
  const list = new ChangeList();
  const at = (x: number) => ({ lod: 2, x, y: -3, z: 40_000 });
  const said: unknown[] = [];
  const to = { add: (chunk: unknown) => said.push(chunk), drop: (chunk: unknown) => said.push(['drop', chunk]) };

  list.add({ ...at(-7), payload: Uint8Array.of(1, 2, 3), material: null, hash: 'a' });
  list.drop(at(-7));
  list.add({ ...at(8), payload: null, material: 65_535, hash: null });
  list.add({ ...at(9), payload: Uint8Array.of(4), material: null, hash: null });
  apply(list.take(), to);
  expect(said).toEqual([
    { ...at(-7), payload: Uint8Array.of(1, 2, 3), material: null, hash: 'a' },
    ['drop', at(-7)],
    { ...at(8), payload: null, material: 65_535, hash: null },
    { ...at(9), payload: Uint8Array.of(4), material: null, hash: null },
  ]);

  expect(list.isEmpty).toBe(true);
  said.length = 0;
  list.add({ ...at(0), payload: Uint8Array.of(9), material: null, hash: 'b' });
  apply(list.take(), to);
  expect(said).toEqual([{ ...at(0), payload: Uint8Array.of(9), material: null, hash: 'b' }]);
});
