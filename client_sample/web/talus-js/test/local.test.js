// Worlds made by workers, and sources of their chunks.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { decodeChunk } from '../dist/decode.js';
import { ViewShape } from '../dist/index.js';
import { source, World } from '../dist/local/index.js';
import { World as Module } from '../wasm/world.js';

const spec = (name) => readFileSync(new URL(`../../../../core/worlds/${name}.toml`, import.meta.url), 'utf8');
const nameOf = ({ lod, x, y, z }) => `${lod}/${x}/${y}/${z}`;
const VIEW = { centre: { x: 10, y: 70, z: -20 }, horizontalRadius: 2, verticalRadius: 2, rings: [{ lod: 1, radius: 5 }, { lod: 3, radius: 12 }], horizon: true };

async function openWorld(t, name = 'classic', options = {}) {
  const world = await World.open(spec(name), options);
  t.after(() => world.close());
  return world;
}

/** A source whose View is whole: { client, chunks } with the newest chunk of each key. */
async function openSource(t, world, options) {
  const client = source(world, options);
  t.after(() => client.close());
  const chunks = new Map();
  const errors = [];
  client.on('chunk', (chunk) => chunks.set(nameOf(chunk.key), chunk));
  client.on('chunkLeft', (key) => chunks.delete(nameOf(key)));
  client.on('error', (error) => errors.push(error));
  client.setView(VIEW);
  await next(client, 'viewComplete');
  return { client, chunks, errors };
}

const next = (client, event) =>
  new Promise((resolve) => {
    const handler = (...args) => {
      client.off(event, handler);
      resolve(args);
    };
    client.on(event, handler);
  });

/** Resolves when a chunk comes that satisfies `test`. */
const chunkWhere = (client, test) =>
  new Promise((resolve) => {
    const handler = (chunk) => {
      if (!test(chunk)) return;
      client.off('chunk', handler);
      resolve(chunk);
    };
    client.on('chunk', handler);
  });

const voxelOf = (chunk, { x, y, z }) => {
  const { voxels, uniform } = decodeChunk(chunk.payload);
  return voxels?.[((y & 31) * 32 + (z & 31)) * 32 + (x & 31)] ?? uniform;
};

/** A store in memory, which several sources share. */
class Store {
  revision = 0;
  rows = [];
  handlers = new Map();
  full = false;

  of(name) {
    return {
      load: async (since) => ({ revision: this.revision, rows: this.rows.filter(({ revision }) => revision > since) }),
      save: async (before, rows) => {
        if (this.full) throw new Error('the disk is full');
        if (before !== this.revision) return false;
        ++this.revision;
        const same = (a, b) => a.x === b.x && a.y === b.y && a.z === b.z;
        this.rows = [...this.rows.filter((old) => !rows.some((row) => same(row, old))), ...rows.map((row) => ({ ...row, revision: this.revision }))];
        for (const [other, handler] of this.handlers) if (other !== name) handler();
        return true;
      },
      watch: (handler) => void this.handlers.set(name, handler),
      close: () => void this.handlers.delete(name),
    };
  }
}

test('workers make the same voxels as one instance, in whatever order', async (t) => {
  const [world, alone] = await Promise.all([openWorld(t, 'default', { workers: 3 }), Module.open(spec('default'))]);
  assert.deepEqual([world.fingerprint, world.workers, world.instructionSet], [alone.fingerprint, 3, 'wasm128']);
  const keys = [0, 1, 2, 3].flatMap((lod) => [-9, 0, 7].flatMap((x) => [-1, 0, 1, 2].map((y) => ({ lod, x, y, z: 3 - x }))));
  const made = await Promise.all(keys.map((key) => world.generate(key, { hash: true, payload: true })));
  keys.forEach((key, i) => assert.deepEqual(made[i], alone.generate(key, { voxels: true, hash: true, payload: true }), nameOf(key)));
  assert.deepEqual(await world.spawn(), alone.spawn());
  await world.useWorkers(1);
  assert.equal(world.workers, 1);
  assert.equal((await world.map({ zoom: 12, x: 0, z: 0 })).length, 256 * 256 * 3);
});

