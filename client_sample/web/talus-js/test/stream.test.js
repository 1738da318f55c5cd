// What a stream client takes and says, with a server whose every word the test says.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { TalusError } from '../dist/index.js';
import { uniformPayload } from '../dist/uniform.js';
import { catchMicrotasks } from './support/microtasks.js';
import { chunk, pong, script, unchanged, viewComplete, welcome } from './support/scripted.js';

const HASH = 'a'.repeat(32);
const at = (x) => ({ lod: 0, x, y: 0, z: 0 });
const solid = (x, more = {}) => chunk({ key: at(x), revision: 0, hash: HASH, payload: uniformPayload(1), ...more });
const view = (radius) => ({ centre: { x: 16, y: 16, z: 16 }, horizontalRadius: radius, verticalRadius: 0 });

/** Joined, and with that View sent. */
async function joined(t, radius, how) {
  const { client, accept } = script();
  t.after(() => client.close());
  client.setView(view(radius));
  const side = await accept(welcome(how));
  await side.next('View');
  return { client, side };
}

test('a handler that throws is no fault of the server, and holds up nothing', async (t) => {
  const thrown = catchMicrotasks(t);
  const { client, side } = await joined(t, 1);
  const chunks = [];
  client.on('chunk', ({ key }) => {
    throw key.x < 0 ? new Error('the application') : new TalusError('broken_protocol', 'also of the application');
  });
  client.on('chunk', ({ key }) => chunks.push(key.x));
  // In one piece, and the last begun.
  const bytes = Uint8Array.from([-1, 0, 1].flatMap((x) => [...solid(x)]));
  side.say(bytes.subarray(0, -9), bytes.subarray(-9));
  assert.deepEqual(chunks, [-1, 0, 1]);
  assert(client.connected);
  await null;
  assert.deepEqual(thrown.map(({ message }) => message), ['the application', 'also of the application', 'also of the application']);
});

test('what is on its way when the View is complete is not asked for again', async (t) => {
  const { client, side } = await joined(t, 0);
  side.say(unchanged({ key: at(0), revision: 3, hash: HASH }));
  const { id } = await side.next('GetChunks');
  const complete = new Promise((resolve) => client.on('viewComplete', () => resolve('complete')));
  side.say(viewComplete(1), solid(0, { id, revision: 3 }));
  assert.equal(await Promise.race([complete, side.next('GetChunks')]), 'complete');
});

test('one Ping at a time keeps a connection alive, and not each millisecond', async (t) => {
  const intervals = [];
  t.mock.method(globalThis, 'setInterval', (beat, milliseconds) => void intervals.push({ beat, milliseconds }));
  const { side } = await joined(t, 0, { idleTimeoutMs: 1 });
  assert.deepEqual(intervals.map(({ milliseconds }) => milliseconds), [5]);
  const [{ beat }] = intervals;
  beat();
  beat();
  assert.equal(side.pings, 1, 'the first is not answered');
  side.say(pong(1));
  beat();
  assert.equal(side.pings, 2);
});
