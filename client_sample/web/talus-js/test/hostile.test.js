// Bytes that no server should send: whatever comes, the package's own error follows, at once.
import assert from 'node:assert/strict';
import net from 'node:net';
import { test } from 'node:test';
import { connect, decodeChunk, DecodeError, TalusError } from '../dist/node.js';
import { readColumn, readSquare } from '../dist/http/columns.js';
import { readHeights } from '../dist/http/heights.js';
import { readWorld } from '../dist/http/world.js';
import { checkHeights } from '../dist/wire/heights.js';
import { mutate, random } from './support/random.js';
import { fromHex, payloads, read } from './support/repository.js';
import { welcome } from './support/scripted.js';

/** Runs `read`; whether it took the bytes. Any error but `expected` fails. */
function takes(read, expected) {
  try {
    read();
    return true;
  } catch (error) {
    if (!(error instanceof expected)) throw error;
    return false;
  }
}

test('broken payloads: chunks of 32,768 voxels, or DecodeErrors', () => {
  const next = random('broken payloads');
  const into = new Uint16Array(32_768);
  const counts = { taken: 0, refused: 0 };
  for (const { payload } of payloads()) {
    for (let round = 0; round < 400; ++round) {
      const taken = takes(() => decodeChunk(mutate(payload, next), { into }), DecodeError);
      ++counts[taken ? 'taken' : 'refused'];
    }
  }
  assert(counts.refused > counts.taken, JSON.stringify(counts));
});

test('random bodies of every encoding', () => {
  const next = random('random bodies');
  const into = new Uint16Array(32_768);
  for (let round = 0; round < 8_000; ++round) {
    const bytes = Uint8Array.from({ length: 2 + next(200) }, () => next(256));
    bytes[0] = 3 + next(2);
    bytes[1] = next(4);
    takes(() => decodeChunk(bytes, { into }), DecodeError);
  }
  for (const length of [65_538, 65_539, 1 << 20]) {
    const bytes = new Uint8Array(length).fill(255);
    bytes[0] = 4;
    for (bytes[1] = 0; bytes[1] < 4; ++bytes[1]) takes(() => decodeChunk(bytes, { into }), DecodeError);
  }
});

test('a chunk that follows a broken one decodes as if alone', () => {
  const next = random('after a broken one');
  const chunks = payloads().filter(({ kind }) => kind === 'chunk');
  for (let round = 0; round < 300; ++round) {
    takes(() => decodeChunk(mutate(chunks[next(chunks.length)].payload, next)), DecodeError);
    const { payload, value } = chunks[next(chunks.length)];
    decodeChunk(payload, { hash: value });
  }
});

function column(lod, payload) {
  const bytes = new Uint8Array(4 + 3 * 12 + 3 * payload.length);
  const data = new DataView(bytes.buffer);
  bytes[0] = 1;
  data.setUint16(2, 3, true);
  const limit = 2 ** (31 - lod);
  let at = 4;
  for (const [y, count] of [[-limit, limit], [0, 1], [1, limit - 1]]) {
    data.setInt32(at, y, true);
    data.setUint32(at + 4, count, true);
    data.setUint32(at + 8, payload.length, true);
    bytes.set(payload, at + 12);
    at += 12 + payload.length;
  }
  return bytes;
}

test('broken columns and squares', () => {
  const next = random('broken columns');
  const whole = column(0, fromHex('030001ac02'));
  assert.deepEqual(readColumn(whole, 0).map(({ firstY, count }) => [firstY, count]), [[-(2 ** 31), 2 ** 31], [0, 1], [1, 2 ** 31 - 1]]);
  assert.throws(() => readColumn(whole, 1), { kind: 'broken_protocol' });
  const square = new Uint8Array(4 + 4 * (4 + whole.length));
  square.set([1, 2, 0, 0]);
  for (let i = 0; i < 4; ++i) {
    const at = 4 + i * (4 + whole.length);
    new DataView(square.buffer).setUint32(at, whole.length, true);
    square.set(whole, at + 4);
  }
  assert.deepEqual(readSquare(square, 2), [whole, whole, whole, whole]);
  assert.throws(() => readSquare(square, 4), { kind: 'broken_protocol' });
  for (let round = 0; round < 20_000; ++round) {
    takes(() => readColumn(mutate(whole, next), 0), TalusError);
    takes(() => readSquare(mutate(square, next), 2).forEach((each) => readColumn(each, 0)), TalusError);
  }
});

