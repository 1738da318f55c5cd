// Inverse of Source: FORMAT.md, "Entropy coding". Records symbols in decoding order; the bytes are then produced from
// the last to the first.
import { LANES } from './source.js';

const FIRST_STATE = 256;

export class Encoder {
  /** A symbol: lane | start << 8 | size << 16; a plain byte: -1 - the byte. */
  private readonly steps: number[] = [];

  symbol(lane: number, start: number, size: number): void {
    this.steps.push(lane | (start << 8) | (size << 16));
  }

  byte(value: number): void {
    this.steps.push(-1 - value);
  }

  /** Sixteen states, then the coded bytes. */
  finish(): number[] {
    const states = new Array<number>(LANES).fill(FIRST_STATE);
    const backwards: number[] = [];
    for (let i = this.steps.length - 1; i >= 0; --i) {
      const step = this.steps[i]!;
      if (step < 0) {
        backwards.push(-1 - step);
        continue;
      }
      const lane = step & 0xff;
      const start = (step >> 8) & 0xff;
      const size = step >>> 16;
      let state = states[lane]!;
      if (state >= size * 256) {
        backwards.push(state & 0xff);
        state >>>= 8;
      }
      states[lane] = Math.floor(state / size) * 256 + (state % size) + start;
    }
    for (let lane = LANES - 1; lane >= 0; --lane) backwards.push(states[lane]! >>> 8, states[lane]! & 0xff);
    return backwards.reverse();
  }
}

/** Sizes of intervals that fill 0 to 255, as close to the counts as possible; none exceeds `maxSize`. */
export function intervals(counts: readonly number[], maxSize: number): number[] {
  const total = counts.reduce((sum, count) => sum + count, 0);
  const sizes = counts.map((count) => (count === 0 ? 0 : Math.min(maxSize, Math.max(1, Math.round((count * 256) / total)))));
  let left = 256 - sizes.reduce((sum, size) => sum + size, 0);
  // Adjusts the largest, where it matters least.
  for (; left !== 0; left -= Math.sign(left)) {
    let best = -1;
    for (let i = 0; i < sizes.length; ++i) {
      if (left > 0 && sizes[i]! >= maxSize) continue;
      if (best < 0 || sizes[i]! > sizes[best]!) best = i;
    }
    sizes[best]! += Math.sign(left);
  }
  return sizes;
}
