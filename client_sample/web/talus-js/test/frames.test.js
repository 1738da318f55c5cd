// Every message against the repository's vectors (protocol/vectors/frames.json), and against broken bytes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Builder } from 'flatbuffers';
import { TalusError } from '../dist/index.js';
import { FrameReader, MAX_SERVER_FRAME_BYTES } from '../dist/wire/frames.js';
import { readMessage } from '../dist/wire/messages.js';
import { Frame } from '../dist/wire/table.js';
import * as write from '../dist/wire/write.js';
import { attachFrame, editFrame } from '../dist/wire/write_edit.js';
import { mutate, random } from './support/random.js';
import { fromHex, read } from './support/repository.js';

const { frames } = JSON.parse(read('protocol/vectors/frames.json'));
const frame = (kind) => frames.find((each) => each.kind === kind);

const hash = ({ low, high }) =>
  BigInt(high).toString(16).padStart(16, '0') + BigInt(low).toString(16).padStart(16, '0');
const key = ({ x, y, z, lod }) => ({ lod, x, y, z });
const camel = (name) => name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
const camelled = (object) => Object.fromEntries(Object.entries(object).map(([name, value]) => [camel(name), value]));

/** What the reader should give, from the vector's fields. */
const EXPECTED = {
  Welcome: ({ protocol, chunk_size, limits, session_rates, fingerprint, store_id, min_y, max_y, world_file, ...rest }) => ({
    kind: 'welcome',
    world: {
      ...rest,
      worldFile: world_file,
      protocol,
      fingerprint: hash(fingerprint),
      storeId: hash(store_id),
      minY: min_y,
      maxY: max_y,
      limits: {
        ...camelled(limits),
        sessionRates: camelled(limits.session_rates),
        addressRates: camelled(limits.address_rates),
      },
    },
  }),
  Chunk: (m) => ({ ...m, kind: 'chunk', key: key(m.key), revision: BigInt(m.revision), hash: hash(m.hash),
                   payload: Uint8Array.from(m.payload) }),
  Unchanged: (m) => ({ ...m, kind: 'unchanged', key: key(m.key), revision: BigInt(m.revision), hash: hash(m.hash) }),
  UniformColumn: (m) => ({ ...m, kind: 'uniform_column', revision: BigInt(m.revision), runs: m.runs.map(camelled) }),
  Heights: (m) => ({ kind: 'heights', id: m.id, heightsFx: Int32Array.from(m.heights_fx),
                     looks: Uint8Array.from(m.looks), values: Float32Array.from(m.values) }),
  Error: (m) => ({ ...camelled(m), kind: 'error', chunk: key(m.chunk) }),
  EditResult: (m) => ({ ...m, kind: 'edit_result', revision: BigInt(m.revision) }),
  EditBroadcast: (m) => ({ kind: 'edit_broadcast', key: key(m.key), revision: BigInt(m.revision),
                           previousRevision: BigInt(m.previous_revision), runs: Uint8Array.from(m.runs) }),
  Attached: (m) => ({ kind: 'attached', editor: hash(m.editor), epoch: BigInt(m.epoch), lastSequence: BigInt(m.last_sequence),
                      known: m.known, revision: BigInt(m.revision), limits: camelled(m.limits) }),
  Pong: (m) => ({ kind: 'pong', nonce: BigInt(m.nonce) }),
  GoAway: (m) => ({ kind: 'go_away', reason: m.reason, retryAfterMs: m.retry_after_ms }),
  ViewComplete: (m) => ({ kind: 'view_complete', number: m.number }),
};

const view = (m) => ({
  centre: m.centre,
  direction: m.direction,
  horizontalRadius: m.horizontal_radius,
  verticalRadius: m.vertical_radius,
  rings: m.rings,
  horizon: m.horizon,
});

/** Frames that the writers make of the vector's fields. */
const WRITTEN = {
  Hello: (m) => write.helloFrame({ ...camelled(m) }),
  View: (m) => write.viewFrame(view(m), m.number, m.known.map((k) => ({ key: k.key, hash: hash(k.hash) })), m.has_base),
  GetChunks: (m) => write.getChunksFrame(m.requests.map((r) => ({ id: r.id, key: r.key, known: r.has_known ? hash(r.known) : null }))),
  GetHeights: (m) => write.getHeightsFrame(m.id, m.columns, m.looks, m.fields),
  Credit: (m) => write.creditFrame(m.total_bytes),
  Ping: (m) => write.pingFrame(m.nonce),
  Edit: (m) => editFrame(m.id, BigInt(m.sequence), { ...m, paste: { ...camelled(m.paste), payload: Uint8Array.from(m.paste.payload) } }),
  Attach: (m) => attachFrame(hash(m.editor), BigInt(m.seen_revision)),
};

