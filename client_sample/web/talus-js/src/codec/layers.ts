// Layers: the boundary planes between materials. FORMAT.md, "Layered".
import { DecodeError } from './decode_error.js';
import { CARRIED, cachePlace, FIRST, KIND, LEVEL, PlaneModel, SYMBOL_EAST, SYMBOL_WEST } from './plane_model.js';
import { LANES, type Source } from './source.js';

const SIZE = 32;
const AREA = SIZE * SIZE;
const MAX_MATERIALS = 64;

// Rows stand in arrays with two places more on either side.
const PAD = 2;
const PADDED = SIZE + 2 * PAD;

export class LayersDecoder {
  private readonly even = new PlaneModel(false);
  private readonly odd = new PlaneModel(true);
  // The planes one after the other, the first of them all 0: the floor of the second.
  private readonly planes = new Uint8Array(AREA * MAX_MATERIALS);
  private readonly north = new Int32Array(PADDED);
  private readonly thick = new Int32Array(PADDED); // of the plane's material to the north, at most 2
  private readonly signs = new Int32Array(PADDED); // of the steps to the north: 0, 1, 2
  private readonly keys = new Int32Array(SIZE);
  private readonly symbols = new Int32Array(SIZE + 1);
  // Of the columns' boundaries within the chunk, by height: which column, and what begins there.
  private readonly boundaryBegin = new Int32Array(SIZE + 2);
  private readonly boundaries = new Int32Array(AREA * MAX_MATERIALS);

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
    this.signs.fill(1);
    for (let z = 0; z < SIZE; ++z) {
      const kind = z === 0 ? FIRST : (carried >>> z) & 1 ? CARRIED : LEVEL;
      this.prepareRow(plane + z * SIZE, kind);
      this.readSymbols(source);
      this.readRow(source, plane + z * SIZE, kind);
    }
  }

  /** Works out the keys of a row's columns, but for the symbols beside them. */
  private prepareRow(row: number, kind: number): void {
    const { planes, north, thick, signs, keys } = this;
    const toNorth = kind === FIRST ? row - AREA : row - SIZE;
    const floorToNorth = kind === FIRST ? row - AREA : row - AREA - SIZE;
    for (let x = 0; x < SIZE; ++x) {
      const height = planes[toNorth + x]!;
      const thickness = height - planes[floorToNorth + x]!;
      north[PAD + x] = height;
      thick[PAD + x] = thickness < 2 ? thickness : 2;
    }
    north[PAD - 1] = north[PAD]!;
    thick[PAD - 1] = thick[PAD]!;
    north[PAD + SIZE] = north[PAD + SIZE + 1] = north[PAD + SIZE - 1]!;
    thick[PAD + SIZE] = thick[PAD + SIZE - 1]!;

    let here = north[PAD]!;
    let east = here;
    let rises = 1; // to the east of the column before, and so to the west of this one
    let steps = (signs[0]! << 6) | (signs[1]! << 4) | (signs[2]! << 2) | signs[3]!; // two to the west, ... one to the east
    let thicks = (thick[PAD - 1]! << 2) | thick[PAD]!;
    east = here;
    for (let x = 0; x < SIZE; ++x) {
      here = east;
      east = north[PAD + x + 1]!;
      const west = rises;
      rises = east > here ? 2 : east < here ? 0 : 1;
      const farEast = north[PAD + x + 2]!;
      const farRises = farEast > here ? 2 : farEast < here ? 0 : 1;
      steps = ((steps << 2) | signs[PAD + x + 2]!) & 0x3ff;
      thicks = ((thicks << 2) | thick[PAD + x + 1]!) & 0x3f;
      const floor = planes[row - AREA + x]! - planes[floorToNorth + x]!;
      const floorRises = floor > 0 ? 2 : floor < 0 ? 0 : 1;
      keys[x] =
        west | (rises << 2) | (farRises << 4) | (steps << 6) | (floorRises << 16) | (thicks << 18) | (kind << KIND);
    }
  }

  private readSymbols(source: Source): void {
    const { keys, symbols } = this;
    const { bytes, states } = source;
    let next = source.next;
    for (let odd = 0; odd < 2; ++odd) {
      const model = odd ? this.odd : this.even;
      const cached = model.keys;
      const cachedEnds = model.ends;
      for (let x = odd; x < SIZE; x += 2) {
        let key = keys[x]!;
        if (odd) key |= (symbols[x - 1]! << SYMBOL_WEST) | (symbols[x + 1]! << SYMBOL_EAST);
        const place = cachePlace(key);
        const ends = cached[place] === key ? cachedEnds[place]! : model.fill(key, place);
        const lane = x >> 1;
        let state = states[lane]!;
        const slot = state & 0xff;
        const first = ends & 0xff;
        if (slot < first) {
          symbols[x] = 0;
          state = first * (state >> 8) + slot;
        } else {
          const second = (ends >> 8) & 0xff;
          const third = ends >> 16;
          let start = 0;
          let end = 0;
          if (slot < second) {
            symbols[x] = 1;
            start = first;
            end = second;
          } else if (slot < third) {
            symbols[x] = 2;
            start = second;
            end = third;
          } else {
            symbols[x] = 3;
            start = third;
            end = 256;
          }
          state = (end - start) * (state >> 8) + slot - start;
        }
        if (state < 256) state = (state << 8) | bytes[next++]!;
        states[lane] = state;
      }
    }
    source.next = next;
  }

  /** Makes heights of the symbols. */
  private readRow(source: Source, row: number, kind: number): void {
    const { planes, north, signs, symbols } = this;
    const { bytes } = source;
    const floorToNorth = kind === FIRST ? row - AREA : row - AREA - SIZE;
    let next = source.next;
    let step = 0;
    let bad = 0;
    for (let x = 0; x < SIZE; ++x) {
      const symbol = symbols[x]!;
      let change = symbol;
      if (symbol > 1) change = symbol === 2 ? -1 : (bytes[next++]! << 24) >> 24;
      step = kind === LEVEL ? change : step + change;
      const floor = planes[row - AREA + x]!;
      const toNorth = north[PAD + x]!;
      const predicted = toNorth === planes[floorToNorth + x]! || toNorth < floor ? floor : toNorth;
      const height = predicted + step;
      if (height < floor || height > SIZE) bad = 1;
      planes[row + x] = height;
      signs[PAD + x] = step > 0 ? 2 : step < 0 ? 0 : 1;
    }
    source.next = next;
    source.checkRead();
    if (bad) throw new DecodeError('bad_number');
  }

  /** From planes to voxels: each slice is the one below it, but for the columns in which a material begins there. */
  expand(voxels: Uint16Array): void {
    const { ids, planes, boundaryBegin, boundaries } = this;
    const first = AREA;
    const last = AREA * ids.length;
    // Sorted by height, and of one height from the lowest plane up, so that the highest counts.
    boundaryBegin.fill(0);
    for (let i = first; i < last; ++i) ++boundaryBegin[planes[i]! + 1]!;
    for (let y = 1; y <= SIZE; ++y) boundaryBegin[y]! += boundaryBegin[y - 1]!;
    for (let p = 1; p < ids.length; ++p) {
      const id = ids[p]! << 10;
      const plane = p * AREA;
      for (let i = 0; i < AREA; ++i) {
        const height = planes[plane + i]!;
        boundaries[boundaryBegin[height]!++] = id | i;
      }
    }
    voxels.fill(ids[0]!, 0, AREA);
    let at = 0;
    for (let y = 0; y < SIZE; ++y) {
      const slice = y * AREA;
      if (y > 0) voxels.copyWithin(slice, slice - AREA, slice);
      for (const end = boundaryBegin[y]!; at < end; ++at) {
        const boundary = boundaries[at]!;
        voxels[slice + (boundary & (AREA - 1))] = boundary >>> 10;
      }
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
