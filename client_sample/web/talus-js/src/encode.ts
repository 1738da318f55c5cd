// Encodes voxels, for pastes and for chunks that edits changed. Uses only the simplest of FORMAT.md's encodings:
// uniform, runs, raw. A server's payloads are shorter.
import { Encoder, intervals } from './codec/encoder.js';
import { LANES } from './codec/source.js';
import { TalusError } from './errors.js';
import type { Voxels } from './types.js';
import { uniformPayload } from './uniform.js';

const VOLUME = 32_768;
const MAX_MATERIALS = 256;
const DIGIT_COUNTS = 16;

/** Returns a payload that decodeChunk() and every server can read. */
export function encodeChunk({ uniform, voxels }: Voxels): Uint8Array<ArrayBuffer> {
  if (voxels === null) return uniformPayload(uniform);
  if (voxels.length !== VOLUME) throw new TalusError('out_of_range', `encodeChunk: a chunk has ${VOLUME} voxels, not ${voxels.length}`);
  const materials: number[] = [];
  const lengths: number[] = [];
  for (let i = 0; i < VOLUME; ++i) {
    if (i > 0 && voxels[i] === voxels[i - 1]) {
      ++lengths[lengths.length - 1]!;
    } else {
      materials.push(voxels[i]!);
      lengths.push(1);
    }
  }
  if (materials.length === 1) return uniformPayload(materials[0]!);
  const runs = materials.length < VOLUME ? encodeRuns(materials, lengths) : null;
  return runs !== null && runs.length < 2 * VOLUME + 2 ? runs : raw(voxels);
}

function raw(voxels: Uint16Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(2 * VOLUME + 2);
  bytes.set([4, 2]);
  const data = new DataView(bytes.buffer);
  for (let i = 0; i < VOLUME; ++i) data.setUint16(2 + 2 * i, voxels[i]!, true);
  return bytes;
}

function pushNumber(bytes: number[], value: number): void {
  for (; value >= 0x80; value >>= 7) bytes.push((value & 0x7f) | 0x80);
  bytes.push(value);
}

function starts(sizes: readonly number[]): number[] {
  let at = 0;
  return sizes.map((size) => (at += size) - size);
}

/** FORMAT.md, "Runs"; null if there are too many materials. */
function encodeRuns(materials: readonly number[], lengths: readonly number[]): Uint8Array<ArrayBuffer> | null {
  const ids = [...new Set(materials)].sort((a, b) => a - b);
  if (ids.length > MAX_MATERIALS) return null;
  const placeOf = new Map(ids.map((id, place) => [id, place]));
  const places = materials.map((id) => placeOf.get(id)!);
  const uses = new Array<number>(ids.length).fill(0);
  for (const place of places) ++uses[place]!;
  const digitsOf = (value: number) => 32 - Math.clz32(value);
  const digitUses = new Array<number>(DIGIT_COUNTS).fill(0);
  for (const length of lengths) ++digitUses[digitsOf(length - 1)]!;
  // A size of 256 does not fit its byte: if all lengths are equal, another size becomes 1.
  const sizes = intervals(uses, 256);
  const digitSizes = intervals(digitUses, 255);
  const bytes = [4, 3];
  pushNumber(bytes, ids.length);
  for (const id of ids) pushNumber(bytes, id);
  for (const size of sizes) bytes.push(size - 1);
  pushNumber(bytes, materials.length);
  bytes.push(...digitSizes);

  const encoder = new Encoder();
  const first = starts(sizes);
  const firstDigits = starts(digitSizes);
  for (let from = 0; from < places.length; from += LANES) {
    const count = Math.min(LANES, places.length - from);
    for (let i = 0; i < count; ++i) {
      const digits = digitsOf(lengths[from + i]! - 1);
      encoder.symbol(i, firstDigits[digits]!, digitSizes[digits]!);
    }
    let bits = 0; // in `rest`, not yet written
    let rest = 0;
    for (let i = 0; i < count; ++i) {
      const value = lengths[from + i]! - 1;
      const below = digitsOf(value) - 1;
      if (below < 1) continue;
      rest |= (value & ((1 << below) - 1)) << bits;
      for (bits += below; bits >= 8; bits -= 8, rest >>>= 8) encoder.byte(rest & 0xff);
    }
    if (bits > 0) encoder.byte(rest & 0xff);
    for (let i = 0; i < count; ++i) encoder.symbol(i, first[places[from + i]!]!, sizes[places[from + i]!]!);
  }
  return Uint8Array.from([...bytes, ...encoder.finish()]);
}
