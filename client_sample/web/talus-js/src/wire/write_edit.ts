// A client's edit messages: Attach and Edit of protocol/schema/talus.fbs.
import type { Builder, Offset } from 'flatbuffers';
import type { VoxelWrite } from '../edits/types.js';
import type { Position } from '../types.js';
import { frame, structs, writeHash } from './write.js';

export interface WireFill {
  readonly first: Position;
  readonly last: Position;
  readonly material: number;
  readonly only: number;
  /** 1: all materials, `only` is ignored; 2: as generated, `material` is ignored. */
  readonly flags: number;
}

export interface WireEdit {
  readonly guards: readonly VoxelWrite[];
  readonly writes: readonly VoxelWrite[];
  readonly fills: readonly WireFill[];
  readonly paste: { readonly origin: Position; readonly payload: Uint8Array; readonly withAir: boolean } | null;
  /** Empty: the session's own. */
  readonly subject: string;
}

const VOXEL_BYTES = 24;

function writeVoxel(builder: Builder, { x, y, z }: Position): void {
  builder.writeInt64(BigInt(z));
  builder.writeInt64(BigInt(y));
  builder.writeInt64(BigInt(x));
}

function writeWrites(builder: Builder, list: readonly VoxelWrite[]): Offset {
  if (list.length === 0) return 0;
  return structs(builder, list, VOXEL_BYTES + 8, 8, ({ voxel, material }) => {
    builder.pad(6);
    builder.writeInt16(material);
    writeVoxel(builder, voxel);
  });
}

function writeFills(builder: Builder, fills: readonly WireFill[]): Offset {
  if (fills.length === 0) return 0;
  return structs(builder, fills, 2 * VOXEL_BYTES + 8, 8, (fill) => {
    builder.pad(3);
    builder.writeInt8(fill.flags);
    builder.writeInt16(fill.only);
    builder.writeInt16(fill.material);
    writeVoxel(builder, fill.last);
    writeVoxel(builder, fill.first);
  });
}

function writePaste(builder: Builder, paste: WireEdit['paste']): Offset {
  if (paste === null) return 0;
  const payload = builder.createByteVector(paste.payload);
  builder.startObject(3);
  builder.prep(8, VOXEL_BYTES);
  writeVoxel(builder, paste.origin);
  builder.addFieldStruct(0, builder.offset(), 0);
  builder.addFieldOffset(1, payload, 0);
  builder.addFieldInt8(2, paste.withAir ? 1 : 0, 0);
  return builder.endObject();
}

/** REQUIRES: coordinates are safe integers, materials 0 to 65,535. */
export function editFrame(id: number, sequence: bigint, edit: WireEdit): Uint8Array {
  return frame(7, (builder) => {
    const writes = writeWrites(builder, edit.writes);
    const guards = writeWrites(builder, edit.guards);
    const fills = writeFills(builder, edit.fills);
    const paste = writePaste(builder, edit.paste);
    const subject = edit.subject === '' ? 0 : builder.createString(edit.subject);
    builder.startObject(7);
    builder.addFieldInt64(2, sequence, 0n);
    builder.addFieldInt32(0, id, 0);
    builder.addFieldOffset(1, writes, 0);
    builder.addFieldOffset(3, guards, 0);
    builder.addFieldOffset(4, fills, 0);
    builder.addFieldOffset(5, paste, 0);
    builder.addFieldOffset(6, subject, 0);
    return builder.endObject();
  });
}

export function attachFrame(editor: string, seenRevision: bigint): Uint8Array {
  return frame(20, (builder) => {
    builder.startObject(2);
    builder.prep(8, 16);
    writeHash(builder, editor);
    builder.addFieldStruct(0, builder.offset(), 0);
    builder.addFieldInt64(1, seenRevision, 0n);
    return builder.endObject();
  });
}
