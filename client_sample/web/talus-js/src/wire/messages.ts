// A server's messages: protocol/schema/talus.fbs, read and checked. Field numbers are those of the schema's tables.
import type { EditLimits } from '../edits/types.js';
import type { ChunkKey, Limits, Material, Phase, Position, Rates, World } from '../types.js';
import { checkHeights } from './heights.js';
import { broken, Frame, type Table } from './table.js';

export const ERROR_CODES = [
  'none', 'version', 'malformed', 'unexpected', 'too_large', 'too_many_requests', 'out_of_range', 'cancelled',
  'unsupported', 'unauthorized', 'overloaded', 'timeout', 'duplicate_id', 'internal', 'forbidden',
  'conflict', 'expired', 'not_applied',
] as const;
export type ErrorCode = (typeof ERROR_CODES)[number] | 'unknown';

export const ERROR_ABOUTS = [
  'unspecified', 'connection', 'request', 'repeated_request', 'view', 'view_chunk', 'ping', 'attach',
] as const;
export type ErrorAbout = (typeof ERROR_ABOUTS)[number];

const PHASES: readonly Phase[] = ['gas', 'liquid', 'solid'];

export interface UniformRun {
  readonly firstY: number;
  readonly lastY: number;
  readonly material: number;
}

export type ServerMessage =
  | { readonly kind: 'welcome'; readonly world: World }
  | {
      readonly kind: 'chunk';
      readonly id: number;
      readonly key: ChunkKey;
      readonly revision: bigint;
      readonly hash: string;
      readonly codec: number;
      readonly payload: Uint8Array<ArrayBuffer>;
    }
  | {
      readonly kind: 'unchanged';
      readonly id: number;
      readonly key: ChunkKey;
      readonly revision: bigint;
      readonly hash: string;
    }
  | {
      readonly kind: 'uniform_column';
      readonly x: number;
      readonly z: number;
      readonly lod: number;
      readonly revision: bigint;
      readonly runs: readonly UniformRun[];
    }
  | {
      readonly kind: 'heights';
      readonly id: number;
      readonly heightsFx: Int32Array;
      readonly looks: Uint8Array;
      readonly values: Float32Array;
    }
  | {
      readonly kind: 'error';
      readonly code: ErrorCode;
      readonly text: string;
      readonly requestId: number;
      readonly retryAfterMs: number;
      readonly about: ErrorAbout;
      readonly repeatedId: number;
      readonly viewNumber: number;
      readonly chunk: ChunkKey | null;
    }
  | { readonly kind: 'edit_result'; readonly id: number; readonly revision: bigint; readonly changed: number }
  | {
      readonly kind: 'edit_broadcast';
      readonly key: ChunkKey;
      readonly revision: bigint;
      readonly previousRevision: bigint;
      /** For readRuns(). */
      readonly runs: Uint8Array;
    }
  | {
      readonly kind: 'attached';
      readonly editor: string;
      readonly epoch: bigint;
      readonly lastSequence: bigint;
      readonly known: boolean;
      readonly revision: bigint;
      readonly limits: EditLimits;
    }
  | { readonly kind: 'pong'; readonly nonce: bigint }
  | { readonly kind: 'go_away'; readonly reason: string; readonly retryAfterMs: number }
  | { readonly kind: 'view_complete'; readonly number: number };

type Reader = (body: Table) => ServerMessage;

/** By index in the union Body; 1 to 8 and 20 are sent by clients. */
const READERS: Record<number, Reader> = {
  9: readWelcome,
  10: (body) => ({
    kind: 'chunk',
    id: body.u32(0),
    key: readKey(body, 1),
    revision: body.u64(2),
    hash: readHash(body, 3),
    codec: body.u8(4),
    payload: body.bytesOf(5),
  }),
  11: (body) => ({
    kind: 'unchanged',
    id: body.u32(0),
    key: readKey(body, 1),
    revision: body.u64(2),
    hash: readHash(body, 3),
  }),
  12: readUniformColumn,
  13: readHeights,
  14: (body) => ({
    kind: 'error',
    code: ERROR_CODES[body.u16(0)] ?? 'unknown',
    text: body.text(1),
    requestId: body.u32(2),
    retryAfterMs: body.u32(3),
    about: ERROR_ABOUTS[body.u8(4)] ?? 'unspecified',
    repeatedId: body.u32(5),
    viewNumber: body.u32(6),
    chunk: body.struct(7, 16) === 0 ? null : readKey(body, 7),
  }),
  15: (body) => ({ kind: 'edit_result', id: body.u32(0), revision: body.u64(1), changed: body.u32(2) }),
  16: (body) => ({
    kind: 'edit_broadcast',
    key: readKey(body, 0),
    revision: body.u64(1),
    previousRevision: body.u64(2),
    runs: body.bytesOf(4),
  }),
  17: (body) => ({ kind: 'pong', nonce: body.u64(0) }),
  18: (body) => ({ kind: 'go_away', reason: body.text(0), retryAfterMs: body.u32(1) }),
  19: (body) => ({ kind: 'view_complete', number: body.u32(0) }),
  21: (body) => ({
    kind: 'attached',
    editor: readHash(body, 0),
    epoch: body.u64(1),
    lastSequence: body.u64(2),
    known: body.bool(3),
    revision: body.u64(4),
    limits: readEditLimits(body.table(5)),
  }),
};

