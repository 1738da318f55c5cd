// A payload's bytes, and the interleaved rANS states that read from them: FORMAT.md, "Entropy coding". The end is
// checked after each step of several hundred bytes, not at each byte, so the bytes are copied to a buffer with MARGIN
// more readable bytes.
import { DecodeError } from './decode_error.js';

export const LANES = 16;
const MIN_STATE = 256;
const STATES_BYTES = 2 * LANES;
export const MAX_PAYLOAD_BYTES = 65_538;
/** Upper bound of a step: a volume's batch has 256 symbols, 256 escapes, and 17 groups of exceptions of 62 bytes. */
const MARGIN = 4_096;

/** Intervals of up to 256 values, by slot: value | start << 8 | size << 16. */
export type Slots = Int32Array;

export class Source {
  readonly bytes = new Uint8Array(MAX_PAYLOAD_BYTES + MARGIN);
  readonly states = new Int32Array(LANES);
  next = 0;
  end = 0;

  /** Begins at the body of `payload`, after version and encoding. */
  begin(payload: Uint8Array): void {
    this.bytes.set(payload);
    this.next = 2;
    this.end = payload.length;
  }

  left(): number {
    return this.end - this.next;
  }

  /** A varint of at most 65,535, in its shortest form. */
  number(): number {
    let value = 0;
    for (let shift = 0; shift <= 14; shift += 7) {
      if (this.next >= this.end) throw new DecodeError('truncated');
      const byte = this.bytes[this.next++]!;
      value |= (byte & 0x7f) << shift;
      if (byte >= 0x80) continue;
      if ((byte === 0 && shift > 0) || value > 0xffff) break;
      return value;
    }
    throw new DecodeError('bad_number');
  }

  /** A list of 1 to `maxCount` ids; the caller must check their order. */
  materials(maxCount: number): number[] {
    const count = this.number();
    if (count === 0 || count > maxCount) throw new DecodeError('bad_materials');
    const ids: number[] = [];
    for (let i = 0; i < count; ++i) ids.push(this.number());
    return ids;
  }

  takeStates(): void {
    if (this.left() < STATES_BYTES) throw new DecodeError('truncated');
    for (let i = 0; i < LANES; ++i) {
      const state = this.bytes[this.next]! | (this.bytes[this.next + 1]! << 8);
      if (state < MIN_STATE) throw new DecodeError('bad_ending');
      this.states[i] = state;
      this.next += 2;
    }
  }

  /** Reads one symbol with state `lane`. May read past the end: the caller checks. */
  read(slots: Slots, lane: number): number {
    let state = this.states[lane]!;
    const slot = slots[state & 0xff]!;
    state = (slot >>> 16) * (state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff);
    if (state < MIN_STATE) state = (state << 8) | this.bytes[this.next++]!;
    this.states[lane] = state;
    return slot & 0xff;
  }

  checkRead(): void {
    if (this.next > this.end) throw new DecodeError('truncated');
  }

  checkAllRead(): void {
    if (this.next !== this.end) throw new DecodeError('too_long');
  }

  checkFinalStates(): void {
    for (let i = 0; i < LANES; ++i) {
      if (this.states[i] !== MIN_STATE) throw new DecodeError('bad_ending');
    }
  }
}

/** Fills `slots` with adjacent intervals of `sizes` from 0, which must end at 256. */
export function fillSlots(slots: Slots, sizes: ArrayLike<number>): void {
  let start = 0;
  for (let i = 0; i < sizes.length; ++i) {
    const size = sizes[i]!;
    if (start + size > 256) throw new DecodeError('bad_number');
    slots.fill(i | (start << 8) | (size << 16), start, start + size);
    start += size;
  }
  if (start !== 256) throw new DecodeError('bad_number');
}