test('what is aborted is not made, and what is wrong is refused', async (t) => {
  const world = await openWorld(t);
  const abort = new AbortController();
  const waiting = Array.from({ length: 50 }, (_, x) => world.generate({ lod: 0, x: x * 8, y: 2, z: 0 }, { signal: abort.signal }));
  abort.abort();
  const ends = await Promise.allSettled(waiting);
  assert.ok(ends.every(({ status, reason }) => status === 'rejected' && reason.name === 'AbortError'));
  await assert.rejects(world.generate({ lod: 0, x: 0, y: 0, z: 0 }, { signal: abort.signal }), { name: 'AbortError' });
  await assert.rejects(world.generate({ lod: 9, x: 0, y: 0, z: 0 }), { kind: 'out_of_range' });
  await assert.rejects(World.open('seed = 1\nresolution = = 2\n'), { name: 'WorldError', kind: 'spec', line: 2 });
  await assert.rejects(World.open(spec('classic'), { workers: 0 }), { kind: 'range' });
  world.close();
  await assert.rejects(world.generate({ lod: 0, x: 0, y: 0, z: 0 }), { kind: 'closed' });
});

test('a source gives all chunks of a View once, nearest first, and follows it', async (t) => {
  const [world, alone] = await Promise.all([openWorld(t, 'classic', { workers: 2 }), Module.open(spec('classic'))]);
  const order = [];
  const client = source(world);
  t.after(() => client.close());
  client.on('chunk', ({ key }) => order.push(key));
  client.setView(VIEW);
  const facts = await client.ready();
  assert.equal(facts.fingerprint, alone.fingerprint);
  await next(client, 'viewComplete');
  const shape = new ViewShape(VIEW, facts);
  assert.equal(order.length, shape.count);
  assert.equal(new Set(order.map(nameOf)).size, shape.count);
  assert.equal(order[0].lod, 0);

  const { chunks } = await openSource(t, world);
  for (const chunk of chunks.values()) {
    const { voxels, uniform } = alone.generate(chunk.key);
    assert.deepEqual(decodeChunk(chunk.payload), { voxels, uniform }, nameOf(chunk.key));
    assert.equal(chunk.revision, 0n);
  }

  const moved = { ...VIEW, centre: { x: 10 + 64, y: 70 + 32, z: -20 } };
  let left = 0;
  client.on('chunkLeft', () => ++left);
  order.length = 0;
  client.setView(moved);
  await next(client, 'viewComplete');
  const after = new ViewShape(moved, facts);
  assert.equal(order.length - left, after.count - shape.count);
  assert.ok(order.length > 0 && order.length < after.count && order.every((key) => after.covers(key) && !shape.covers(key)));
});

test('edits change chunks at every level, whole or not at all, and undo', async (t) => {
  const world = await openWorld(t, 'classic', { workers: 2 });
  const { client, chunks } = await openSource(t, world);
  const voxel = { x: 8, y: 68, z: -24 };
  const before = voxelOf(chunks.get('0/0/2/-1'), voxel);
  const material = before === 2 ? 3 : 2;
  const came = chunkWhere(client, ({ key }) => nameOf(key) === '0/0/2/-1');
  const done = await client.edit({ guards: [{ voxel, material: before }], fills: [{ first: voxel, last: { x: 12, y: 76, z: -20 }, material }] });
  assert.deepEqual([done.revision, done.changed > 0], [1n, true]);
  const chunk = await came;
  assert.deepEqual([voxelOf(chunk, voxel), chunk.revision], [material, 1n]);
  await assert.rejects(client.edit({ guards: [{ voxel, material: before }], writes: [{ voxel, material: 0 }] }), { name: 'TalusError', kind: 'conflict' });
  await assert.rejects(client.edit({ writes: [{ voxel, material: 999 }] }), { kind: 'out_of_range' });
  const coarse = await client.getChunk({ lod: 3, x: 0, y: 0, z: -1 });
  assert.equal(coarse.revision, 1n, 'voxel 8, 68, -24 is a sample of level 3');
  // A worker that comes later has the edits, too.
  await world.useWorkers(4);
  const again = await Promise.all(Array.from({ length: 8 }, () => world.generate({ lod: 0, x: 0, y: 2, z: -1 })));
  for (const { voxels } of again) assert.equal(voxels[((68 & 31) * 32 + (-24 & 31)) * 32 + 8], material);

  const pasted = { uniform: null, voxels: new Uint16Array(32768).fill(0) };
  pasted.voxels[5] = 4;
  await client.edit({ paste: { origin: { x: 0, y: 200, z: 0 }, voxels: pasted } });
  assert.equal(voxelOf(await client.getChunk({ lod: 0, x: 0, y: 6, z: 0 }), { x: 5, y: 200, z: 0 }), 4);
});

