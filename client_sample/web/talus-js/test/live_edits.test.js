// Edits against a real talusd with a directory for data.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import WebSocket from 'ws';
import { connect, decodeChunk, hashVoxels } from '../dist/node.js';
import { random } from './support/random.js';
import { startTalusd, talusd } from './support/talusd.js';

const options = { timeout: 120_000, skip: talusd === undefined && 'no talusd is built: build the target talusd, or set TALUSD' };
const env = { TALUS_ACCESS_WITHOUT_TOKEN: 'read,edit' };

/** A talusd on a directory of its own, and again(): the next on the same directory and ports. */
async function start(t) {
  const data = mkdtempSync(join(tmpdir(), 'talus-js-edits-'));
  const args = ['--data', data];
  let server = await startTalusd({ args, env });
  t.after(async () => {
    await server.stop();
    rmSync(data, { recursive: true, force: true });
  });
  return {
    urls: server.urls,
    kill: () => server.stop('SIGKILL'),
    again: async () => (server = await startTalusd({ port: server.port, httpPort: server.httpPort, args, env })),
  };
}

function open(t, url, more = {}) {
  const client = connect({ url, WebSocket, reconnect: { firstDelayMs: 20, maxDelayMs: 100 }, ...more });
  t.after(() => client.close());
  return client;
}

const chunkOf = ({ x, y, z }) => ({ lod: 0, x: Math.floor(x / 32), y: Math.floor(y / 32), z: Math.floor(z / 32) });
const sameKey = (a, b) => a.lod === b.lod && a.x === b.x && a.y === b.y && a.z === b.z;
function materialAt(chunk, { x, y, z }) {
  const { uniform, voxels } = decodeChunk(chunk.payload, { hash: chunk.hash });
  const within = (at) => ((at % 32) + 32) % 32;
  return voxels === null ? uniform : voxels[(within(y) * 32 + within(z)) * 32 + within(x)];
}
const look = async (client, voxel) => materialAt(await client.getChunk(chunkOf(voxel)), voxel);

/** In a View around `voxel`: resolves with the chunk of `voxel` once its revision is at least `revision()`. */
function watch(client, voxel) {
  const key = chunkOf(voxel);
  let newest = null;
  let waiting = () => {};
  client.on('chunk', (chunk) => {
    if (!sameKey(chunk.key, key)) return;
    newest = chunk;
    waiting();
  });
  client.setView({ centre: voxel, horizontalRadius: 1, verticalRadius: 1, rings: [{ lod: 1, radius: 4 }] });
  return async (revision) => {
    while (newest === null || newest.revision < revision) await new Promise((resolve) => (waiting = resolve));
    return newest;
  };
}

test('random edits of one client come to another, by TCP and WebSocket, and are the server\'s voxels', options, async (t) => {
  const server = await start(t);
  const [one, two] = [open(t, server.urls.tcp), open(t, server.urls.websocket)];
  const world = await one.ready();
  assert.equal(world.protocol, 2);
  await two.ready();
  assert((await one.editLimits()).voxels > 0);
  const centre = world.spawn;
  const seen = [watch(one, centre), watch(two, centre)];
  await Promise.all(seen.map((each) => each(0n)));
  const next = random('edits to be seen');
  const materials = world.materials.map(({ id }) => id);
  const low = { x: chunkOf(centre).x * 32, y: chunkOf(centre).y * 32, z: chunkOf(centre).z * 32 };
  const voxel = () => ({ x: low.x + next(32), y: low.y + next(32), z: low.z + next(32) });
  let last = 0n;
  for (let round = 0; round < 60; ++round) {
    const material = materials[next(materials.length)];
    const first = voxel();
    const far = { x: Math.min(low.x + 31, first.x + next(6)), y: Math.min(low.y + 31, first.y + next(6)), z: Math.min(low.z + 31, first.z + next(6)) };
    const edit = [
      () => ({ writes: [{ voxel: first, material }, { voxel: voxel(), material }] }),
      () => ({ fills: [{ first, last: far, material }] }),
      () => ({ fills: [{ first, last: far, material: 'generated' }] }),
      () => ({ fills: [{ first, last: far, material, only: 0 }] }),
    ][next(4)]();
    const { revision, changed } = await one.edit(edit);
    if (changed > 0) last = revision;
  }
  const hashes = await Promise.all(seen.map(async (each) => hashVoxels(decodeChunk((await each(last)).payload))));
  const served = await two.getChunk(chunkOf(centre));
  assert.equal(served.revision, last);
  assert.deepEqual(hashes, [served.hash, served.hash]);
});

