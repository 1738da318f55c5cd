// A server whose every word the test says: a transport without a network.
import assert from 'node:assert/strict';
import { Builder } from 'flatbuffers';
import { StreamClient } from '../../dist/stream/client.js';
import { Frame } from '../../dist/wire/table.js';

const NAMES = { 1: 'Hello', 2: 'View', 3: 'GetChunks', 6: 'Credit', 7: 'Edit', 8: 'Ping', 20: 'Attach' };
const FULL = 'fedcba98765432100123456789abcdef';

function frame(kind, write) {
  const builder = new Builder(256);
  const body = write(builder);
  builder.startObject(2);
  builder.addFieldOffset(1, body, 0);
  builder.addFieldInt8(0, kind, 0);
  builder.finishSizePrefixed(builder.endObject());
  return builder.asUint8Array().slice();
}

function addHash(builder, field, hash) {
  builder.prep(8, 16);
  builder.writeInt64(BigInt(`0x${hash.slice(0, 16)}`));
  builder.writeInt64(BigInt(`0x${hash.slice(16)}`));
  builder.addFieldStruct(field, builder.offset(), 0);
}

function addKey(builder, field, { x, y, z, lod }) {
  builder.prep(4, 16);
  builder.pad(3);
  builder.writeInt8(lod);
  for (const at of [z, y, x]) builder.writeInt32(at);
  builder.addFieldStruct(field, builder.offset(), 0);
}

export const welcome = ({
  protocol = 2,
  fingerprint = FULL,
  storeId = '0'.repeat(31) + '1',
  frameBytes = 65_536,
  idleTimeoutMs = 60_000,
  minY = 0n,
  maxY = 64n,
  worldFile = '',
} = {}) =>
  frame(9, (b) => {
    const materials = b.createString('rock');
    b.startObject(4);
    b.addFieldInt16(0, 1, 0);
    b.addFieldOffset(1, materials, 0);
    b.addFieldInt8(3, 2, 0);
    const rock = b.endObject();
    b.startVector(4, 1, 4);
    b.addOffset(rock);
    const list = b.endVector();
    const path = worldFile === '' ? 0 : b.createString(worldFile);
    b.startObject(12);
    [[0, frameBytes], [1, 64], [2, 64], [5, 1000], [7, idleTimeoutMs]].forEach(([field, value]) => b.addFieldInt32(field, value, 0));
    b.addFieldInt16(3, 16, 0);
    b.addFieldInt16(4, 16, 0);
    b.addFieldInt64(6, 1n << 20n, 0n);
    b.addFieldInt8(11, worldFile === '' ? 0 : 1, 0);
    const limits = b.endObject();
    b.startObject(14);
    b.addFieldInt16(0, protocol, 0);
    b.addFieldInt8(1, 4, 0);
    addHash(b, 2, fingerprint);
    addHash(b, 3, storeId);
    b.addFieldInt16(4, 32, 0);
    b.addFieldOffset(5, list, 0);
    b.addFieldInt64(6, minY, 0n);
    b.addFieldInt64(7, maxY, 0n);
    b.addFieldOffset(9, limits, 0);
    b.addFieldOffset(13, path, 0);
    return b.endObject();
  });

export const attached = ({ editor = 'e'.repeat(32), lastSequence = 0n, known = false, revision = 0n, unanswered = 4 } = {}) =>
  frame(21, (b) => {
    b.startObject(4);
    b.addFieldInt32(0, 65_536, 0);
    b.addFieldInt32(1, 64, 0);
    b.addFieldInt32(2, unanswered, 0);
    const limits = b.endObject();
    b.startObject(6);
    addHash(b, 0, editor);
    b.addFieldInt64(1, 1n, 0n);
    b.addFieldInt64(2, lastSequence, 0n);
    b.addFieldInt8(3, known ? 1 : 0, 0);
    b.addFieldInt64(4, revision, 0n);
    b.addFieldOffset(5, limits, 0);
    return b.endObject();
  });

export const editResult = (id, revision, changed = 1) =>
  frame(15, (b) => {
    b.startObject(3);
    b.addFieldInt32(0, id, 0);
    b.addFieldInt64(1, BigInt(revision), 0n);
    b.addFieldInt32(2, changed, 0);
    return b.endObject();
  });

const CODES = { overloaded: 10, forbidden: 14, conflict: 15, expired: 16, not_applied: 17 };
const ABOUTS = { request: 2, attach: 7 };

export const error = (code, about, { id = 0, retryAfterMs = 0, text = code } = {}) =>
  frame(14, (b) => {
    const said = b.createString(text);
    b.startObject(5);
    b.addFieldInt16(0, CODES[code], 0);
    b.addFieldOffset(1, said, 0);
    b.addFieldInt32(2, id, 0);
    b.addFieldInt32(3, retryAfterMs, 0);
    b.addFieldInt8(4, ABOUTS[about], 0);
    return b.endObject();
  });

