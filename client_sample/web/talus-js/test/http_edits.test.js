// Land with edits by HTTP, against a server that a test writes down.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { connect, decodeChunk, encodeChunk, TalusError } from '../dist/index.js';
import { EditedColumns, regionOf, revisionOf, revisionOfPath } from '../dist/http/edits.js';
import { catchMicrotasks } from './support/microtasks.js';

const FINGERPRINT = '1'.repeat(32);
const STORE = '2'.repeat(32);
const BASE = `/v1/${FINGERPRINT}/4/0`;
const EDITED = `/v1/${FINGERPRINT}/${STORE}/4/0`;
const EDITS = `/v1/${FINGERPRINT}/${STORE}/edits/0`;
const rates = { chunks_per_second: 0, bytes_per_second: 0, requests_per_second: 0, burst_ms: 1000 };
const world = (storeId, worldFile) => ({
  server: 'test', fingerprint: FINGERPRINT, store_id: storeId, codec: 4, chunk_size: 32, levels: 7, min_y: 0, max_y: 64,
  spawn: [0, 40, 0], materials: [{ id: 0, name: 'air', colour: '#000000', phase: 'gas' }], looks: [], fields: [],
  limits: { heights_per_request: 10, view_horizontal_radius: 9, view_vertical_radius: 9, view_chunks: 9999, square_edge: 4, session: rates, address: rates },
  edits: { taken: true, revision: '0' },
  world_file: worldFile,
});

const uniform = (material) => encodeChunk({ uniform: material, voxels: null });
/** A chunk with one voxel of that material in stone. */
function marked(material) {
  const voxels = new Uint16Array(32_768).fill(3);
  voxels[77] = material;
  return encodeChunk({ uniform: null, voxels });
}

/** Of the payloads of rows 0 and 1, stone below and air above. */
function column(zero, one) {
  const runs = [[-(2 ** 31), 2 ** 31, uniform(3)], [0, 1, zero], [1, 1, one], [2, 2 ** 31 - 2, uniform(0)]];
  const body = new Uint8Array(4 + runs.reduce((sum, [, , payload]) => sum + 12 + payload.length, 0));
  const data = new DataView(body.buffer);
  data.setUint8(0, 1);
  data.setUint16(2, runs.length, true);
  let at = 4;
  for (const [first, count, payload] of runs) {
    data.setInt32(at, first, true);
    data.setUint32(at + 4, count, true);
    data.setUint32(at + 8, payload.length, true);
    body.set(payload, at + 12);
    at += 12 + payload.length;
  }
  return body;
}

/** [x, z, revision] each. */
function edits(...columns) {
  const body = new Uint8Array(4 + 10 * columns.length);
  const data = new DataView(body.buffer);
  data.setUint8(0, 1);
  data.setUint16(2, columns.length, true);
  columns.forEach(([x, z, revision], i) => {
    data.setUint16(4 + 10 * i, (z & 31) * 32 + (x & 31), true);
    data.setBigUint64(6 + 10 * i, BigInt(revision), true);
  });
  return body;
}

/**
 * `answers` by path: bytes, or a path to which it redirects; a column otherwise. `revisions` by path: what Talus-Revision
 * says of it.
 */
function serve(t, { storeId = STORE, interval = Infinity, answers = new Map(), revisions = new Map(), worldFile = '', ...options } = {}) {
  const asked = [];
  const fetch = async (url) => {
    let path = new URL(url).pathname;
    asked.push(path);
    while (typeof answers.get(path) === 'string') path = answers.get(path);
    const body =
      path === '/v1/world'
        ? new TextEncoder().encode(JSON.stringify(world(storeId, worldFile)))
        : (answers.get(path) ?? (path.includes('/edits/') ? edits() : column(marked(5), marked(6))));
    const response = new Response(body, revisions.has(path) ? { headers: { 'Talus-Revision': revisions.get(path) } } : {});
    Object.defineProperty(response, 'url', { value: `http://server${path}` });
    return response;
  };
  const client = connect({ url: 'http://server', fetch, editsIntervalMs: interval, ...options });
  t.after(() => client.close());
  const chunks = [];
  let wake = () => {};
  client.on('chunk', (chunk) => (chunks.push(chunk), wake()));
  return {
    client,
    asked,
    answers,
    chunks,
    /** The chunks that came since, once there are so many. */
    async taken(count) {
      while (chunks.length < count) await new Promise((resolve) => (wake = resolve));
      return chunks.splice(0);
    },
    /** The View of the one column (x, z), both rows. */
    async look(x, z) {
      await client.ready();
      const complete = new Promise((resolve) => client.on('viewComplete', resolve));
      client.setView({ centre: { x: 32 * x, y: 40, z: 32 * z }, horizontalRadius: 0, verticalRadius: 1 });
      await complete;
    },
  };
}

