import { expect, it } from 'vitest';
import { Pool } from '../../../src/engine/stream/pool.js';

it('tells of a worker that ends, or does not start', () => {
  const workers: Worker[] = [];
  const told: string[] = [];
  const makeWorker = () => {
    const worker = {} as Worker;
    workers.push(worker);
    return worker;
  };
  new Pool(2, makeWorker, () => {}, (text) => told.push(text));
  workers[1]!.onerror!({ message: 'out of memory' } as ErrorEvent);
  workers[0]!.onerror!({} as ErrorEvent); // as of a script that cannot be loaded
  workers[0]!.onmessageerror!({} as MessageEvent);
  expect(told).toEqual(['out of memory', 'it did not start', 'a message that cannot be read']);
});
