// XXH3-128 with seed 0 (xxHash 0.8) of the 65,536 bytes of a chunk's voxels, without BigInt: 64-bit numbers are pairs
// of 32-bit halves, low first. Implements only the long form of the hash, for this length.
import type { Voxels } from './types.js';

const VOLUME = 32_768;
const BYTES = 2 * VOLUME;
const STRIPE_WORDS = 16; // 32-bit words
const BLOCK_STRIPES = 16;
const STRIPES = BYTES / 64;

const SECRET = Uint8Array.from(
  (
    'b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221' +
    'b8084674f743248ee03590e6813a264c3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8' +
    'a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364eac5ac8334d3ebc3c581a0fffa1363eb' +
    '170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e'
  ).match(/../g)!,
  (byte) => parseInt(byte, 16),
);

type Words = Int32Array;

/** Words of the secret, starting at byte `at`. */
function secretWords(at: number, words: number): Words {
  return Int32Array.from({ length: words }, (_, i) => {
    const byte = at + 4 * i;
    return SECRET[byte]! | (SECRET[byte + 1]! << 8) | (SECRET[byte + 2]! << 16) | (SECRET[byte + 3]! << 24);
  });
}

/** PRIME32_3, PRIME64_1 to PRIME64_4, PRIME32_2, PRIME64_5, PRIME32_1, in the order of the accumulators. */
const FIRST = [
  0xc2b2ae3d, 0, 0x85ebca87, 0x9e3779b1, 0x27d4eb4f, 0xc2b2ae3d, 0x9e3779f9, 0x165667b1, 0xc2b2ae63, 0x85ebca77,
  0x85ebca77, 0, 0x165667c5, 0x27d4eb2f, 0x9e3779b1, 0,
];
const PRIME32_1 = 0x9e3779b1 | 0;

class Hasher {
  private readonly words = new Int32Array(BYTES / 4);
  readonly voxels = new Uint16Array(this.words.buffer);
  private readonly sums = new Int32Array(16);
  private readonly stripeSecrets = secretWords(0, STRIPE_WORDS + 2 * (BLOCK_STRIPES - 1));
  private readonly lastSecret = secretWords(192 - 64 - 7, STRIPE_WORDS);
  private readonly scrambleSecret = secretWords(192 - 64, STRIPE_WORDS);
  private readonly lowSecret = secretWords(11, STRIPE_WORDS);
  private readonly highSecret = secretWords(192 - 64 - 11, STRIPE_WORDS);

  /** Hash of `voxels` as 32 hexadecimal digits, high half first. */
  hash(): string {
    this.sums.set(FIRST);
    for (let stripe = 0; stripe < STRIPES - 1; ++stripe) {
      const inBlock = stripe % BLOCK_STRIPES;
      this.accumulate(stripe * STRIPE_WORDS, this.stripeSecrets, 2 * inBlock);
      if (inBlock === BLOCK_STRIPES - 1) this.scramble();
    }
    this.accumulate((STRIPES - 1) * STRIPE_WORDS, this.lastSecret, 0);
    // The length times PRIME64_1, and the complement of the length times PRIME64_2.
    const low = this.merge(this.lowSecret, 0x85ebca87 << 16, (0x9e3779b1 << 16) | (0x85ebca87 >>> 16));
    const high = this.merge(this.highSecret, ~(0x27d4eb4f << 16), ~((0xc2b2ae3d << 16) | (0x27d4eb4f >>> 16)));
    return high + low;
  }

  private accumulate(at: number, secret: Words, secretAt: number): void {
    const { words, sums } = this;
    for (let i = 0; i < STRIPE_WORDS; i += 2) {
      const low = words[at + i]!;
      const high = words[at + i + 1]!;
      const a = low ^ secret[secretAt + i]!;
      const b = high ^ secret[secretAt + i + 1]!;
      const lowHigh = Math.imul(a & 0xffff, b >>> 16);
      const highLow = Math.imul(a >>> 16, b & 0xffff);
      const middle = (Math.imul(a & 0xffff, b & 0xffff) >>> 16) + (lowHigh & 0xffff) + (highLow & 0xffff);
      const productLow = Math.imul(a, b);
      const productHigh = Math.imul(a >>> 16, b >>> 16) + (lowHigh >>> 16) + (highLow >>> 16) + (middle >>> 16);
      let sum = (sums[i]! + productLow) | 0;
      sums[i + 1] = sums[i + 1]! + productHigh + (isBelow(sum, productLow) ? 1 : 0);
      sums[i] = sum;
      const j = i ^ 2;
      sum = (sums[j]! + low) | 0;
      sums[j + 1] = sums[j + 1]! + high + (isBelow(sum, low) ? 1 : 0);
      sums[j] = sum;
    }
  }