const mark = (chunk) => decodeChunk(chunk.payload).voxels?.[77];

test('a column without edits comes as generated, once it is known that it has none', async (t) => {
  const { look, asked, taken } = serve(t);
  await look(-1, 33);
  assert.deepEqual(asked, ['/v1/world', `${EDITS}/-1/1`, `${BASE}/-1/33`]);
  assert.deepEqual((await taken(3)).map(({ revision }) => revision), [0n, 0n, 0n]);
});

test('where nothing is stored, nobody is asked for edits', async (t) => {
  const { look, asked, client } = serve(t, { storeId: '0'.repeat(32) });
  await look(0, 0);
  await client.getChunk({ lod: 0, x: 0, y: 0, z: 0 });
  assert.deepEqual(asked, ['/v1/world', `${BASE}/0/0`, `${BASE}/0/0/0`]);
});

test('an edited column comes by its revision, and of the next revision what has changed', async (t) => {
  const answers = new Map([
    [`${EDITS}/0/0`, edits([2, 3, 7], [5, 5, 9])],
    [`${EDITED}/2/3@7`, column(marked(8), marked(6))],
    [`${EDITED}/2/3@11`, column(marked(9), marked(6))],
  ]);
  const { look, asked, taken } = serve(t, { answers, interval: 1 });
  await look(2, 3);
  assert(asked.includes(`${EDITED}/2/3@7`));
  assert(!asked.some((path) => path.startsWith(BASE)));
  const first = await taken(3);
  assert.deepEqual(first.map(({ key, revision }) => [key.y, revision]), [[0, 7n], [1, 7n], [2, 7n]]);
  assert.deepEqual(first.slice(0, 2).map(mark), [8, 6]);
  answers.set(`${EDITS}/0/0`, edits([2, 3, 11], [5, 5, 9]));
  const second = await taken(1);
  assert.deepEqual(second.map(({ key, revision }) => [key.y, revision]), [[0, 11n]]);
  assert.equal(mark(second[0]), 9);
});

test('a column that is edited for the first time comes again', async (t) => {
  const answers = new Map();
  const { look, taken } = serve(t, { answers, interval: 1 });
  await look(2, 3);
  await taken(3);
  answers.set(`${EDITED}/2/3@4`, column(marked(8), marked(6))).set(`${EDITS}/0/0`, edits([2, 3, 4]));
  const [chunk] = await taken(1);
  assert.deepEqual([chunk.key.y, chunk.revision, mark(chunk)], [0, 4n, 8]);
});

test('a redirection says which revision came', async (t) => {
  const answers = new Map([
    [`${EDITS}/0/0`, edits([0, 0, 7])],
    [`${EDITED}/0/0@7`, `${EDITED}/0/0@8`],
    [`${EDITED}/0/0/0@7`, `${EDITED}/0/0/0@5`],
    [`${EDITED}/0/0/0@5`, marked(4)],
  ]);
  const { look, taken, client } = serve(t, { answers });
  await look(0, 0);
  assert.equal((await taken(3))[0].revision, 8n);
  const chunk = await client.getChunk({ lod: 0, x: 0, y: 0, z: 0 });
  assert.deepEqual([chunk.revision, mark(chunk)], [5n, 4]);
});

test('land that is edited just now comes under an older path, and says of which revision it is', async (t) => {
  const answers = new Map([
    [`${EDITS}/0/0`, edits([0, 0, 7])],
    [`${EDITED}/0/0@7`, `${EDITED}/0/0@8`],
    [`${EDITED}/0/0/0@7`, marked(4)],
  ]);
  const revisions = new Map([
    [`${EDITED}/0/0@8`, '18446744073709551615'],
    [`${EDITED}/0/0/0@7`, '9'],
  ]);
  const { look, taken, client } = serve(t, { answers, revisions });
  await look(0, 0);
  assert.equal((await taken(3))[0].revision, 2n ** 64n - 1n);
  const key = { lod: 0, x: 0, y: 0, z: 0 };
  assert.equal((await client.getChunk(key)).revision, 9n);
  revisions.set(`${EDITED}/0/0/0@7`, '-9');
  await assert.rejects(client.getChunk(key), { kind: 'broken_protocol' });
});

test('a handler that throws holds up nothing', async (t) => {
  const thrown = catchMicrotasks(t);
  const { look, taken, client } = serve(t);
  client.on('chunk', ({ key }) => {
    throw new TalusError('overloaded', `row ${key.y}`);
  });
  await look(0, 0);
  assert.equal((await taken(3)).length, 3);
  assert(client.connected);
  assert.deepEqual(thrown.map(({ message }) => message), ['row 0', 'row 1', 'row 2']);
});

