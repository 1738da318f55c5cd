// Chunks of a published world made beside a stream, with a server whose every word the test says.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { decodeChunk } from '../dist/decode.js';
import { ViewShape } from '../dist/index.js';
import { uniformPayload } from '../dist/uniform.js';
import { World as Module } from '../wasm/world.js';
import { broadcast, chunk, script, unchanged, viewComplete, welcome } from './support/scripted.js';

const toml = readFileSync(new URL('../../../../core/worlds/classic.toml', import.meta.url));
const VIEW = { centre: { x: 16, y: 80, z: 16 }, horizontalRadius: 2, verticalRadius: 2, rings: [{ lod: 1, radius: 4 }] };
const alone = await Module.open(toml);
const worldFile = `/v1/${alone.fingerprint}/world.toml`;
const nameOf = ({ lod, x, y, z }) => `${lod}/${x}/${y}/${z}`;
const published = { fingerprint: alone.fingerprint, worldFile, maxY: 320n };
const answers = (bytes) => async (url) => (url === `http://here${worldFile}` ? new Response(bytes) : new Response(null, { status: 404 }));

/** One voxel, index 5 of the chunk, of a material: core/edits/FORMAT.md, "Runs". */
const oneVoxel = (material) => Uint8Array.of(1, material, 1, 5, 0);
/** A mixed chunk of the View. */
const MIXED = (() => {
  for (let y = 0; ; ++y) {
    const key = { lod: 0, x: 1, y, z: 0 };
    if (alone.generate(key).uniform === null) return key;
  }
})();

async function joined(t, how = {}, welcomed = published) {
  const { client, accept } = script({ url: 'ws://here', generate: 'always', fetch: answers(toml), ...how });
  t.after(() => client.close());
  const chunks = new Map();
  const errors = [];
  client.on('chunk', (came) => chunks.set(nameOf(came.key), came));
  client.on('error', (error) => errors.push(error));
  client.setView(VIEW);
  const side = await accept(welcome(welcomed));
  const first = await side.next('View');
  assert.equal(first.hasBase, false, 'the first View is streamed');
  const complete = new Promise((resolve) => client.on('viewComplete', resolve));
  return { client, side, chunks, errors, complete };
}

/** Answers what is compared, and anything else by `other`. */
function answerProofs(side, { wrong = false, other = () => {} } = {}) {
  let proofs = 0;
  const pump = () => {
    for (let i = 0; i < side.heard.length; ++i) {
      const message = side.heard[i];
      if (message.kind !== 'GetChunks') continue;
      side.heard.splice(i--, 1);
      for (const { id, key, known } of message.requests) {
        if (known === null) {
          other(id, key);
          continue;
        }
        ++proofs;
        const made = alone.generate(key, { hash: true });
        assert.equal(known, made.hash, nameOf(key));
        side.say(wrong ? chunk({ id, key, revision: 0, hash: 'b'.repeat(32), payload: uniformPayload(2) }) : unchanged({ id, key, revision: 0, hash: known }));
      }
    }
  };
  let ended = false;
  void (async () => {
    for (; !ended; await soon()) pump();
  })();
  return { end: () => (ended = true), get proofs() { return proofs; } };
}

const soon = () => new Promise(setImmediate);

const voxelOf = ({ payload }) => {
  const { voxels, uniform } = decodeChunk(payload);
  return voxels === null ? uniform : voxels[5];
};

