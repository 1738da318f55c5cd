// Keys of a row's columns: the features around a column, two bits each. FORMAT.md, "Layered: the model".

const SIZE = 32;
const COLUMNS = 16; // columns of one parity in a row
const WORDS = SIZE / 4;

// Five cells of six bits hold the sign of a step, the row's rise to its west, and a thickness, for the columns from two
// to the west (highest) to two to the east. Bits that are not features make room for other features.
const STEP_BITS = 0;
const RISE_BITS = 2;
const THICKNESS_BITS = 4;
const CELL_BITS = 6;
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
/** The features that a key takes from the cells. */
const FROM_CELLS = [
  STEP_FAR_EAST, STEP_EAST, EAST, THICKNESS_EAST, STEP, WEST, THICKNESS, STEP_WEST, THICKNESS_WEST, STEP_FAR_WEST,
].reduce((mask, at) => mask | (3 << at), 0);
const SYMBOL_WEST = 2;
const SYMBOL_EAST = 4;
export const KIND = 20;
const FAR_EAST = 26;
const FLOOR = 28;

/** The pairs of features that have weights; the last four apply to odd columns only. */
export const PAIRS = [
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

// Four columns at a time, a byte each: heights are at most 32, so a high bit is free to borrow from.
const ONES = 0x01010101;
const SEVENS = 0x7f7f7f7f;
const GUARDS = 0x80808080 | 0;

/** For bytes below 128: 2 if a > b, 1 if equal, 0 if a < b. */
export const signs = (a: number, b: number): number => {
  const notBelow = (((a | GUARDS) - b) >>> 7) & ONES;
  const notAbove = (((b | GUARDS) - a) >>> 7) & ONES;
  return notBelow + (notAbove ^ ONES);
};

const FLAT = (1 << STEP_BITS) | (1 << RISE_BITS);
const CELL_THICKNESS = 3 << THICKNESS_BITS;
const FROM_EXTRAS = (3 << FAR_EAST) | (3 << FLOOR);

export class PlaneKeys {
  readonly even = new Int32Array(COLUMNS);
  /** Without neighbouring symbols until addSymbols(). */
  readonly odd = new Int32Array(COLUMNS);

  /** Computes the keys of a row from the words of the row to its north, the floor of that row, its own floor, and the
   *  signs of the northern row's steps. */
  make(planeWords: Int32Array, north: number, floorNorth: number, floor: number, stepSigns: Int32Array, rowKind: number): void {
    const { even, odd } = this;
    const kind = rowKind << KIND;
    let here = planeWords[north]!;
    let before = here << 24; // the height west of this word, in the highest byte
    // For the previous word: its keys need the cells of this one.
    let cells = 0;
    let extras = 0;
    let window = 0;
    for (let i = 0; i <= WORDS; i = (i + 1) | 0) {
      let nextCells = FLAT | ((cells >>> 24) & CELL_THICKNESS) | (FLAT << 8); // beyond the row's end
      let nextExtras = 0;
      if (i < WORDS) {
        // Heights repeat beyond the row's end.
        const next = i < WORDS - 1 ? planeWords[(north + i + 1) | 0]! : Math.imul(here >>> 24, ONES);
        const below = planeWords[(floorNorth + i) | 0]!;
        const rises = signs(here, (here << 8) | (before >>> 24));
        const rises2 = signs((here >>> 16) | (next << 16), here);
        const thickness = here - below;
        const thick = (((thickness + SEVENS) >>> 7) & ONES) + (((thickness + SEVENS - ONES) >>> 7) & ONES);
        nextCells = (stepSigns[i]! << STEP_BITS) | (rises << RISE_BITS) | (thick << THICKNESS_BITS);
        nextExtras = rises2 | (signs(planeWords[(floor + i) | 0]!, below) << 2);
        before = here;
        here = next;
      }
      if (i === 0) {
        window = (FLAT << CELL_BITS) | FLAT | (nextCells & CELL_THICKNESS);
        window = (window << CELL_BITS) | (nextCells & 0xff);
        window = (window << CELL_BITS) | ((nextCells >>> 8) & 0xff);
      } else {
        const at = (i << 1) - 2;
        window = (window << CELL_BITS) | ((cells >>> 16) & 0xff);
        even[at] = (window & FROM_CELLS) | ((extras << FAR_EAST) & FROM_EXTRAS) | kind;
        window = (window << CELL_BITS) | (cells >>> 24);
        odd[at] = (window & FROM_CELLS) | ((extras << (FAR_EAST - 8)) & FROM_EXTRAS) | kind;
        window = (window << CELL_BITS) | (nextCells & 0xff);
        even[at + 1] = (window & FROM_CELLS) | ((extras << (FAR_EAST - 16)) & FROM_EXTRAS) | kind;
        window = (window << CELL_BITS) | ((nextCells >>> 8) & 0xff);
        odd[at + 1] = (window & FROM_CELLS) | ((extras << (FAR_EAST - 24)) & FROM_EXTRAS) | kind;
      }
      cells = nextCells;
      extras = nextExtras;
    }
  }

  /** Adds the symbols to the west and east to the keys of odd columns; four columns per word, 0 beyond the row. */
  addSymbols(symbolWords: Int32Array): void {
    const { odd } = this;
    let here = symbolWords[0]!;
    for (let i = 0; i < COLUMNS; i = (i + 2) | 0) {
      const next = symbolWords[(i >> 1) + 1]!;
      odd[i] = odd[i]! | ((here & 3) << SYMBOL_WEST) | (((here >>> 16) & 3) << SYMBOL_EAST);
      odd[i + 1] = odd[i + 1]! | (((here >>> 16) & 3) << SYMBOL_WEST) | ((next & 3) << SYMBOL_EAST);
      here = next;
    }
  }
}
