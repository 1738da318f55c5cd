// Against a real talusd, by all three ways.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import WebSocket from 'ws';
import { ChunkStore, connect, decodeChunk, hashVoxels, ViewShape } from '../dist/node.js';
import { random } from './support/random.js';
import { startTalusd, talusd } from './support/talusd.js';

const options = { timeout: 120_000, skip: talusd === undefined && 'no talusd is built: build the target talusd, or set TALUSD' };
const WAYS = ['tcp', 'websocket', 'http'];
const name = ({ lod, x, y, z }) => `${lod}/${x}/${y}/${z}`;

let server;
before(async () => {
  if (talusd !== undefined) server = await startTalusd();
});
after(() => server?.stop('SIGTERM'));

function open(url, more = {}) {
  return connect({ url, WebSocket, reconnect: { firstDelayMs: 20, maxDelayMs: 200 }, ...more });
}

/** The next event, as a list of its arguments. Fails where the client ends first. */
function next(client, event) {
  return new Promise((resolve, reject) => {
    const done = (...values) => {
      client.off(event, done).off('closed', fail);
      resolve(values);
    };
    const fail = (error) => reject(error ?? new Error(`closed while waiting for ${event}`));
    client.on(event, done);
    if (event !== 'closed') client.on('closed', fail);
  });
}

/** What a client holds, kept as an application would. */
function hold(client) {
  const held = new Map();
  client.on('chunk', (chunk) => held.set(name(chunk.key), chunk));
  client.on('chunkLeft', (key) => assert(held.delete(name(key)), `${name(key)} left, which had not come`));
  return held;
}

const view = (world, more = {}) => ({
  centre: world.spawn,
  direction: { x: 1, y: 0, z: 0 },
  horizontalRadius: 3,
  verticalRadius: 3,
  ...more,
});

function assertWhole(held, wanted, world) {
  const names = [];
  new ViewShape({ horizon: false, ...wanted }, world).forEach((key) => names.push(name(key)));
  assert.deepEqual([...held.keys()].sort(), names.sort());
}

test('a View comes whole, and the same by TCP, WebSocket and HTTP', options, async () => {
  const hashes = {};
  for (const way of WAYS) {
    const client = open(server.urls[way]);
    const held = hold(client);
    const world = await client.ready();
    const wanted = view(world, { rings: [{ lod: 1, radius: 8 }, { lod: 2, radius: 16 }], horizon: true });
    client.setView(wanted);
    const [told] = await next(client, 'viewComplete');
    assert.deepEqual(told.centre, world.spawn);
    assertWhole(held, wanted, world);
    hashes[way] = Object.fromEntries(
      [...held].sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, chunk]) => {
        const voxels = decodeChunk(chunk.payload, { hash: chunk.hash }); // the server's hash
        if (chunk.material !== null) assert.equal(voxels.uniform, chunk.material);
        return [key, hashVoxels(voxels)];
      }),
    );
    assert.equal(client.stats.chunks, held.size);
    client.close();
  }
  assert.deepEqual(hashes.websocket, hashes.tcp);
  assert.deepEqual(hashes.http, hashes.tcp);
});

for (const way of WAYS) {
  test(`chunks come and leave as the View moves: ${way}`, options, async () => {
    const client = open(server.urls[way]);
    const held = hold(client);
    const world = await client.ready();
    const step = random(`a moving View by ${way}`);
    const at = { ...world.spawn };
    let wanted;
    for (let i = 0; i < 30; ++i) {
      at.x += step(200) - 100;
      at.z += step(200) - 100;
      wanted = view(world, { centre: { ...at }, horizontalRadius: 2 + step(3), verticalRadius: 2 });
      client.setView(wanted);
      if (step(2) === 0) await client.ping(); // while chunks come
    }
    wanted = view(world, { centre: { ...at }, horizontalRadius: 6, verticalRadius: 2 });
    client.setView(wanted);
    await next(client, 'viewComplete');
    assertWhole(held, wanted, world);
    client.setView(null);
    while (held.size > 0) await next(client, 'chunkLeft');
    client.close();
  });

  test(`talusd is killed and started again: ${way}`, options, async () => {
    let mortal = await startTalusd();
    const client = open(mortal.urls[way]);
    const held = hold(client);
    const world = await client.ready();
    client.setView(view(world));
    await next(client, 'viewComplete');
    const before = client.stats.chunks;
    const gone = next(client, 'disconnected');
    const back = next(client, 'connected');
    await mortal.stop('SIGKILL');
    if (way === 'http') client.ping().catch(() => {}); // HTTP notices when it asks for something
    const wanted = view(world, { horizontalRadius: 4 });
    client.setView(wanted);
    const [error, retryInMs] = await gone;
    assert(['disconnected', 'unreachable'].includes(error.kind), error.message);
    assert(retryInMs !== null);
    const asked = client.getChunk({ lod: 0, x: 0, y: 0, z: 0 }); // answered when it is back
    asked.catch(() => {});
    mortal = await startTalusd({ port: mortal.port, httpPort: mortal.httpPort });
    const [, sameWorld] = await back;
    assert(sameWorld);
    await next(client, 'viewComplete');
    assertWhole(held, wanted, world);
    assert.equal(client.stats.chunks, held.size, 'no chunk was given twice');
    assert(before < held.size);
    assert.deepEqual((await asked).key, { lod: 0, x: 0, y: 0, z: 0 });
    client.close();
    await mortal.stop('SIGTERM');
  });

  test(`single chunks and places: ${way}`, options, async () => {
    const client = open(server.urls[way]);
    const world = await client.ready();
    const key = { lod: 0, x: Math.floor(world.spawn.x / 32), y: 3, z: Math.floor(world.spawn.z / 32) };
    const chunk = await client.getChunk(key);
    assert.deepEqual(chunk.key, key);
    decodeChunk(chunk.payload, { hash: chunk.hash });
    await assert.rejects(client.getChunk({ lod: 9, x: 0, y: 0, z: 0 }), { kind: 'out_of_range' });
    const columns = Array.from({ length: 250 }, (_, i) => ({ x: 7 * i - 900, z: -5 * i }));
    const places = await client.getPlaces(columns, { looks: true, fields: ['height', 'moisture'] });
    assert.deepEqual([places.heightsFx.length, places.looks.length, places.values.length], [250, 250, 500]);
    const [{ x, z }] = columns;
    const one = await client.getPlaces([{ x, z }]);
    assert.deepEqual([one.heightsFx[0], one.looks, one.values], [places.heightsFx[0], null, null]);
    await assert.rejects(client.getPlaces(columns, { fields: ['nonsense'] }), { kind: 'out_of_range' });
    assert((await client.ping()) > 0);
    client.close();
    await assert.rejects(client.getChunk(key), { kind: 'closed' });
  });
}