test('a pasted chunk is what was pasted, and guards hold', options, async (t) => {
  const server = await start(t);
  const client = open(t, server.urls.tcp);
  const { spawn, materials } = await client.ready();
  const key = chunkOf(spawn);
  const origin = { x: key.x * 32, y: (key.y + 3) * 32, z: key.z * 32 };
  const next = random('a pasted chunk');
  const voxels = new Uint16Array(32_768);
  for (let at = 0; at < voxels.length; ) {
    const end = at + 1 + next(90);
    voxels.fill(materials[next(materials.length)].id, at, end);
    at = end;
  }
  const { changed } = await client.edit({ paste: { origin, voxels: { uniform: null, voxels }, withAir: true } });
  assert(changed > 1_000);
  assert.equal((await client.getChunk(chunkOf(origin))).hash, hashVoxels({ uniform: null, voxels }));
  const guard = { voxel: origin, material: voxels[0] + 1 };
  await assert.rejects(client.edit({ guards: [guard], writes: [{ voxel: origin, material: 0 }] }), { kind: 'conflict' });
  assert.equal(await look(client, origin), voxels[0]);
});

test('a thing that is handed on from voxel to voxel is never lost nor twice there, though talusd is killed', options, async (t) => {
  const server = await start(t);
  const client = open(t, server.urls.websocket);
  const { spawn, materials } = await client.ready();
  const thing = materials.at(-1).id;
  const STEPS = 400;
  const voxel = (i) => ({ x: spawn.x + i, y: spawn.y + 90, z: spawn.z });
  await client.edit({ writes: [{ voxel: voxel(0), material: thing }] });
  let answered = 0;
  let killed;
  // Each takes what the one before put: one that is done twice, or left out, is a conflict.
  const steps = Array.from({ length: STEPS }, (_, i) =>
    client
      .edit({
        guards: [{ voxel: voxel(i), material: thing }, { voxel: voxel(i + 1), material: 0 }],
        writes: [{ voxel: voxel(i), material: 0 }, { voxel: voxel(i + 1), material: thing }],
      })
      .then((done) => {
        assert.equal(done.changed, 2);
        if (++answered === 100 || answered === 250) killed = server.kill().then(server.again);
      }),
  );
  await Promise.all(steps);
  await killed;
  assert.equal(client.stats.connections >= 2, true);
  assert.equal(await look(client, voxel(STEPS)), thing);
  for (const i of [0, 1, 99, 100, 101, 250, STEPS - 1]) assert.equal(await look(client, voxel(i)), 0);
});

test('a token without the right, and a server that stores nothing', options, async (t) => {
  const data = mkdtempSync(join(tmpdir(), 'talus-js-edits-'));
  t.after(() => rmSync(data, { recursive: true, force: true }));
  for (const [more, words] of [[{ args: ['--data', data] }, /right|edit/], [{ env }, /stores no edits/]]) {
    const server = await startTalusd(more);
    t.after(() => server.stop());
    const client = open(t, server.urls.tcp);
    await client.ready();
    await assert.rejects(client.editLimits(), { kind: 'refused', message: words });
    await assert.rejects(client.edit({ writes: [] }), { kind: 'refused', message: words });
  }
});

test('edits come by HTTP too, as the voxels that a stream has', options, async (t) => {
  const server = await start(t);
  const [editor, reader] = [open(t, server.urls.tcp), open(t, server.urls.http, { editsIntervalMs: 20 })];
  const { spawn, materials } = await editor.ready();
  const voxel = { x: spawn.x, y: spawn.y + 40, z: spawn.z };
  const key = chunkOf(voxel);
  const material = materials.at(-1).id;
  await reader.ready();
  const seen = watch(reader, voxel);
  assert.equal((await seen(0n)).revision, 0n);
  assert.equal((await reader.getChunk(key)).revision, 0n);
  for (let round = 1n; round <= 5n; ++round) {
    const writes = [{ voxel: { ...voxel, x: voxel.x - (voxel.x & 31) + Number(round) }, material }];
    assert.equal((await editor.edit({ writes })).revision, round);
    const chunk = await seen(round);
    assert.equal(materialAt(chunk, writes[0].voxel), material);
    const [served, byStream] = [await reader.getChunk(key), await editor.getChunk(key)];
    assert.equal(served.revision, round);
    assert.equal(hashVoxels(decodeChunk(served.payload)), byStream.hash);
    assert.equal(hashVoxels(decodeChunk(chunk.payload)), byStream.hash);
  }
  // Another server on the same directory goes on with the same store.
  await server.kill();
  await server.again();
  const last = { ...voxel, x: voxel.x - (voxel.x & 31) + 20 };
  assert.equal((await editor.edit({ writes: [{ voxel: last, material }] })).revision, 6n);
  assert.equal(materialAt(await seen(6n), last), material);
});
