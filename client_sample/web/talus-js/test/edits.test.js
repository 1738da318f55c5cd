// Edits, with a server whose every word the test says: PROTOCOL.md, "Edit" and "After a lost connection".
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { connect, decodeChunk, encodeChunk, hashVoxels, TalusError } from '../dist/index.js';
import { attached, broadcast, chunk, editResult, error, script, welcome } from './support/scripted.js';

const EDITOR = 'e'.repeat(32);
const BIT = 0x8000_0000;
const lost = () => new TalusError('disconnected', 'the cable');
/** An edit that one can tell by its material. */
const write = (material) => ({ writes: [{ voxel: { x: 1, y: 2, z: 3 }, material }] });

/** A test that ends by itself, and its client with it. */
function scripted(name, body) {
  test(name, { timeout: 20_000 }, async () => {
    const { client, accept } = script();
    try {
      await body(client, accept);
    } finally {
      client.close();
    }
  });
}

/** Joined and attached, with `edits` sent; gives the connection, their answers to be, and the messages. */
async function sent(client, accept, materials, how = {}) {
  const answers = materials.map((material) => client.edit(write(material)));
  for (const answer of answers) answer.catch(() => {}); // looked at by the test, later
  const side = await accept(welcome());
  await side.next('Attach');
  side.say(attached(how));
  const messages = [];
  for (const material of materials) {
    const message = await side.next('Edit');
    assert.deepEqual(message.materials, [material]);
    messages.push(message);
  }
  return { side, answers, messages };
}

scripted('edits are sent after Attach, in order, with ids of their own and rising sequences', async (client, accept) => {
  const { side, answers, messages } = await sent(client, accept, [1, 2], { lastSequence: 20n });
  assert.deepEqual(side.hello.versions, [2, 2]);
  assert.deepEqual(messages.map(({ sequence }) => sequence), [21n, 22n]);
  assert(messages.every(({ id }) => id >= BIT));
  side.say(editResult(messages[1].id, 8, 0), editResult(messages[0].id, 7, 1));
  assert.deepEqual(await Promise.all(answers), [{ revision: 7n, changed: 1 }, { revision: 8n, changed: 0 }]);
});

scripted('no more are on their way than the server allows', async (client, accept) => {
  const answers = [1, 2, 3].map((material) => client.edit(write(material)));
  const side = await accept(welcome());
  await side.next('Attach');
  side.say(attached({ unanswered: 2 }));
  const first = await side.next('Edit');
  const second = await side.next('Edit');
  await new Promise(setImmediate);
  assert.deepEqual(side.heard, []);
  side.say(editResult(first.id, 1));
  const third = await side.next('Edit');
  side.say(editResult(second.id, 2), editResult(third.id, 3));
  assert.deepEqual((await Promise.all(answers)).map(({ revision }) => revision), [1n, 2n, 3n]);
});

scripted('after a lost connection those without an answer go again, first, with the same sequences', async (client, accept) => {
  const { side, answers, messages } = await sent(client, accept, [1, 2, 3]);
  side.say(editResult(messages[1].id, 5));
  side.breakOff(lost());
  const later = client.edit(write(4));
  const again = await accept(welcome());
  assert.deepEqual(await again.next('Attach'), { kind: 'Attach', editor: EDITOR, seenRevision: 5n });
  again.say(attached({ known: true, lastSequence: 2n }));
  const resent = [await again.next('Edit'), await again.next('Edit'), await again.next('Edit')];
  assert.deepEqual(resent.map(({ materials }) => materials), [[1], [3], [4]]);
  assert.deepEqual(resent.map(({ sequence }) => sequence), [1n, 3n, 4n]);
  // A repeat: the server gives the result that it kept.
  again.say(editResult(resent[0].id, 4), error('not_applied', 'request', { id: resent[1].id }), editResult(resent[2].id, 6));
  assert.equal((await answers[0]).revision, 4n);
  assert.equal((await answers[1]).revision, 5n);
  assert.equal((await later).revision, 6n);
  // One that did not happen goes as a new one.
  const asNew = await again.next('Edit');
  assert.deepEqual([asNew.materials, asNew.sequence], [[3], 5n]);
  again.say(editResult(asNew.id, 7));
  assert.equal((await answers[2]).revision, 7n);
});

scripted('where the server has forgotten the editor, nobody knows of what was sent; the rest goes', async (client, accept) => {
  const { side, answers } = await sent(client, accept, [1, 2]);
  side.breakOff(lost());
  const later = client.edit(write(3));
  const again = await accept(welcome());
  await again.next('Attach');
  again.say(attached({ editor: 'd'.repeat(32), known: false }));
  for (const answer of answers) await assert.rejects(answer, { kind: 'outcome_unknown' });
  const message = await again.next('Edit');
  assert.deepEqual([message.materials, message.sequence], [[3], 1n]);
  again.say(editResult(message.id, 1));
  await later;
});

