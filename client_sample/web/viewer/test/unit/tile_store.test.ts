// Tiles of the map come in the end, whatever the server says meanwhile, and are asked for no oftener than it allows.
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { Server } from '../../src/connection/server';
import type { TileKey } from '../../src/map/projection';
import { TileStore } from '../../src/map/tile_store';

const row = (z: number, count: number): TileKey[] => Array.from({ length: count }, (_, x) => ({ zoom: 5, x, z }));
const BUSY = () => new Response('', { status: 503, headers: { 'Retry-After': '1' } });
let answer: () => Response;
let asked: number;
let store: TileStore;
let closed: number;

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  vi.stubGlobal('createImageBitmap', async () => ({ close: () => ++closed }));
  asked = closed = 0;
  const fetch = async () => (++asked, answer());
  store = new TileStore({ fetch } as unknown as Server, 'f', () => {});
});
afterEach(() => {
  store.dispose();
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

it('many that were refused on the way hold up none of those that are wanted', async () => {
  answer = BUSY;
  for (let z = 0; z < 5; ++z) {
    store.want(row(z, 50));
    await vi.advanceTimersByTimeAsync(900);
  }
  expect(asked).toBe(250);
  answer = () => new Response('png');
  store.want(row(9, 50));
  await vi.advanceTimersByTimeAsync(5_000);
  expect(store.missing).toBe(0);
  expect(asked).toBe(300); // each once
  expect(closed).toBe(0);
});

it('pictures that nobody looks at go, once there are many; never those that are wanted', async () => {
  answer = () => new Response('png');
  for (let z = 0; z < 6; ++z) {
    store.want(row(z, 50));
    await vi.advanceTimersByTimeAsync(100);
  }
  expect([asked, closed, store.missing]).toEqual([300, 100, 0]);
  expect([store.get(row(0, 1)[0]!), store.get(row(2, 1)[0]!) === null]).toEqual([null, false]);
  store.want(row(7, 250));
  await vi.advanceTimersByTimeAsync(1_000);
  expect([asked, store.missing]).toEqual([550, 0]);
});

it('no server makes a tile wait for longer than a minute', async () => {
  answer = () => new Response('', { status: 503, headers: { 'Retry-After': '4294967' } });
  store.want(row(0, 1));
  await vi.advanceTimersByTimeAsync(59_000);
  expect(asked).toBe(1);
  answer = () => new Response('png');
  await vi.advanceTimersByTimeAsync(2_000);
  expect([asked, store.missing]).toEqual([2, 0]);
});