test('a square with edits comes by the greatest of its columns\' revisions', () => {
  const edited = EditedColumns.read(edits([4, 4, 5], [7, 7, 1 + 2 ** 40], [8, 8, 2 ** 50]));
  assert.equal(revisionOf({ lod: 0, x: 36, z: 4, n: 4 }, edited), BigInt(1 + 2 ** 40));
  assert.equal(revisionOf({ lod: 0, x: 0, z: 0, n: 4 }, edited), 0n);
  assert.equal(edited.revision(-28, -28), 5n);
  assert.deepEqual(regionOf(2, -1, 64), { lod: 2, x: -1, z: 2 });
  assert.equal(revisionOfPath('http://a/v1/b/c/4/0/1/2@34', 5n), 34n);
  assert.equal(revisionOfPath('', 5n), 5n);
});

test('edited columns that are none are refused, and the View comes as generated', async (t) => {
  const good = edits([1, 1, 5], [2, 2, 6]);
  const wrong = (change) => {
    const body = good.slice();
    change(body);
    return body;
  };
  const bodies = [
    new Uint8Array(0),
    good.subarray(0, 23),
    wrong((body) => (body[0] = 2)),
    wrong((body) => (body[1] = 1)),
    wrong((body) => (body[2] = 1)),
    wrong((body) => (body[4] = 99)), // falls
    wrong((body) => (body[15] = 4)), // beyond the region
  ];
  for (const body of bodies) assert.throws(() => EditedColumns.read(body), { kind: 'broken_protocol' });
  const { look, taken, client } = serve(t, { answers: new Map([[`${EDITS}/0/0`, bodies[2]]]) });
  const errors = [];
  client.on('error', (error) => errors.push(error.kind));
  await look(0, 0);
  assert.equal((await taken(3))[0].revision, 0n);
  assert.deepEqual(errors, ['broken_protocol']);
});

test('names of fields are asked for whole', async (t) => {
  const asked = [];
  const names = ['red rock', 'a,b', 'H\u00f6he', '+&='];
  const fetch = async (url) => {
    asked.push(new URL(url).search);
    const places = { subvoxels_per_voxel: 256, heights: [1], fields: Object.fromEntries(names.map((name, i) => [name, [i]])) };
    return new Response(JSON.stringify(url.endsWith('/v1/world') ? { ...world(STORE), fields: names } : places));
  };
  const client = connect({ url: 'http://server', fetch });
  t.after(() => client.close());
  const { values } = await client.getPlaces([{ x: 1, z: 2 }], { fields: names });
  assert.deepEqual([...values], [0, 1, 2, 3]);
  assert.equal(asked.at(-1), '?columns=1,2&fields=red%20rock,a%2Cb,H%C3%B6he,%2B%26%3D');
});

test('a page of another origin learns which setting may refuse it', async (t) => {
  class Refused {
    constructor() {
      queueMicrotask(() => this.onclose({ code: 1006, reason: '' }));
    }
    close() {}
  }
  const fetch = () => Promise.reject(new TypeError('Failed to fetch'));
  const reason = (options) =>
    new Promise((resolve) => {
      const client = connect({ fetch, WebSocket: Refused, reconnect: { maxAttempts: 0 }, ...options });
      t.after(() => client.close());
      client.ready().catch(({ kind, message }) => resolve(`${kind}: ${message}`));
    });
  const urls = ['ws://game.example:4782', 'http://game.example:4782'];
  for (const url of urls) assert.doesNotMatch(await reason({ url }), /origin/);
  globalThis.location = { origin: 'http://localhost:5173', host: 'localhost:5173', pathname: '/', href: 'http://localhost:5173/' };
  t.after(() => delete globalThis.location);
  for (const url of urls) {
    assert.match(await reason({ url }), /^unreachable: .*, or the server refuses pages of http:\/\/localhost:5173: .* http\.origins /);
  }
  assert.doesNotMatch(await reason({ url: 'http://localhost:5173' }), /http\.origins/);
});

test('a published world that does not open costs no View again', async (t) => {
  const worldFile = `/v1/${FINGERPRINT}/world.toml`;
  const { client, asked, chunks, look } = serve(t, { generate: 'auto', worldFile, answers: new Map([[worldFile, new TextEncoder().encode('seed = ')]]) });
  const failed = new Promise((resolve) => client.on('error', resolve));
  await look(0, 0);
  assert.equal((await failed).kind, 'cannot_generate');
  await new Promise(setImmediate);
  assert.equal(new Set(asked).size, asked.length, 'nothing is asked for twice');
  assert.equal(chunks.length, 3);
});