scripted('another store knows nothing of the editor', async (client, accept) => {
  const { side, answers } = await sent(client, accept, [1]);
  side.breakOff(lost());
  const again = await accept(welcome({ storeId: '2'.repeat(32) }));
  await assert.rejects(answers[0], { kind: 'outcome_unknown' });
  const later = client.edit(write(2));
  assert.deepEqual(await again.next('Attach'), { kind: 'Attach', editor: '0'.repeat(32), seenRevision: 0n });
  again.say(attached());
  again.say(editResult((await again.next('Edit')).id, 1));
  await later;
});

scripted('an editor that another connection took attaches once more, and sends all again, in order', async (client, accept) => {
  const { side, answers, messages } = await sent(client, accept, [1, 2, 3]);
  // All three come before the server hears of the new Attach: one Attach at a time is allowed.
  for (const { id } of messages) side.say(error('expired', 'request', { id }));
  assert.equal((await side.next('Attach')).editor, EDITOR);
  await new Promise(setImmediate);
  assert.deepEqual(side.heard, []);
  side.say(attached({ known: true, lastSequence: 9n }));
  const resent = [await side.next('Edit'), await side.next('Edit'), await side.next('Edit')];
  assert.deepEqual(resent.map(({ materials }) => materials), [[1], [2], [3]]);
  assert.deepEqual(resent.map(({ sequence }) => sequence), [1n, 2n, 3n]);
  resent.forEach(({ id }, i) => side.say(editResult(id, i + 1)));
  await Promise.all(answers);
});

scripted('an overloaded server gets the edit again, as it is', async (client, accept) => {
  const { side, answers, messages } = await sent(client, accept, [1, 2]);
  side.say(error('overloaded', 'request', { id: messages[0].id, retryAfterMs: 5 }), editResult(messages[1].id, 1));
  const again = await side.next('Edit');
  assert.deepEqual([again.materials, again.sequence], [[1], 1n]);
  side.say(editResult(again.id, 2));
  assert.deepEqual((await Promise.all(answers)).map(({ revision }) => revision), [2n, 1n]);
});

scripted('an Attach that the server puts off comes again', async (client, accept) => {
  const answer = client.edit(write(1));
  const side = await accept(welcome());
  await side.next('Attach');
  side.say(error('overloaded', 'attach', { retryAfterMs: 5 }));
  await side.next('Attach');
  side.say(attached());
  side.say(editResult((await side.next('Edit')).id, 1));
  await answer;
});

scripted('conflicts, and a token without the right', async (client, accept) => {
  const { side, answers, messages } = await sent(client, accept, [1]);
  side.say(error('conflict', 'request', { id: messages[0].id, text: 'guard 0' }));
  await assert.rejects(answers[0], { kind: 'conflict', message: /guard 0/ });
  side.breakOff(lost());
  const refused = [client.edit(write(2)), client.editLimits()];
  const again = await accept(welcome());
  await again.next('Attach');
  again.say(error('forbidden', 'attach', { text: 'no right to edit' }));
  for (const each of refused) await assert.rejects(each, { kind: 'refused', message: /no right/ });
  assert(client.connected);
});

scripted('what one may edit is told before one edits', async (client, accept) => {
  const limits = client.editLimits();
  const side = await accept(welcome());
  await side.next('Attach');
  side.say(attached({ unanswered: 7 }));
  assert.equal((await limits).unanswered, 7);
  assert.equal((await client.editLimits()).voxels, 65_536); // without asking again
  assert.deepEqual(side.heard, []);
});

scripted('a server that stores nothing refuses edits without being asked', async (client, accept) => {
  const early = client.edit(write(1));
  const side = await accept(welcome({ storeId: '0'.repeat(32) }));
  const refusal = { kind: 'refused', message: /stores no edits/ };
  await assert.rejects(early, refusal);
  await assert.rejects(client.edit(write(1)), refusal);
  assert.deepEqual(side.heard, []);
});

scripted('edits that no server would take are refused here', async (client, accept) => {
  const voxel = { x: 0, y: 0, z: 0 };
  for (const wrong of [
    { writes: [{ voxel: { x: 0.5, y: 0, z: 0 }, material: 1 }] },
    { guards: [{ voxel, material: -1 }] },
    { writes: [{ voxel, material: 65_536 }] },
    { fills: [{ first: { x: 1, y: 0, z: 0 }, last: voxel, material: 1 }] },
  ]) {
    await assert.rejects(client.edit(wrong), { name: 'TalusError', kind: 'out_of_range' });
  }
  const side = await accept(welcome({ frameBytes: 4_096 }));
  const writes = Array.from({ length: 200 }, (_, x) => ({ voxel: { x, y: 0, z: 0 }, material: 1 }));
  const large = client.edit({ writes });
  await side.next('Attach');
  side.say(attached());
  await assert.rejects(large, { kind: 'out_of_range', message: /divide it/ });
});