/** All that a client's frame says, read field by field: what two frames must have in common. */
const FIELDS = {
  Hello: (t) => [t.u16(0), t.u16(1), [...t.bytesOf(2)], t.text(3), t.text(4), t.u64(5)],
  View: (t) => [structAt(t, 0, 24), structAt(t, 1, 12), t.u16(2), t.u16(3), structsOf(t, 4, 4), structsOf(t, 5, 32), t.u32(6), t.bool(7), t.bool(8)],
  GetChunks: (t) => [structsOf(t, 0, 40)],
  GetHeights: (t) => [t.u32(0), structsOf(t, 1, 16), t.bool(2), [...t.bytesOf(3)]],
  Credit: (t) => [t.u64(0)],
  Ping: (t) => [t.u64(0)],
  Edit: (t) => [t.u32(0), structsOf(t, 1, 32), t.u64(2), structsOf(t, 3, 32), structsOf(t, 4, 56),
                structAt(t.table(5), 0, 24), [...t.table(5).bytesOf(1)], t.table(5).bool(2), t.text(6)],
  Attach: (t) => [structAt(t, 0, 16), t.u64(1)],
};
const bytesAt = (t, at, count) => [...new Uint8Array(t.data.buffer, t.data.byteOffset + at, count)];
const structAt = (t, field, bytes) => bytesAt(t, t.struct(field, bytes), bytes);
const structsOf = (t, field, bytes) => {
  const { at, count } = t.vector(field, bytes);
  return [at % (bytes % 8 === 0 ? 8 : bytes), count, ...bytesAt(t, at, count * bytes)];
};

for (const { kind, number, hex, message } of frames) {
  if (EXPECTED[kind]) {
    test(`reads ${kind}`, () => assert.deepEqual(readMessage(fromHex(hex)), EXPECTED[kind](message)));
    continue;
  }
  test(`refuses ${kind}, which no server sends this client`, () => {
    assert.throws(() => readMessage(fromHex(hex)), { name: 'TalusError', kind: 'broken_protocol' });
  });
  if (!WRITTEN[kind]) continue; // Cancel: nothing here takes a request back
  test(`writes ${kind}`, () => {
    const written = WRITTEN[kind](message);
    const [mine, theirs] = [written, fromHex(hex)].map((bytes) => {
      const root = new Frame(bytes).root();
      return [root.u8(0), FIELDS[kind](root.table(1))];
    });
    assert.equal(mine[0], number);
    assert.deepEqual(mine, theirs);
    assert.equal(new DataView(written.buffer, written.byteOffset).getUint32(0, true), written.length - 4);
  });
}

test('every message of the vectors is tested', () => assert.equal(frames.length, 23));

test('frames come whole however their bytes arrive', () => {
  const whole = frames.filter((each) => EXPECTED[each.kind]).map((each) => fromHex(each.hex));
  const stream = Uint8Array.from(whole.flatMap((bytes) => [...bytes]));
  const next = random('frames in pieces');
  for (let round = 0; round < 200; ++round) {
    const reader = new FrameReader();
    const got = [];
    for (let at = 0; at < stream.length; ) {
      const size = 1 + next(round % 2 === 0 ? 7 : 700);
      reader.push(stream.subarray(at, at + size), (bytes) => got.push(Uint8Array.from(bytes)));
      at += size;
    }
    assert.deepEqual(got, whole);
  }
});

test('a length outside the bounds is an error as soon as it is read', () => {
  for (const length of [0, 7, MAX_SERVER_FRAME_BYTES - 3, 0x7fffffff, 0xffffffff]) {
    const bytes = new Uint8Array(4);
    new DataView(bytes.buffer).setUint32(0, length, true);
    assert.throws(() => new FrameReader().push(bytes, assert.fail), { kind: 'broken_protocol' }, `length ${length}`);
  }
});

test('broken frames are TalusErrors or messages, and nothing else', () => {
  const next = random('broken frames');
  for (const { hex } of frames) {
    const whole = fromHex(hex);
    for (let round = 0; round < 3_000; ++round) {
      const bytes = mutate(whole, next);
      try {
        readMessage(bytes);
      } catch (error) {
        if (!(error instanceof TalusError)) throw error;
      }
    }
  }
});

test('a frame that refers to one text again and again is refused', () => {
  const builder = new Builder(1_024);
  const text = builder.createString('a'.repeat(10_000));
  builder.startVector(4, 20_000, 4);
  for (let i = 0; i < 20_000; ++i) builder.addOffset(text);
  const looks = builder.endVector();
  builder.startObject(13);
  builder.addFieldOffset(11, looks, 0);
  builder.finishSizePrefixed(builder.endObject());
  const table = new Frame(builder.asUint8Array()).root();
  assert.throws(() => table.texts(11), { kind: 'broken_protocol', message: /bytes of text/ });
});
