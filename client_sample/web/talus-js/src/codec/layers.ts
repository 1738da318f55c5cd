// Layers: the boundary planes between materials. FORMAT.md, "Layered".
import { DecodeError } from './decode_error.js';
import {
  CARRIED,
  cachePlace,
  CELL_BITS,
  FAR_EAST,
  FIRST,
  FROM_CELLS,
  KIND,
  LEVEL,
  planeSlots,
  PlaneModel,
  RISE_BITS,
  STEP_BITS,
  SYMBOL_EAST,
  SYMBOL_WEST,
  THICKNESS_BITS,
} from './plane_model.js';
import { LANES, type Source } from './source.js';

const SIZE = 32;
const AREA = SIZE * SIZE;
const MAX_MATERIALS = 64;

// Four columns at a time, a byte each: heights are at most 32, so a high bit is free to borrow from.
const WORDS = SIZE / 4;
const ONES = 0x01010101;
const SEVENS = 0x7f7f7f7f;
const GUARDS = 0x80808080 | 0;

/** Of bytes below 128: 2 where a > b, 1 where they are equal, 0 where a < b. */
function signs(a: number, b: number): number {
  const notBelow = (((a | GUARDS) - b) >>> 7) & ONES;
  const notAbove = (((b | GUARDS) - a) >>> 7) & ONES;
  return notBelow + (notAbove ^ ONES);
}

export class LayersDecoder {
  private readonly even = new PlaneModel(false);
  private readonly odd = new PlaneModel(true);
  private readonly slots = planeSlots();
  // The planes one after the other, the first of them all 0: the floor of the second.
  private readonly planes = new Uint8Array(AREA * MAX_MATERIALS + SIZE); // and a row that is read past the last
  private readonly planeWords = new Int32Array(this.planes.buffer);
  // Of the row that is read: parts of keys, which plane_model.ts explains. Cells begin four before column 0.
  private readonly cells = new Uint8Array(SIZE + 8);
  private readonly cellWords = new Int32Array(this.cells.buffer);
  private readonly extras = new Uint8Array(SIZE);
  private readonly extraWords = new Int32Array(this.extras.buffer);
  private readonly oddKeys = new Int32Array(LANES);
  private readonly symbols = new Uint8Array(SIZE + 4); // and one beyond the row, 0
  private readonly symbolWords = new Int32Array(this.symbols.buffer);
  private readonly stepSigns = new Int32Array(WORDS);
  private readonly stepSignBytes = new Uint8Array(this.stepSigns.buffer);
  // Places in the planes, in lists by the height that stands there.
  private readonly firstOfHeight = new Int32Array(SIZE + 1);
  private readonly nextOfHeight = new Int32Array(AREA * MAX_MATERIALS);
  private ids: number[] = [];

  /** The one material of a uniform chunk; else null, and expand() gives the voxels. */
  decode(source: Source): number | null {
    const before = source.next;
    const count = source.number();
    const inStates = count > MAX_MATERIALS + 1 && count <= MAX_MATERIALS + LANES;
    let ids: number[] = [];
    if (!inStates) {
      source.next = before;
      ids = source.materials(MAX_MATERIALS);
      checkNeighbours(ids);
      if (ids.length === 1) {
        source.checkAllRead();
        return ids[0]!;
      }
    }
    const planes = (inStates ? count - MAX_MATERIALS : ids.length) - 1;
    source.takeStates();
    for (let p = 1; p <= planes; ++p) this.readPlane(source, p * AREA);
    source.checkAllRead();
    if (inStates) {
      ids = idsInStates(source, planes + 1);
      checkNeighbours(ids);
    } else {
      source.checkFinalStates();
    }
    this.ids = ids;
    return null;
  }

  private readPlane(source: Source, plane: number): void {
    const carried = readCarried(source);
    // The row to the north of row 0 is its floor, without steps.
    this.stepSigns.fill(ONES);
    const floor = plane - AREA;
    this.prepareRow(floor, floor, floor);
    let kind = FIRST;
    for (let z = 0; z < SIZE; ++z) {
      const row = plane + z * SIZE;
      this.readEvenSymbols(source, kind << KIND);
      this.readOddSymbols(source);
      const bad = this.readRow(source, row, kind);
      source.checkRead();
      if (bad) throw new DecodeError('bad_number');
      kind = z + 1 < SIZE && (carried >>> (z + 1)) & 1 ? CARRIED : LEVEL;
      this.prepareRow(row, row - AREA, row - AREA + SIZE);
    }
  }