/** The message of a frame with its length. Throws a TalusError if a server never sends it. */
export function readMessage(bytes: Uint8Array): ServerMessage {
  const root = new Frame(bytes).root();
  const kind = root.u8(0);
  const reader = READERS[kind];
  const body = root.table(1);
  if (reader === undefined || body === null) throw broken(`a message of kind ${kind}, which no server sends`);
  return reader(body);
}

/** Does not check that it lies in the world: a client accepts only chunks that it requested. */
function readKey(body: Table, field: number): ChunkKey {
  const at = body.struct(field, 16);
  if (at === 0) throw broken('a chunk without a key');
  return {
    lod: body.data.getUint8(at + 12),
    x: body.data.getInt32(at, true),
    y: body.data.getInt32(at + 4, true),
    z: body.data.getInt32(at + 8, true),
  };
}

function hex64(data: DataView, at: number): string {
  const digits = (word: number) => word.toString(16).padStart(8, '0');
  return digits(data.getUint32(at + 4, true)) + digits(data.getUint32(at, true));
}

/** 32 digits, high half first. */
function readHash(body: Table, field: number): string {
  const at = body.struct(field, 16);
  return at === 0 ? '0'.repeat(32) : hex64(body.data, at + 8) + hex64(body.data, at);
}

/** Converts a 64-bit number to a safe integer. */
function exact(value: bigint, what: string): number {
  const number = Number(value);
  if (!Number.isSafeInteger(number)) throw broken(`${what} ${value}, which is beyond any world`);
  return number;
}

function readPosition(body: Table, field: number, what: string): Position {
  const at = body.struct(field, 24);
  if (at === 0) return { x: 0, y: 0, z: 0 };
  const axis = (i: number) => exact(body.data.getBigInt64(at + 8 * i, true), what);
  return { x: axis(0), y: axis(1), z: axis(2) };
}

function readRates(table: Table | null): Rates | null {
  if (table === null) return null;
  return {
    chunks: Number(table.u64(0)),
    bytes: Number(table.u64(1)),
    requests: Number(table.u64(2)),
    burstMs: table.u32(3),
  };
}

function readLimits(table: Table | null): Limits {
  if (table === null) throw broken('a Welcome without limits');
  return {
    frameBytes: table.u32(0),
    requestsInFlight: table.u32(1),
    heightsPerRequest: table.u32(2),
    viewHorizontalRadius: table.u16(3),
    viewVerticalRadius: table.u16(4),
    viewChunks: table.u32(5),
    windowBytes: Number(table.u64(6)),
    idleTimeoutMs: table.u32(7),
    sessionRates: readRates(table.table(8)),
    addressRates: readRates(table.table(9)),
    viewHorizon: table.bool(10),
    viewBase: table.bool(11),
  };
}

function readEditLimits(table: Table | null): EditLimits {
  if (table === null) throw broken('an Attached without limits');
  return {
    voxels: table.u32(0),
    chunks: table.u32(1),
    unanswered: table.u32(2),
    voxelsPerSecond: Number(table.u64(3)),
  };
}

function readMaterial(table: Table): Material {
  return {
    id: table.u16(0),
    name: table.text(1),
    colour: table.u32(2),
    phase: PHASES[table.u8(3)] ?? 'solid',
  };
}

function readWelcome(body: Table): ServerMessage {
  const chunkSize = body.u16(4);
  if (chunkSize !== 32) throw broken(`a Welcome with chunks of ${chunkSize} voxels; this client knows 32`);
  const world: World = {
    protocol: body.u16(0),
    fingerprint: readHash(body, 2),
    storeId: readHash(body, 3),
    codec: body.u8(1),
    materials: body.tables(5, readMaterial),
    minY: exact(body.i64(6), 'min_y'),
    maxY: exact(body.i64(7), 'max_y'),
    spawn: readPosition(body, 8, 'a spawn at'),
    limits: readLimits(body.table(9)),
    server: body.text(10),
    looks: body.texts(11),
    fields: body.texts(12),
    worldFile: body.text(13),
  };
  checkHeights(world);
  return { kind: 'welcome', world };
}

function readUniformColumn(body: Table): ServerMessage {
  const { at, count } = body.vector(4, 12);
  const runs: UniformRun[] = [];
  for (let i = 0; i < count; ++i) {
    const run = at + 12 * i;
    runs.push({
      firstY: body.data.getInt32(run, true),
      lastY: body.data.getInt32(run + 4, true),
      material: body.data.getUint16(run + 8, true),
    });
  }
  return { kind: 'uniform_column', x: body.i32(0), z: body.i32(1), lod: body.u8(2), revision: body.u64(3), runs };
}

function readHeights(body: Table): ServerMessage {
  const heights = body.vector(1, 4);
  const values = body.vector(3, 4);
  return {
    kind: 'heights',
    id: body.u32(0),
    heightsFx: Int32Array.from({ length: heights.count }, (_, i) => body.data.getInt32(heights.at + 4 * i, true)),
    looks: body.bytesOf(2),
    values: Float32Array.from({ length: values.count }, (_, i) => body.data.getFloat32(values.at + 4 * i, true)),
  };
}
