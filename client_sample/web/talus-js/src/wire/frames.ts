// Splits a stream of bytes into frames: PROTOCOL.md, "Frames".
import { broken } from './table.js';

const LENGTH_BYTES = 4;
const MIN_FRAME_BYTES = 12;
export const MAX_SERVER_FRAME_BYTES = 262_144;

/** Takes bytes as they arrive, and returns complete frames with their lengths. Holds less than one frame. */
export class FrameReader {
  private held = new Uint8Array(0);
  private count = 0;

  /** Calls `handle` for each frame that `bytes` completes; the frame is valid only during the call. Throws a TalusError
   *  if the bytes are not frames; the reader must then be dropped. */
  push(bytes: Uint8Array, handle: (frame: Uint8Array) => void): void {
    let rest = bytes;
    while (rest.length > 0) {
      if (this.count === 0) {
        const size = frameBytes(rest);
        if (size !== null && size <= rest.length) {
          handle(rest.subarray(0, size)); // without a copy
          rest = rest.subarray(size);
          continue;
        }
      }
      // A frame that began before these bytes, or continues after them.
      const known = this.count < LENGTH_BYTES ? LENGTH_BYTES : frameBytes(this.held)!;
      const taken = Math.min(known - this.count, rest.length);
      this.keep(rest.subarray(0, taken));
      rest = rest.subarray(taken);
      if (this.count >= LENGTH_BYTES && this.count === frameBytes(this.held)) {
        const frame = this.held.subarray(0, this.count);
        this.count = 0;
        handle(frame);
      }
    }
  }

  /** Grows with the bytes received, not with the length claimed. */
  private keep(bytes: Uint8Array): void {
    if (this.count + bytes.length > this.held.length) {
      const grown = new Uint8Array(Math.max(1_024, 2 * this.held.length, this.count + bytes.length));
      grown.set(this.held.subarray(0, this.count));
      this.held = grown;
    }
    this.held.set(bytes, this.count);
    this.count += bytes.length;
  }
}

/** The size that the beginning of an HTTP answer would announce. */
const HTTP_BYTES = 0x50545448 + LENGTH_BYTES;

/** Length of the frame that begins here; null: not enough bytes. */
function frameBytes(bytes: Uint8Array): number | null {
  if (bytes.length < LENGTH_BYTES) return null;
  const size = (bytes[0]! | (bytes[1]! << 8) | (bytes[2]! << 16)) + bytes[3]! * 0x1000000 + LENGTH_BYTES;
  if (size === HTTP_BYTES) throw broken('HTTP, not frames: connect by http:// or ws:// there');
  if (size < MIN_FRAME_BYTES || size > MAX_SERVER_FRAME_BYTES) {
    throw broken(`a frame of ${size} bytes; frames have ${MIN_FRAME_BYTES} to ${MAX_SERVER_FRAME_BYTES}`);
  }
  return size;
}