test('heights agree with voxels', options, async () => {
  const client = open(server.urls.tcp);
  const store = new ChunkStore(64 << 20);
  client.on('chunk', (chunk) => store.put(chunk.key, decodeChunk(chunk.payload)));
  const world = await client.ready();
  client.setView(view(world, { horizontalRadius: 1, verticalRadius: 16 }));
  await next(client, 'viewComplete');
  const { x, y, z } = world.spawn;
  const solid = (material) => world.materials.find(({ id }) => id === material).phase === 'solid';
  assert.equal(store.at(0, x, y, z), 0, 'the feet of a player stand in air');
  const { heightsFx } = await client.getPlaces([{ x, z }]);
  const free = (heightsFx[0] + 127) >> 8;
  assert(solid(store.at(0, x, free - 1, z)) && !solid(store.at(0, x, free, z)));
  client.close();
});

test('a slow application is sent no more than its window', options, async () => {
  const windowBytes = 65_536;
  const client = open(server.urls.tcp, { windowBytes, manualCredit: true });
  const world = await client.ready();
  const owed = [];
  let whole = false;
  client.on('viewComplete', () => (whole = true));
  let held = true;
  client.on('chunk', (chunk) => (held ? owed.push(chunk) : client.taken(chunk)));
  client.setView(view(world, { horizontalRadius: 10, verticalRadius: 4 }));
  while (client.stats.chunkBytes < windowBytes) await next(client, 'chunk');
  for (let i = 0; i < 5; ++i) await client.ping();
  assert(client.stats.chunkBytes < windowBytes + 262_144);
  assert(!whole);
  held = false;
  for (const chunk of owed) client.taken(chunk);
  if (!whole) await next(client, 'viewComplete');
  assert(client.stats.chunkBytes > 2 * windowBytes);
  client.close();
});

test('a server that goes away says so, and is waited for', options, async () => {
  const mortal = await startTalusd();
  const client = open(mortal.urls.tcp);
  await client.ready();
  const gone = next(client, 'disconnected');
  await mortal.stop('SIGTERM');
  const [error, retryInMs] = await gone;
  assert.match(error.message, /goes away/);
  assert(retryInMs >= error.retryAfterMs);
  client.close();
});

test('of several servers the next is gone to with the View, and each chunk comes again', options, async () => {
  const mortal = await startTalusd();
  const client = open([mortal.urls.tcp, server.urls.tcp]);
  const held = hold(client);
  const world = await client.ready();
  client.setView(view(world));
  await next(client, 'viewComplete');
  const back = next(client, 'connected');
  const whole = next(client, 'viewComplete');
  const gone = next(client, 'disconnected');
  await mortal.stop('SIGTERM');
  const [error, retryInMs] = await gone;
  assert.match(error.message, /goes away/);
  assert(error.retryAfterMs >= 1_000);
  assert(retryInMs <= 20, 'the next server asked for no wait');
  const [, sameWorld] = await back;
  assert(sameWorld);
  await whole;
  assertWhole(held, view(world), world);
  assert((await client.ping()) > 0);
  assert.throws(() => open([]), { kind: 'unreachable' });
  assert.throws(() => open([server.urls.tcp, server.urls.websocket]), { kind: 'unreachable' });
  assert.throws(() => open([server.urls.http, server.urls.http]), { kind: 'unreachable' });
  client.close();
});

test('a wrong token is told at once, and not tried again', options, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'talus-js-'));
  after(() => rmSync(folder, { recursive: true }));
  const secret = 'a secret of thirty-two bytes, at least';
  writeFileSync(join(folder, 'secret'), secret, { mode: 0o600 });
  const guarded = await startTalusd({ env: { TALUS_ACCESS_SECRET_FILE: join(folder, 'secret') } });
  for (const way of WAYS) {
    const client = open(guarded.urls[way], { token: 'wrong' });
    await assert.rejects(client.ready(), { kind: 'refused' }, way);
    const welcome = open(guarded.urls[way], { token: secret });
    const world = await welcome.ready();
    welcome.setView(view(world, { horizontalRadius: 1 }));
    await next(welcome, 'viewComplete');
    welcome.close();
  }
  await guarded.stop('SIGTERM');
});

test('nobody there: told, and given up after the attempts of the policy', async () => {
  for (const url of ['tcp://127.0.0.1:1', 'ws://127.0.0.1:1', 'http://127.0.0.1:1']) {
    const client = open(url, { reconnect: { maxAttempts: 2, firstDelayMs: 1 } });
    let attempts = 0;
    client.on('disconnected', () => ++attempts);
    await assert.rejects(client.ready(), { kind: 'unreachable' });
    assert.equal(attempts, 3);
  }
});
