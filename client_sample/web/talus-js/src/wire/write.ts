// A client's messages: protocol/schema/talus.fbs. Field numbers are those of the schema's tables.
import { Builder, type Offset } from 'flatbuffers';
import type { ChunkKey, View } from '../types.js';

export interface KnownChunk {
  readonly key: ChunkKey;
  readonly hash: string;
}

export interface ChunkRequest {
  readonly id: number;
  readonly key: ChunkKey;
  readonly known: string | null;
}

/** Sizes of list entries, as in PROTOCOL.md, "Limits", and of the rest of a frame. */
export const CHUNK_REQUEST_BYTES = 40;
export const KNOWN_CHUNK_BYTES = 32;
export const COLUMN_BYTES = 16;
export const REST_BYTES = 128;

/** A frame with member `kind` of the union Body. */
export function frame(kind: number, write: (builder: Builder) => Offset): Uint8Array {
  const builder = new Builder(256);
  const body = write(builder);
  builder.startObject(2);
  builder.addFieldOffset(1, body, 0);
  builder.addFieldInt8(0, kind, 0);
  builder.finishSizePrefixed(builder.endObject());
  return builder.asUint8Array();
}

/** A vector of structs; `write` writes one, and builders write backwards. */
export function structs<T>(
  builder: Builder,
  entries: readonly T[],
  bytes: number,
  align: number,
  write: (entry: T) => void,
): Offset {
  builder.startVector(bytes, entries.length, align);
  for (let i = entries.length - 1; i >= 0; --i) {
    builder.prep(align, bytes);
    write(entries[i]!);
  }
  return builder.endVector();
}

export function writeHash(builder: Builder, hash: string): void {
  builder.writeInt64(BigInt(`0x${hash.slice(0, 16)}`));
  builder.writeInt64(BigInt(`0x${hash.slice(16)}`));
}

function writeKey(builder: Builder, key: ChunkKey): void {
  builder.pad(3);
  builder.writeInt8(key.lod);
  builder.writeInt32(key.z);
  builder.writeInt32(key.y);
  builder.writeInt32(key.x);
}

export function helloFrame(hello: {
  protocolMin: number;
  protocolMax: number;
  codecs: readonly number[];
  token: string;
  client: string;
  windowBytes: number;
}): Uint8Array {
  return frame(1, (builder) => {
    builder.startVector(1, hello.codecs.length, 1);
    for (let i = hello.codecs.length - 1; i >= 0; --i) builder.addInt8(hello.codecs[i]!);
    const codecs = builder.endVector();
    const token = builder.createString(hello.token);
    const client = builder.createString(hello.client);
    builder.startObject(6);
    builder.addFieldInt64(5, BigInt(hello.windowBytes), 0n);
    builder.addFieldOffset(4, client, 0);
    builder.addFieldOffset(3, token, 0);
    builder.addFieldOffset(2, codecs, 0);
    builder.addFieldInt16(1, hello.protocolMax, 0);
    builder.addFieldInt16(0, hello.protocolMin, 0);
    return builder.endObject();
  });
}

/** REQUIRES: the centre's coordinates are integers. */
export function viewFrame(view: View, number: number, known: readonly KnownChunk[], hasBase = false): Uint8Array {
  return frame(2, (builder) => {
    const knownChunks = structs(builder, known, KNOWN_CHUNK_BYTES, 8, (chunk) => {
      writeHash(builder, chunk.hash);
      writeKey(builder, chunk.key);
    });
    const rings = structs(builder, view.rings ?? [], 4, 2, (ring) => {
      builder.writeInt16(ring.radius);
      builder.pad(1);
      builder.writeInt8(ring.lod);
    });
    builder.startObject(9);
    builder.prep(8, 24);
    builder.writeInt64(BigInt(view.centre.z));
    builder.writeInt64(BigInt(view.centre.y));
    builder.writeInt64(BigInt(view.centre.x));
    builder.addFieldStruct(0, builder.offset(), 0);
    if (view.direction !== undefined) {
      builder.prep(4, 12);
      builder.writeFloat32(view.direction.z);
      builder.writeFloat32(view.direction.y);
      builder.writeFloat32(view.direction.x);
      builder.addFieldStruct(1, builder.offset(), 0);
    }
    builder.addFieldInt16(2, view.horizontalRadius, 0);
    builder.addFieldInt16(3, view.verticalRadius, 0);
    builder.addFieldOffset(4, rings, 0);
    builder.addFieldOffset(5, knownChunks, 0);
    builder.addFieldInt32(6, number, 0);
    builder.addFieldInt8(7, view.horizon ? 1 : 0, 0);
    builder.addFieldInt8(8, hasBase ? 1 : 0, 0);
    return builder.endObject();
  });
}

export function getChunksFrame(requests: readonly ChunkRequest[]): Uint8Array {
  return frame(3, (builder) => {
    const list = structs(builder, requests, CHUNK_REQUEST_BYTES, 8, (request) => {
      writeHash(builder, request.known ?? '0'.repeat(32));
      builder.pad(3);
      builder.writeInt8(request.known === null ? 0 : 1);
      writeKey(builder, request.key);
      builder.writeInt32(request.id);
    });
    builder.startObject(1);
    builder.addFieldOffset(0, list, 0);
    return builder.endObject();
  });
}

export function getHeightsFrame(
  id: number,
  columns: readonly { readonly x: number; readonly z: number }[],
  looks: boolean,
  fields: readonly number[],
): Uint8Array {
  return frame(5, (builder) => {
    const list = structs(builder, columns, COLUMN_BYTES, 8, (column) => {
      builder.writeInt64(BigInt(column.z));
      builder.writeInt64(BigInt(column.x));
    });
    const wanted = structs(builder, fields, 1, 1, (field) => builder.writeInt8(field));
    builder.startObject(4);
    builder.addFieldOffset(3, wanted, 0);
    builder.addFieldOffset(1, list, 0);
    builder.addFieldInt32(0, id, 0);
    builder.addFieldInt8(2, looks ? 1 : 0, 0);
    return builder.endObject();
  });
}

export function creditFrame(totalBytes: number): Uint8Array {
  return frame(6, (builder) => {
    builder.startObject(1);
    builder.addFieldInt64(0, BigInt(totalBytes), 0n);
    return builder.endObject();
  });
}

export function pingFrame(nonce: number): Uint8Array {
  return frame(8, (builder) => {
    builder.startObject(1);
    builder.addFieldInt64(0, BigInt(nonce), 0n);
    return builder.endObject();
  });
}