test('chunks that are made while an edit happens have it', async (t) => {
  const world = await openWorld(t, 'classic', { workers: 3 });
  const client = source(world);
  t.after(() => client.close());
  const chunks = new Map();
  client.on('chunk', (chunk) => chunks.set(nameOf(chunk.key), chunk));
  await client.ready();
  for (let round = 0; round < 8; ++round) {
    const at = { x: round * 512, y: 70, z: 0 };
    client.setView({ centre: at, horizontalRadius: 3, verticalRadius: 1 });
    const whole = next(client, 'viewComplete');
    // All over the View, in one edit, while its chunks are made.
    const writes = [-2, -1, 0, 1, 2].flatMap((x) => [-2, -1, 0, 1, 2].map((z) => ({ voxel: { x: at.x + x * 32, y: 70, z: z * 32 }, material: 2 })));
    const came = new Set();
    const all = new Promise((resolve) => {
      client.on('chunk', (chunk) => {
        if (chunk.revision === BigInt(round + 1) && came.add(nameOf(chunk.key)).size === writes.length) resolve();
      });
    });
    await Promise.all([client.edit({ writes }), whole, all]);
    for (const { voxel } of writes) assert.equal(voxelOf(chunks.get(`0/${voxel.x >> 5}/2/${voxel.z >> 5}`), voxel), 2, `${voxel.x}, ${voxel.z}`);
  }
});

test('edits are kept, and several sources see each other\'s', async (t) => {
  const store = new Store();
  const [one, other] = await Promise.all([openWorld(t), openWorld(t, 'classic', { workers: 2 })]);
  const a = await openSource(t, one, { store: store.of('a') });
  const b = await openSource(t, other, { store: Promise.resolve(store.of('b')) });
  const voxel = { x: 3, y: 70, z: -3 };
  const seen = chunkWhere(b.client, ({ key, revision }) => nameOf(key) === '0/0/2/-1' && revision === 1n);
  await a.client.edit({ writes: [{ voxel, material: 2 }] });
  assert.equal(voxelOf(await seen, voxel), 2);
  // At once: both happen, and neither is lost.
  const near = { x: 4, y: 70, z: -3 };
  await Promise.all([a.client.edit({ writes: [{ voxel: near, material: 3 }] }), b.client.edit({ writes: [{ voxel: { ...near, x: 5 }, material: 4 }] })]);
  const third = await openSource(t, await openWorld(t), { store: store.of('c') });
  const chunk = third.chunks.get('0/0/2/-1');
  assert.deepEqual([3, 4, 5].map((x) => voxelOf(chunk, { ...voxel, x })), [2, 3, 4]);
  assert.equal(chunk.revision, 3n);
});

test('a store that fails is reported once, and edits go on', async (t) => {
  const store = new Store();
  store.full = true;
  const { client, errors } = await openSource(t, await openWorld(t), { store: store.of('a') });
  await client.edit({ writes: [{ voxel: { x: 3, y: 70, z: -3 }, material: 2 }] });
  await client.edit({ writes: [{ voxel: { x: 4, y: 70, z: -3 }, material: 2 }] });
  assert.deepEqual(errors.map(({ kind, message }) => [kind, message]), [['not_kept', 'edits last until the page is closed: the disk is full']]);
  assert.equal(voxelOf(await client.getChunk({ lod: 0, x: 0, y: 2, z: -1 }), { x: 4, y: 70, z: -3 }), 2);
  const denied = await openSource(t, await openWorld(t), { store: Promise.reject(new Error('denied')) });
  assert.match(denied.errors[0].message, /denied/);
});

