// The probabilities of a column's symbol: FORMAT.md, "Layered: the model". Terrain has few neighbourhoods, which come
// again and again: a cache keeps the intervals of each.
import { fillSlots } from './source.js';
import { OTHER_START, SAME_END, UP_SPLIT, WEIGHTS } from './plane_weights.js';

export const LEVEL = 0;
export const CARRIED = 1;
export const FIRST = 2;

// Where the features of a column lie in its key, two bits each. Five cells of six bits hold a sign of a step, how the
// row rises to its west, and a thickness: of the columns from two to the west (highest) to two to the east. What of them
// is no feature makes room for other features.
export const STEP_BITS = 0;
export const RISE_BITS = 2;
export const THICKNESS_BITS = 4;
export const CELL_BITS = 6;
const STEP_FAR_EAST = 0;
const STEP_EAST = 6;
const EAST = 8;
const THICKNESS_EAST = 10;
const STEP = 12;
const WEST = 14;
const THICKNESS = 16;
const STEP_WEST = 18;
const THICKNESS_WEST = 22;
const STEP_FAR_WEST = 24;
/** The features that a key has from the cells. */
export const FROM_CELLS = [
  STEP_FAR_EAST, STEP_EAST, EAST, THICKNESS_EAST, STEP, WEST, THICKNESS, STEP_WEST, THICKNESS_WEST, STEP_FAR_WEST,
].reduce((mask, at) => mask | (3 << at), 0);
export const SYMBOL_WEST = 2;
export const SYMBOL_EAST = 4;
export const KIND = 20;
export const FAR_EAST = 26;
const FLOOR = 28;

const PAIRS = [
  [STEP_WEST, STEP_EAST],
  [FLOOR, THICKNESS_EAST],
  [WEST, EAST],
  [STEP, STEP_FAR_WEST],
  [FAR_EAST, STEP_FAR_EAST],
  [THICKNESS_WEST, THICKNESS_EAST],
  [WEST, THICKNESS],
  [EAST, THICKNESS],
  [FLOOR, THICKNESS],
  [WEST, SYMBOL_WEST],
  [EAST, SYMBOL_EAST],
  [THICKNESS, SYMBOL_WEST],
  [THICKNESS, SYMBOL_EAST],
] as const;
const FIRST_OF_PAIR = Uint8Array.from(PAIRS, ([first]) => first);
const SECOND_OF_PAIR = Uint8Array.from(PAIRS, ([, second]) => second);
const EVEN_PAIRS = 9;
const CLASSES = 16;

function parseWeights(): Int8Array[] {
  return WEIGHTS.map((text) => Int8Array.from(text.trim().split(/\s+/), Number));
}

// Steep land has some hundred thousand keys, and a chunk of it asks for a thousand of them.
const CACHE_BITS = 15;

/** The intervals of even columns, or of odd ones, by key. */
export class PlaneModel {
  /** Of a key the place is cachePlace(key): there stands which key it is that the cache has, and then where in
   *  planeSlots() its intervals begin. */
  readonly cache = new Int32Array(2 << CACHE_BITS).fill(-1);
  private readonly weights: Int8Array[];
  private readonly pairs: number;

  constructor(odd: boolean) {
    this.weights = parseWeights().filter((_, i) => (i % 2 === 1) === odd);
    this.pairs = odd ? PAIRS.length : EVEN_PAIRS;
  }

  /** Puts the intervals of `key` where they belong. */
  readonly fill = (key: number, place: number): number => {
    const weights = this.weights[(key >>> KIND) & 3]!;
    let same = 0;
    let up = 0;
    for (let p = 0; p < this.pairs; ++p) {
      const at = p * 32 + ((key >>> FIRST_OF_PAIR[p]!) & 3) + 4 * ((key >>> SECOND_OF_PAIR[p]!) & 3);
      same = Math.max(-128, Math.min(127, same + weights[at]!));
      up = Math.max(-128, Math.min(127, up + weights[at + 16]!));
    }
    const intervals = ((Math.max(same, 0) >> 3) * CLASSES + (Math.max(up, 0) >> 3)) << 8;
    this.cache[place] = key;
    this.cache[place + 1] = intervals;
    return intervals;
  };
}

/** By the classes of both scores and then by slot: symbol | start << 8 | size << 16. */
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

export function cachePlace(key: number): number {
  return (Math.imul(key, 0x9e3779b1 | 0) >>> (32 - CACHE_BITS)) << 1;
}