  /** The features of a row's columns, but for the symbols beside them, from the row to its north, the floor of that,
   *  its own floor, and stepSigns. */
  private prepareRow(north: number, floorNorth: number, floor: number): void {
    const { planeWords, stepSigns, cellWords, cells, extraWords } = this;
    north >>= 2;
    floorNorth >>= 2;
    floor >>= 2;
    let here = planeWords[north]!;
    let before = here << 24; // the height west of this word, in the highest byte
    for (let i = 0; i < WORDS; ++i) {
      // Beyond the row's end heights repeat.
      const next = i < WORDS - 1 ? planeWords[north + i + 1]! : Math.imul(here >>> 24, ONES);
      const below = planeWords[floorNorth + i]!;
      const rises = signs(here, (here << 8) | (before >>> 24));
      const rises2 = signs((here >>> 16) | (next << 16), here);
      const thickness = here - below;
      const thick = (((thickness + SEVENS) >>> 7) & ONES) + (((thickness + SEVENS - ONES) >>> 7) & ONES);
      cellWords[1 + i] = (stepSigns[i]! << STEP_BITS) | (rises << RISE_BITS) | (thick << THICKNESS_BITS);
      extraWords[i] = rises2 | (signs(planeWords[floor + i]!, below) << 2);
      before = here;
      here = next;
    }
    const flat = (1 << STEP_BITS) | (1 << RISE_BITS);
    const thickAt = 3 << THICKNESS_BITS;
    cells[2] = flat;
    cells[3] = flat | (cells[4]! & thickAt);
    cells[4 + SIZE] = flat | (cells[3 + SIZE]! & thickAt);
    cells[5 + SIZE] = flat;
  }

  /** Reads the symbols of even columns, and makes the keys of odd ones. */
  private readEvenSymbols(source: Source, kind: number): void {
    const { cells, extras, oddKeys, symbols, slots } = this;
    const { fill, cache } = this.even;
    const { bytes, states } = source;
    let next = source.next;
    let window = (cells[2]! << (3 * CELL_BITS)) | (cells[3]! << (2 * CELL_BITS)) | (cells[4]! << CELL_BITS) | cells[5]!;
    for (let lane = 0; lane < LANES; ++lane) {
      window = (window << CELL_BITS) | cells[2 * lane + 6]!;
      const key = (window & FROM_CELLS) | (extras[2 * lane]! << FAR_EAST) | kind;
      window = (window << CELL_BITS) | cells[2 * lane + 7]!;
      oddKeys[lane] = (window & FROM_CELLS) | (extras[2 * lane + 1]! << FAR_EAST) | kind;
      const place = cachePlace(key);
      const intervals = cache[place] === key ? cache[place + 1]! : fill(key, place);
      let state = states[lane]!;
      const slot = slots[intervals + (state & 0xff)]!;
      state = (slot >> 16) * (state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff);
      // Whether a byte is taken cannot be foreseen: it is read in any case.
      const taken = (state - 256) >>> 31;
      states[lane] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next += taken;
      symbols[2 * lane] = slot;
    }
    source.next = next;
  }

  /** Those of odd columns, by the symbols to their west and east too. */
  private readOddSymbols(source: Source): void {
    const { oddKeys, symbols, slots } = this;
    const { fill, cache } = this.odd;
    const { bytes, states } = source;
    let next = source.next;
    let west = symbols[0]!;
    for (let lane = 0; lane < LANES; ++lane) {
      const east = symbols[2 * lane + 2]!; // 0 beyond the row
      const key = oddKeys[lane]! | (west << SYMBOL_WEST) | (east << SYMBOL_EAST);
      west = east;
      const place = cachePlace(key);
      const intervals = cache[place] === key ? cache[place + 1]! : fill(key, place);
      let state = states[lane]!;
      const slot = slots[intervals + (state & 0xff)]!;
      state = (slot >> 16) * (state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff);
      const taken = (state - 256) >>> 31;
      states[lane] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next += taken;
      symbols[2 * lane + 1] = slot;
    }
    source.next = next;
  }

  /** Makes the heights of the row at `row`, and stepSigns, of the symbols. True where a height is wrong. */
  private readRow(source: Source, row: number, kind: number): boolean {
    const { planeWords, symbolWords, stepSigns } = this;
    const floorRow = (row - AREA) >> 2;
    const north = kind === FIRST ? floorRow : (row - SIZE) >> 2;
    const floorNorth = kind === FIRST ? floorRow : (row - AREA - SIZE) >> 2;
    const at = row >> 2;
    let sum = 0; // of the changes so far, each one more than it is
    let counts = 0x04030201; // how many these are
    let good = GUARDS;
    for (let i = 0; i < WORDS; ++i) {
      const symbols = symbolWords[i]!;
      if ((symbols & (symbols >> 1) & ONES) !== 0) return this.readRowWithOthers(source, row, kind);
      const changes = ONES + (symbols & ONES) - ((symbols >> 1) & ONES);
      let steps = changes;
      let bias = ONES;
      if (kind !== LEVEL) {
        steps = Math.imul(changes, ONES) + sum;
        sum = Math.imul(steps >>> 24, ONES);
        bias = counts;
        counts += 4 * ONES;
      }
      const floor = planeWords[floorRow + i]!;
      const toNorth = planeWords[north + i]!;
      // To the north, but not below the floor, unless the material is absent there.
      const above = (toNorth | GUARDS) - floor;
      const present = ((toNorth ^ planeWords[floorNorth + i]!) + SEVENS) >>> 7;
      const risen = above & Math.imul((above >>> 7) & present & ONES, 0x7f);
      const height = ((floor + risen) | GUARDS) + steps - bias;
      good &= (height - floor) & ((GUARDS | 0x20202020) - (height & SEVENS)) & height;
      planeWords[at + i] = height & SEVENS;
      stepSigns[i] = signs(steps, bias);
    }
    return good !== GUARDS;
  }