test('what no edit could have left is refused', async (t) => {
  const world = await openWorld(t);
  await assert.rejects(world.restore([{ x: 0, y: 0, z: 0, runs: Uint8Array.of(1, 2, 3) }]), { kind: 'range' });
  assert.deepEqual(await world.restore([{ x: 0, y: 0, z: 0, runs: Uint8Array.of(0, 0) }]), []);
});

test('with fewer workers, and more again, no chunk is lost', async (t) => {
  const world = await openWorld(t, 'classic', { workers: 3 });
  const client = source(world);
  t.after(() => client.close());
  const seen = new Set();
  const errors = [];
  client.on('error', (error) => errors.push(error));
  client.on('chunk', ({ key }) => {
    seen.add(nameOf(key));
    // Opening workers that are not needed any more are let go as well.
    if (seen.size % 64 === 0) void Promise.all([world.useWorkers(3), world.useWorkers(1)]).catch((error) => errors.push(error));
  });
  client.setView(VIEW);
  await next(client, 'viewComplete');
  assert.equal(seen.size, new ViewShape(VIEW, client.world).count);
  const asked = Promise.all(Array.from({ length: 6 }, (_, x) => world.generate({ lod: 0, x: x * 8, y: 2, z: 40 })));
  await world.useWorkers(3);
  await world.useWorkers(1);
  assert.equal((await asked).length, 6);
  assert.deepEqual(errors, []);
});

test('workers without memory are reported once, and to every View', async (t) => {
  const world = await openWorld(t, 'default', { memoryBytes: 8 << 20, groundBytes: 0 });
  const client = source(world);
  t.after(() => client.close());
  const errors = [];
  client.on('error', (error) => errors.push(error));
  client.on('viewComplete', () => assert.fail('it has holes'));
  const view = { centre: { x: 0, y: 70, z: 0 }, horizontalRadius: 10, verticalRadius: 2, rings: [{ lod: 2, radius: 16 }, { lod: 5, radius: 40 }] };
  client.setView(view);
  await next(client, 'error');
  await assert.rejects(world.generate({ lod: 0, x: 0, y: 0, z: 0 }), { kind: 'out_of_memory' });
  assert.deepEqual(errors.map(({ kind }) => kind), ['server_failed']);
  const again = next(client, 'error');
  client.setView({ ...view, horizontalRadius: 9 });
  await again;
});

test('an edit that another page made void leaves no trace', async (t) => {
  const guard = { x: 70, y: 70, z: 70 };
  const voxel = { x: 3, y: 70, z: -3 };
  const { rows } = await (await openWorld(t)).edit({ writes: [{ voxel: guard, material: 4 }] });
  let client;
  let taken = false;
  const store = {
    load: async () => (taken ? { revision: 1, rows } : { revision: 0, rows: [] }),
    save: async () => {
      taken = true;
      client.setView(VIEW); // its chunks are made with the edit
      await next(client, 'viewComplete');
      return false;
    },
    close() {},
  };
  client = source(await openWorld(t), { store });
  t.after(() => client.close());
  const shown = [];
  client.on('chunk', (chunk) => nameOf(chunk.key) === '0/0/2/-1' && shown.push(voxelOf(chunk, voxel)));
  await client.ready();
  const before = voxelOf(await client.getChunk({ lod: 0, x: 0, y: 2, z: -1 }), voxel);
  const material = before === 2 ? 3 : 2;
  const air = voxelOf(await client.getChunk({ lod: 0, x: 2, y: 2, z: 2 }), guard);
  const back = chunkWhere(client, (chunk) => nameOf(chunk.key) === '0/0/2/-1' && voxelOf(chunk, voxel) === before);
  await assert.rejects(client.edit({ guards: [{ voxel: guard, material: air }], writes: [{ voxel, material }] }), { kind: 'conflict' });
  await back;
  assert.deepEqual(shown, [material, before]);
});