test('all of a View is made here, with the edits that the server sends, and is compared', async (t) => {
  const { client, side, chunks, errors, complete } = await joined(t);
  const view = await side.next('View');
  assert.equal(view.hasBase, true);
  const answering = answerProofs(side);
  t.after(() => answering.end());
  side.say(broadcast({ key: MIXED, revision: 7, previous: 0, runs: oneVoxel(3) }));
  side.say(viewComplete(view.number));
  await complete;
  const shape = new ViewShape(VIEW, client.world);
  assert.equal(chunks.size, shape.count);
  for (const came of chunks.values()) {
    const { voxels, uniform } = alone.generate(came.key);
    const expected = nameOf(came.key) === nameOf(MIXED) ? voxels.with(5, 3) : voxels;
    const { voxels: seen, uniform: seenUniform } = decodeChunk(came.payload, { hash: came.hash });
    assert.deepEqual([seen, seenUniform], [expected, uniform], nameOf(came.key));
  }
  assert.equal(chunks.get(nameOf(MIXED)).revision, 7n);
  assert.equal(client.stats.madeChunks, shape.count);
  while (answering.proofs < 16) await soon();
  assert.equal(client.stats.proofs, 16);
  assert.deepEqual(errors, []);

  // A later edit applies to the edited chunk, one to a chunk as generated to that; a gap is asked for.
  const next = (key, test) => new Promise((resolve) => client.on('chunk', (came) => nameOf(came.key) === nameOf(key) && test(came) && resolve(came)));
  let seen = next(MIXED, ({ revision }) => revision === 9n);
  side.say(broadcast({ key: MIXED, revision: 9, previous: 7, runs: oneVoxel(4) }));
  assert.equal(voxelOf(await seen), 4);
  const other = { ...MIXED, x: 0 };
  assert.equal(alone.generate(other).uniform, null);
  seen = next(other, ({ revision }) => revision === 11n);
  side.say(broadcast({ key: other, revision: 10, previous: 0, runs: oneVoxel(4) }), broadcast({ key: other, revision: 11, previous: 10, runs: oneVoxel(5) }));
  assert.equal(voxelOf(await seen), 5);
  answering.end();
  side.say(broadcast({ key: { ...MIXED, z: 1 }, revision: 13, previous: 12, runs: oneVoxel(4) }));
  assert.deepEqual((await side.next('GetChunks')).requests.map(({ key }) => key), [{ ...MIXED, z: 1 }]);
});

test('after a connection that broke, nothing is made twice', async (t) => {
  const { client, accept } = script({ url: 'ws://here', generate: 'always', fetch: answers(toml) });
  t.after(() => client.close());
  client.setView(VIEW);
  const side = await accept(welcome(published));
  await side.next('View');
  const view = await side.next('View');
  let answering = answerProofs(side);
  side.say(viewComplete(view.number));
  await new Promise((resolve) => client.on('viewComplete', resolve));
  answering.end();
  const { madeChunks } = client.stats;
  side.breakOff(new Error('gone'));
  const again = await accept(welcome(published));
  answering = answerProofs(again);
  t.after(() => answering.end());
  const repeated = await again.next('View');
  assert.equal(repeated.hasBase, true);
  const complete = new Promise((resolve) => client.on('viewComplete', resolve));
  again.say(viewComplete(repeated.number));
  await complete;
  assert.equal(client.stats.madeChunks, madeChunks);
});

test('with another store its edits alone are seen', async (t) => {
  const store = (digit) => ({ ...published, storeId: digit.repeat(32) });
  const { client, accept } = script({ url: 'ws://here', generate: 'always', fetch: answers(toml) });
  t.after(() => client.close());
  const chunks = new Map();
  client.on('chunk', (came) => chunks.set(nameOf(came.key), came));
  client.setView(VIEW);
  const both = { ...MIXED, z: 1 };
  const whole = async (side, edits) => {
    let view;
    do view = await side.next('View');
    while (!view.hasBase);
    const answering = answerProofs(side);
    t.after(() => answering.end());
    const complete = new Promise((resolve) => client.on('viewComplete', resolve));
    side.say(...edits, viewComplete(view.number));
    await complete;
    answering.end();
  };
  const side = await accept(welcome(store('a')));
  const edit = (key, revision, material) => broadcast({ key, revision, previous: 0, runs: oneVoxel(material) });
  await whole(side, [edit(MIXED, 7, 3), edit(both, 8, 3)]);
  assert.deepEqual([MIXED, both].map((key) => voxelOf(chunks.get(nameOf(key)))), [3, 3]);
  side.breakOff(new Error('gone'));
  await whole(await accept(welcome(store('b'))), [edit(both, 2, 4)]);
  const again = chunks.get(nameOf(MIXED));
  assert.deepEqual([again.revision, decodeChunk(again.payload).voxels], [0n, alone.generate(MIXED).voxels]);
  const other = chunks.get(nameOf(both));
  assert.deepEqual([other.revision, voxelOf(other)], [2n, 4]);
});