  /** The same column by column, where some change by more than 1. */
  private readRowWithOthers(source: Source, row: number, kind: number): boolean {
    const { planes, symbols, stepSignBytes } = this;
    const { bytes } = source;
    const floorRow = row - AREA;
    const north = kind === FIRST ? floorRow : row - SIZE;
    const floorNorth = kind === FIRST ? floorRow : floorRow - SIZE;
    let step = 0;
    let bad = false;
    for (let x = 0; x < SIZE; ++x) {
      const symbol = symbols[x]!;
      const change = symbol === 3 ? (bytes[source.next++]! << 24) >> 24 : symbol === 2 ? -1 : symbol;
      step = kind === LEVEL ? change : step + change;
      const floor = planes[floorRow + x]!;
      const toNorth = planes[north + x]!;
      const height = (toNorth === planes[floorNorth + x]! || toNorth < floor ? floor : toNorth) + step;
      bad ||= height < floor || height > SIZE;
      planes[row + x] = bad ? floor : height;
      stepSignBytes[x] = step > 0 ? 2 : step < 0 ? 0 : 1;
    }
    return bad;
  }

  /** From planes to voxels: each slice is the one below it, but for the columns in which a material begins there. */
  expand(voxels: Uint16Array): void {
    const { ids, planeWords, firstOfHeight, nextOfHeight } = this;
    // Of one height the lowest plane comes first, so that the highest counts.
    firstOfHeight.fill(-1);
    for (let p = ids.length - 1; p > 0; --p) {
      const begin = p * WORDS * SIZE;
      for (let i = begin; i < begin + WORDS * SIZE; ++i) {
        const heights = planeWords[i]!;
        // What the plane above covers in all four columns is left out.
        if (p + 1 < ids.length && heights === planeWords[i + WORDS * SIZE]) continue;
        for (let k = 0; k < 4; ++k) {
          const height = (heights >>> (8 * k)) & 0xff;
          nextOfHeight[4 * i + k] = firstOfHeight[height]!;
          firstOfHeight[height] = 4 * i + k;
        }
      }
    }
    voxels.fill(ids[0]!, 0, AREA);
    for (let y = 0; y < SIZE; ++y) {
      const slice = y * AREA;
      if (y > 0) voxels.copyWithin(slice, slice - AREA, slice);
      for (let at = firstOfHeight[y]!; at >= 0; at = nextOfHeight[at]!) voxels[slice + (at & (AREA - 1))] = ids[at >> 10]!;
    }
  }
}

function readCarried(source: Source): number {
  const { bytes } = source;
  const present = bytes[source.next++]!;
  let carried = 0;
  for (let b = 0; b < 4; ++b) {
    if ((present >> b) & 1) carried |= bytes[source.next++]! << (8 * b);
  }
  source.checkRead();
  if (present > 15 || (carried & 1) !== 0) throw new DecodeError('bad_number');
  return carried;
}

function checkNeighbours(ids: readonly number[]): void {
  for (let i = 1; i < ids.length; ++i) {
    if (ids[i] === ids[i - 1]) throw new DecodeError('bad_materials');
  }
}

/** Ids as numbers in the low bytes of the final states. */
function idsInStates(source: Source, count: number): number[] {
  const ends = new Uint8Array(LANES);
  for (let i = 0; i < LANES; ++i) {
    const end = source.states[i]! - 256;
    if (end > 255) throw new DecodeError('bad_ending');
    ends[i] = end;
  }
  const ids: number[] = [];
  let at = 0;
  for (let i = 0; i < count; ++i) {
    let id = 0;
    for (let shift = 0; ; shift += 7) {
      if (at === LANES || shift > 14) throw new DecodeError('bad_ending');
      const byte = ends[at++]!;
      id |= (byte & 0x7f) << shift;
      if (byte >= 0x80) continue;
      if ((byte === 0 && shift > 0) || id > 0xffff) throw new DecodeError('bad_ending');
      break;
    }
    ids.push(id);
  }
  for (; at < LANES; ++at) {
    if (ends[at] !== 0) throw new DecodeError('bad_ending');
  }
  return ids;
}
