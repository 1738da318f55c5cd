// Probabilities of a column's symbol: FORMAT.md, "Layered: the model". Terrain repeats few neighbourhoods, so a cache
// holds the intervals of each.
import { KIND, PAIRS } from './plane_keys.js';
import { fillSlots } from './source.js';
import { OTHER_START, SAME_END, UP_SPLIT, WEIGHTS } from './plane_weights.js';

const FIRST_OF_PAIR = Uint8Array.from(PAIRS, ([first]) => first);
const SECOND_OF_PAIR = Uint8Array.from(PAIRS, ([, second]) => second);
const ROW_KIND: number = KIND;
const EVEN_PAIRS = 9;
const CLASSES = 16;

/** By pair and value of its features: the weight of the first score in the upper half, of the second in the lower. */
function parseWeights(text: string): Int32Array {
  const all = text.trim().split(/\s+/).map(Number);
  return Int32Array.from({ length: all.length / 2 }, (_, i) => {
    const at = ((i >> 4) << 5) | (i & 15);
    return (all[at]! << 16) | (all[at + 16]! & 0xffff);
  });
}

// Steep land has several hundred thousand keys; a chunk of it uses a thousand of them.
const PLACE_BITS = 16;
const REST_BITS = 32 - PLACE_BITS;
const REST = (1 << REST_BITS) - 1;
const EMPTY = 1 << 31;
const MIXER = 0x9e3779b1 | 0;
const KEYS = 16;

/** The intervals of even columns, or of odd ones, by key. */
export class PlaneModel {
  // A key times an odd number identifies the key: its upper bits are the place, the lower ones are stored there, below
  // the class of its intervals.
  private readonly cache = new Int32Array(1 << PLACE_BITS).fill(EMPTY);
  private readonly weights: Int32Array[];
  private readonly pairs: number;

  constructor(odd: boolean) {
    this.weights = WEIGHTS.filter((_, i) => (i % 2 === 1) === odd).map(parseWeights);
    this.pairs = odd ? PAIRS.length : EVEN_PAIRS;
  }

  /** Looks up the starts in planeSlots() of the intervals of sixteen keys. Unrolled four times, like
   *  LayersDecoder.readSymbols, without calls except for new keys. */
  look(keys: Int32Array, intervals: Int32Array): void {
    const { cache } = this;
    let missing = 0;
    let mixed = 0;
    let known = 0;
    for (let i = 0; i < KEYS; i = (i + 4) | 0) {
      mixed = Math.imul(keys[i]!, MIXER);
      known = cache[mixed >>> REST_BITS]!;
      missing |= known ^ (mixed & REST);
      intervals[i] = (known >>> REST_BITS) << 8;
      mixed = Math.imul(keys[i + 1]!, MIXER);
      known = cache[mixed >>> REST_BITS]!;
      missing |= known ^ (mixed & REST);
      intervals[i + 1] = (known >>> REST_BITS) << 8;
      mixed = Math.imul(keys[i + 2]!, MIXER);
      known = cache[mixed >>> REST_BITS]!;
      missing |= known ^ (mixed & REST);
      intervals[i + 2] = (known >>> REST_BITS) << 8;
      mixed = Math.imul(keys[i + 3]!, MIXER);
      known = cache[mixed >>> REST_BITS]!;
      missing |= known ^ (mixed & REST);
      intervals[i + 3] = (known >>> REST_BITS) << 8;
    }
    if ((missing & (REST | EMPTY)) !== 0) this.fill(keys, intervals);
  }

  private fill(keys: Int32Array, intervals: Int32Array): void {
    const { cache } = this;
    for (let i = 0; i < KEYS; ++i) {
      const mixed = Math.imul(keys[i]!, MIXER);
      let known = cache[mixed >>> REST_BITS]!;
      if (((known ^ (mixed & REST)) & (REST | EMPTY)) !== 0) {
        known = (this.classOf(keys[i]!) << REST_BITS) | (mixed & REST);
        cache[mixed >>> REST_BITS] = known;
      }
      intervals[i] = (known >>> REST_BITS) << 8;
    }
  }

  private classOf(key: number): number {
    const { pairs } = this;
    const weights = this.weights[(key >>> ROW_KIND) & 3]!;
    let same = 0;
    let up = 0;
    for (let p = 0; p < pairs; p = (p + 1) | 0) {
      const both = weights[(p << 4) | ((key >>> FIRST_OF_PAIR[p]!) & 3) | (((key >>> SECOND_OF_PAIR[p]!) & 3) << 2)]!;
      same = Math.max(-128, Math.min(127, (same + (both >> 16)) | 0));
      up = Math.max(-128, Math.min(127, (up + ((both << 16) >> 16)) | 0));
    }
    return (Math.max(same, 0) >> 3) * CLASSES + (Math.max(up, 0) >> 3);
  }
}

/** By the classes of both scores, then by slot: symbol | start << 8 | size << 16. */
export function planeSlots(): Int32Array {
  const slots = new Int32Array(CLASSES * CLASSES << 8);
  for (let same = 0; same < CLASSES; ++same) {
    const end = SAME_END[same]!;
    const other = OTHER_START[same]!;
    for (let up = 0; up < CLASSES; ++up) {
      const down = end + 1 + (((other - end - 2) * UP_SPLIT[up]!) >> 8);
      const begin = (same * CLASSES + up) << 8;
      fillSlots(slots.subarray(begin, begin + 256), [end, down - end, other - down, 256 - other]);
    }
  }
  return slots;
}