test('one chunk that differs from the server\'s, and all are streamed', async (t) => {
  const { client, side, errors } = await joined(t);
  const view = await side.next('View');
  assert.equal(view.hasBase, true);
  const answering = answerProofs(side, { wrong: true });
  t.after(() => answering.end());
  side.say(viewComplete(view.number));
  while (errors.length === 0) await soon();
  assert.equal(errors[0].kind, 'cannot_generate');
  assert.match(errors[0].message, /^chunks are not made here: chunk \d\/.* differs from the server's$/);
  while (!side.heard.some(({ kind, hasBase }) => kind === 'View' && !hasBase)) await soon();
  assert.equal(errors.length, 1);
  // What comes takes the place of what was made.
  const { hash } = alone.generate(MIXED, { hash: true });
  const seen = new Promise((resolve) => client.on('chunk', (came) => nameOf(came.key) === nameOf(MIXED) && resolve(came)));
  side.say(chunk({ key: MIXED, revision: 0, hash: hash.replace(/./, '0'), payload: uniformPayload(1) }));
  assert.equal((await seen).material, 1);
});

test('what cannot be opened is streamed, and said once', async (t) => {
  for (const [how, welcomed, words] of [
    [{ fetch: async () => new Response(null, { status: 404 }) }, published, /the server has no such file/],
    [{ fetch: async () => new Response(null, { status: 503 }) }, published, /answered 503/],
    [{ fetch: async () => Promise.reject(new TypeError('fetch failed')) }, published, /fetch failed/],
    [{ fetch: answers('seed = ') }, published, /not made here: 1:/],
    [{ fetch: answers(new Uint8Array((1 << 20) + 1)) }, published, /more than 1048576 bytes/],
    [{ fetch: answers(Array.from({ length: 257 }, (_, i) => `# "${i}.vox"\n`).join('')) }, published, /more than 256 files/],
    [{ fetch: answers(`# "${'a'.repeat(1021)}.vox"`) }, published, /more than 1024 bytes/],
    [{ fetch: async () => new Response(toml) }, { ...published, fingerprint: 'a'.repeat(32) }, /the published world is .* the server's is a{32}/],
  ]) {
    const { side, errors, complete, client } = await joined(t, how, welcomed);
    while (errors.length === 0) await soon();
    assert.match(errors[0].message, words);
    new ViewShape(VIEW, client.world).forEach((key) => side.say(chunk({ key, revision: 0, hash: 'a'.repeat(32), payload: uniformPayload(1) })));
    side.say(viewComplete(1));
    await complete;
    assert.deepEqual([errors.length, client.stats.madeChunks], [1, 0]);
    assert.ok(!side.heard.some(({ kind }) => kind === 'View'), 'no other View was sent');
  }
});

test('a world that is not published, or a client that is not told to, is streamed without a word', async (t) => {
  for (const [how, welcomed] of [[{ generate: 'never' }, published], [{}, { ...published, worldFile: '' }]]) {
    const fetch = t.mock.fn(answers(toml));
    const { side, errors } = await joined(t, { fetch, ...how }, welcomed);
    await new Promise((resolve) => setImmediate(resolve));
    assert.deepEqual([errors.length, fetch.mock.callCount(), side.heard.length], [0, 0, 0]);
  }
});

test('what is fetched ends with the client', async (t) => {
  let signal;
  const fetch = (url, init) => new Promise((_, reject) => (signal = init.signal).addEventListener('abort', () => reject(signal.reason)));
  const { client, errors } = await joined(t, { fetch });
  while (signal === undefined) await soon();
  client.close();
  assert.ok(signal.aborted);
  await soon();
  assert.deepEqual(errors, []);
});