test('broken documents', () => {
  for (const json of [null, 5, [], {}, { limits: null }, { limits: {}, spawn: [1, 2] }, { spawn: 'x' }]) {
    assert.throws(() => readWorld(json), { kind: 'broken_protocol' });
  }
  const bytes = (text) => new TextEncoder().encode(text);
  for (const text of ['', 'x', 'null', '{}', '{"heights":5}', '{"heights":["a"]}', '{"heights":[1,2]}']) {
    assert.throws(() => readHeights(bytes(text), 1, false, [], []), { kind: 'broken_protocol' });
  }
  assert.throws(() => readHeights(bytes('{"heights":[1],"looks":["?"]}'), 1, true, [], ['a']), { kind: 'broken_protocol' });
});

test('more rows than a world has, which a View with a horizon would count', () => {
  for (const [minY, maxY] of [[0, 0], [-32, 2 ** 17 - 32], [2 ** 36 - 1, 2 ** 36]]) checkHeights({ minY, maxY });
  for (const [minY, maxY] of [[1, 0], [-32, 2 ** 17 - 31], [0, 2 ** 53 - 1], [-(2 ** 36) - 1, -(2 ** 36)]]) {
    assert.throws(() => checkHeights({ minY, maxY }), { kind: 'broken_protocol' }, `${minY} to ${maxY}`);
  }
  const rates = { chunks_per_second: 0, bytes_per_second: 0, requests_per_second: 0, burst_ms: 0 };
  const world = {
    server: '', fingerprint: '1'.repeat(32), store_id: '0'.repeat(32), codec: 4, chunk_size: 32, min_y: 0, max_y: 64, spawn: [0, 0, 0],
    materials: [], looks: [], fields: [],
    limits: { heights_per_request: 1, view_horizontal_radius: 9, view_vertical_radius: 9, view_chunks: 2 ** 32 - 1, session: rates, address: rates },
  };
  assert.equal(readWorld(world).maxY, 64);
  assert.throws(() => readWorld({ ...world, max_y: 2 ** 36 }), { kind: 'broken_protocol', message: /heights from 0/ });
});

/** A server that says `bytes` to everyone. */
async function sayer(bytes) {
  const server = net.createServer((socket) => {
    socket.on('error', () => {});
    socket.write(bytes);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { url: `tcp://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

const { frames } = JSON.parse(read('protocol/vectors/frames.json'));
const frame = (kind) => fromHex(frames.find((each) => each.kind === kind).hex);

for (const [name, bytes, error] of [
  ['a length of 4 GiB', Uint8Array.of(255, 255, 255, 255), /frame of 4294967299 bytes/],
  ['HTTP', new TextEncoder().encode('HTTP/1.1 400 Bad Request'), /HTTP, not frames: connect by http:/],
  ['a length of nothing', Uint8Array.of(0, 0, 0, 0), /frame of 4 bytes/],
  ['a frame of zeros', Uint8Array.of(12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0), /frame|table|message/],
  ["a client's message", frame('Hello'), /kind 1/],
  ['a Chunk before Welcome', frame('Chunk'), /chunk before Welcome/],
  ['a Welcome of another codec', frame('Welcome'), /codec 1/],
  ['a Welcome of more rows than a world has', welcome({ minY: -(2n ** 36n), maxY: 2n ** 36n }), /heights from -68719476736 to 68719476736/],
]) {
  test(`a server that sends ${name} is dropped`, async () => {
    const server = await sayer(bytes);
    const client = connect({ url: server.url, reconnect: { maxAttempts: 0 } });
    await assert.rejects(client.ready(), (thrown) => thrown.kind === 'broken_protocol' && error.test(thrown.message));
    server.close();
  });
}

test('a server that says nothing is given up', async () => {
  const server = await sayer(new Uint8Array(0));
  const client = connect({ url: server.url, reconnect: { maxAttempts: 0 }, connectTimeoutMs: 50 });
  await assert.rejects(client.ready(), { kind: 'timed_out' });
  server.close();
});
