// Numbers of up to 15 bits in groups of up to sixteen: FORMAT.md, "Digits".
import type { Slots, Source } from './source.js';

/** Reads `count` numbers into `numbers`. May read past the end: the caller checks. */
export function readDigits(source: Source, counts: Slots, count: number, numbers: Int32Array): void {
  for (let i = 0; i < count; ++i) numbers[i] = source.read(counts, i);
  let bits = 0; // read from the payload and not yet used, in `rest`
  let rest = 0;
  for (let i = 0; i < count; ++i) {
    const digits = numbers[i]!;
    if (digits < 2) continue;
    while (bits < digits - 1) {
      rest |= source.bytes[source.next++]! << bits;
      bits += 8;
    }
    const highest = 1 << (digits - 1);
    numbers[i] = highest | (rest & (highest - 1));
    rest >>>= digits - 1;
    bits -= digits - 1;
  }
}