scripted('close() fails what is open', async (client, accept) => {
  const { answers } = await sent(client, accept, [1]);
  const waiting = client.edit(write(2));
  client.close();
  for (const answer of [...answers, waiting, client.edit(write(3))]) await assert.rejects(answer, { kind: 'closed' });
});

test('by HTTP nobody edits', async () => {
  const client = connect({ url: 'http://127.0.0.1:1', fetch: () => new Promise(() => {}) });
  await assert.rejects(client.edit(write(1)), { kind: 'refused', message: /ws:/ });
  await assert.rejects(client.editLimits(), { kind: 'refused' });
  client.close();
});

// ---- what others edit

const key = { lod: 0, x: 0, y: 0, z: 0 };
const voxelsOf = ({ payload, hash }) => {
  const { uniform, voxels } = decodeChunk(payload, { hash });
  return voxels ?? new Uint16Array(32_768).fill(uniform);
};
const dense = () => Uint16Array.from({ length: 32_768 }, (_, i) => (i < 9_000 ? 1 : 0));
const message = (voxels, revision, id = 0) => {
  const all = { uniform: null, voxels };
  return chunk({ id, key, revision, hash: hashVoxels(all), payload: encodeChunk(all) });
};
/** Voxels 5 to 7 of material 3, and 8 and 40 of material 300. */
const RUNS = Uint8Array.of(2, 3, 0xac, 2, 3, 5, 4, 0, 1, 0x1f, 1);
const edited = (voxels) => {
  const after = voxels.slice().fill(3, 5, 8);
  after[8] = after[40] = 300;
  return after;
};

/** In a View of one chunk; `chunks` grows. */
async function watching(client, accept) {
  const chunks = [];
  client.on('chunk', (each) => chunks.push(each));
  client.setView({ centre: { x: 5, y: 5, z: 5 }, horizontalRadius: 0, verticalRadius: 0 });
  const side = await accept(welcome());
  await side.next('View');
  return { side, chunks };
}

for (const [what, before] of [['a chunk', dense()], ['a chunk of one material', new Uint16Array(32_768).fill(1)]]) {
  scripted(`a broadcast changes ${what} that is held, once`, async (client, accept) => {
    const { side, chunks } = await watching(client, accept);
    side.say(message(before, 4));
    side.say(broadcast({ key, revision: 6, previous: 4, runs: RUNS }));
    side.say(broadcast({ key, revision: 6, previous: 4, runs: RUNS }), broadcast({ key, revision: 5, previous: 3, runs: Uint8Array.of(0, 0) }));
    assert.deepEqual(chunks.map(({ revision }) => revision), [4n, 6n]);
    assert.deepEqual(voxelsOf(chunks[1]), edited(before));
    // And the next on top of that; it begins before what is held.
    side.say(broadcast({ key, revision: 9, previous: 5, runs: Uint8Array.of(1, 0, 1, 5, 2) }));
    assert.deepEqual(voxelsOf(chunks[2]), edited(before).fill(0, 5, 8));
    assert.deepEqual(side.heard, []);
  });
}

scripted('a broadcast that skips a revision asks for the chunk, and once more where it changed meanwhile', async (client, accept) => {
  const { side, chunks } = await watching(client, accept);
  side.say(message(dense(), 4));
  side.say(broadcast({ key, revision: 6, previous: 5, runs: RUNS }));
  const first = await side.next('GetChunks');
  side.say(broadcast({ key, revision: 7, previous: 6, runs: RUNS }));
  side.say(message(edited(dense()), 6, first.id));
  const second = await side.next('GetChunks');
  side.say(message(dense(), 7, second.id));
  await new Promise(setImmediate);
  assert.deepEqual(chunks.map(({ revision }) => revision), [4n, 6n, 7n]);
  side.say(broadcast({ key, revision: 8, previous: 7, runs: RUNS }));
  assert.deepEqual(voxelsOf(chunks[3]), edited(dense()));
});

scripted('a broadcast for a chunk that is not held is nothing', async (client, accept) => {
  const { side, chunks } = await watching(client, accept);
  side.say(broadcast({ key, revision: 6, previous: 5, runs: RUNS }), broadcast({ key: { ...key, x: 9 }, revision: 6, previous: 5, runs: RUNS }));
  assert.deepEqual([chunks, side.heard], [[], []]);
});

scripted('a broadcast whose runs are none breaks the protocol', async (client, accept) => {
  const { side } = await watching(client, accept);
  const gone = new Promise((resolve) => client.on('disconnected', resolve));
  side.say(message(dense(), 4));
  side.say(broadcast({ key, revision: 6, previous: 4, runs: Uint8Array.of(1, 2, 3) }));
  assert.equal((await gone).kind, 'broken_protocol');
});

scripted('what was kept out of the cache is asked for', async (client, accept) => {
  client.close();
  const small = script({ keepBytes: 0 });
  const { side } = await watching(small.client, small.accept);
  side.say(message(dense(), 4));
  side.say(broadcast({ key, revision: 6, previous: 4, runs: RUNS }));
  await side.next('GetChunks');
  small.client.close();
});