export const chunk = ({ id = 0, key, revision, hash, payload }) =>
  frame(10, (b) => {
    const bytes = b.createByteVector(payload);
    b.startObject(6);
    b.addFieldInt32(0, id, 0);
    addKey(b, 1, key);
    b.addFieldInt64(2, BigInt(revision), 0n);
    addHash(b, 3, hash);
    b.addFieldInt8(4, 4, 0);
    b.addFieldOffset(5, bytes, 0);
    return b.endObject();
  });

export const broadcast = ({ key, revision, previous, runs }) =>
  frame(16, (b) => {
    const bytes = b.createByteVector(runs);
    b.startObject(5);
    addKey(b, 0, key);
    b.addFieldInt64(1, BigInt(revision), 0n);
    b.addFieldInt64(2, BigInt(previous), 0n);
    b.addFieldOffset(4, bytes, 0);
    return b.endObject();
  });

export const unchanged = ({ id = 0, key, revision, hash }) =>
  frame(11, (b) => {
    b.startObject(4);
    b.addFieldInt32(0, id, 0);
    addKey(b, 1, key);
    b.addFieldInt64(2, BigInt(revision), 0n);
    addHash(b, 3, hash);
    return b.endObject();
  });

export const pong = (nonce) =>
  frame(17, (b) => {
    b.startObject(1);
    b.addFieldInt64(0, BigInt(nonce), 0n);
    return b.endObject();
  });

export const viewComplete = (number) =>
  frame(19, (b) => {
    b.startObject(1);
    b.addFieldInt32(0, number, 0);
    return b.endObject();
  });

function read(bytes) {
  const root = new Frame(bytes).root();
  const kind = NAMES[root.u8(0)];
  const t = root.table(1);
  if (kind === 'Edit') {
    const { at, count } = t.vector(1, 32);
    const materials = Array.from({ length: count }, (_, i) => t.data.getUint16(at + 32 * i + 24, true));
    return { kind, id: t.u32(0), sequence: t.u64(2), materials };
  }
  if (kind === 'Attach') {
    const at = t.struct(0, 16);
    const half = (offset) => t.data.getBigUint64(at + offset, true).toString(16).padStart(16, '0');
    return { kind, editor: half(8) + half(0), seenRevision: t.u64(1) };
  }
  if (kind === 'GetChunks') {
    const { at, count } = t.vector(0, 40);
    const requests = Array.from({ length: count }, (_, i) => {
      const number = (offset) => t.data.getInt32(at + 40 * i + offset, true);
      const half = (offset) => t.data.getBigUint64(at + 40 * i + offset, true).toString(16).padStart(16, '0');
      const key = { lod: t.data.getUint8(at + 40 * i + 16), x: number(4), y: number(8), z: number(12) };
      return { id: number(0), key, known: t.data.getUint8(at + 40 * i + 20) === 1 ? half(32) + half(24) : null };
    });
    return { kind, id: requests[0].id, requests };
  }
  if (kind === 'View') {
    const { at, count } = t.vector(5, 32);
    const known = Array.from({ length: count }, (_, i) => {
      const number = (offset) => t.data.getInt32(at + 32 * i + offset, true);
      return `${t.data.getUint8(at + 32 * i + 12)}/${number(0)}/${number(4)}/${number(8)}`;
    });
    return { kind, known, number: t.u32(6), hasBase: t.bool(8) };
  }
  if (kind === 'Hello') return { kind, versions: [t.u16(0), t.u16(1)] };
  return { kind };
}

/** One connection, from the server's side. */
class Side {
  constructor(events) {
    this.events = events;
    this.heard = [];
    this.pings = 0;
    this.waiting = null;
  }
  hear(bytes) {
    const message = read(bytes);
    if (message.kind === 'Ping') ++this.pings;
    if (message.kind === 'Ping' || message.kind === 'Credit') return;
    this.heard.push(message);
    this.waiting?.();
  }
  /** The next message, which must be of that kind. */
  async next(kind) {
    while (this.heard.length === 0) await new Promise((resolve) => (this.waiting = resolve));
    const message = this.heard.shift();
    assert.equal(message.kind, kind);
    return message;
  }
  say(...frames) {
    for (const bytes of frames) this.events.received(bytes);
  }
  breakOff(error) {
    this.events.ended(error);
  }
}

/** A client, and its connections one after the other. */
export function script(options = {}) {
  const sides = [];
  let waiting = null;
  const client = new StreamClient({ url: 'script:', reconnect: { firstDelayMs: 1, maxDelayMs: 1 }, ...options }, (events) => {
    const side = new Side(events);
    sides.push(side);
    queueMicrotask(() => (events.opened(), waiting?.()));
    return { send: (bytes) => side.hear(bytes), close: () => {} };
  });
  return {
    client,
    /** The next connection, after its Hello. */
    async accept(...welcomes) {
      while (sides.length === 0) await new Promise((resolve) => (waiting = resolve));
      const side = sides.shift();
      side.hello = await side.next('Hello');
      side.say(...welcomes);
      return side;
    },
  };
}