  private scramble(): void {
    const { sums, scrambleSecret } = this;
    for (let i = 0; i < STRIPE_WORDS; i += 2) {
      const high = sums[i + 1]!;
      const low = sums[i]! ^ (high >>> 15) ^ scrambleSecret[i]!;
      sums[i] = Math.imul(low, PRIME32_1);
      sums[i + 1] = highOfProduct(low, PRIME32_1) + Math.imul(high ^ scrambleSecret[i + 1]!, PRIME32_1);
    }
  }

  private merge(secret: Words, startLow: number, startHigh: number): string {
    const { sums } = this;
    let low = startLow | 0;
    let high = startHigh | 0;
    for (let i = 0; i < STRIPE_WORDS; i += 4) {
      const [a, b, c, d] = multiply128(
        sums[i]! ^ secret[i]!,
        sums[i + 1]! ^ secret[i + 1]!,
        sums[i + 2]! ^ secret[i + 2]!,
        sums[i + 3]! ^ secret[i + 3]!,
      );
      const added = a ^ c;
      low = (low + added) | 0;
      high = (high + (b ^ d) + (isBelow(low, added) ? 1 : 0)) | 0;
    }
    // Avalanche.
    low ^= high >>> 5;
    const multiplied = Math.imul(low, 0x9e3779f9);
    high =
      (highOfProduct(low, 0x9e3779f9 | 0) + Math.imul(high, 0x9e3779f9) + Math.imul(low, 0x16566791)) | 0;
    low = multiplied ^ high;
    return hex(high) + hex(low);
  }
}

function isBelow(a: number, b: number): boolean {
  return (a ^ 0x80000000) < (b ^ 0x80000000);
}

/** The high 32 bits of an unsigned product. */
function highOfProduct(a: number, b: number): number {
  const lowHigh = Math.imul(a & 0xffff, b >>> 16);
  const highLow = Math.imul(a >>> 16, b & 0xffff);
  const middle = (Math.imul(a & 0xffff, b & 0xffff) >>> 16) + (lowHigh & 0xffff) + (highLow & 0xffff);
  return (Math.imul(a >>> 16, b >>> 16) + (lowHigh >>> 16) + (highLow >>> 16) + (middle >>> 16)) | 0;
}

/** The product of two 64-bit numbers, as four halves, lowest first. */
function multiply128(aLow: number, aHigh: number, bLow: number, bHigh: number): [number, number, number, number] {
  const parts = [
    [0, aLow, bLow],
    [1, aLow, bHigh],
    [1, aHigh, bLow],
    [2, aHigh, bHigh],
  ] as const;
  const halves = [0, 0, 0, 0, 0]; // sums of unsigned halves: exact, carried at the end
  for (const [at, a, b] of parts) {
    halves[at]! += Math.imul(a, b) >>> 0;
    halves[at + 1]! += highOfProduct(a, b) >>> 0;
  }
  for (let i = 0; i < 4; ++i) {
    halves[i + 1]! += Math.floor(halves[i]! / 0x100000000);
    halves[i] = halves[i]! | 0;
  }
  return [halves[0]!, halves[1]!, halves[2]!, halves[3]!];
}

function hex(word: number): string {
  return (word >>> 0).toString(16).padStart(8, '0');
}

let hasher: Hasher | undefined;

/** The content hash of a chunk, in the format of Chunk.hash. */
export function hashVoxels(chunk: Voxels): string {
  hasher ??= new Hasher();
  if (chunk.voxels === null) hasher.voxels.fill(chunk.uniform);
  else hasher.voxels.set(chunk.voxels);
  return hasher.hash();
}
