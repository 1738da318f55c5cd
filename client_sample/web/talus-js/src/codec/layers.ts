// Layers: the boundary planes between materials. FORMAT.md, "Layered".
import { DecodeError } from './decode_error.js';
import { CARRIED, cachePlace, FIRST, KIND, LEVEL, PlaneModel, SYMBOL_EAST, SYMBOL_WEST } from './plane_model.js';
import { LANES, type Source } from './source.js';

const SIZE = 32;
const AREA = SIZE * SIZE;
const MAX_MATERIALS = 64;

// Signs in keys: 0, 1 and 2 for -, 0 and +.
const FLAT = 1;
const FLAT_STEPS = 0x155; // five of them
function sign(value: number): number {
  return (value > 0 ? 2 : 1) - (value < 0 ? 1 : 0);
}

export class LayersDecoder {
  private readonly even = new PlaneModel(false);
  private readonly odd = new PlaneModel(true);
  // The planes one after the other, the first of them all 0: the floor of the second.
  private readonly planes = new Uint8Array(AREA * MAX_MATERIALS + SIZE); // and a row that is read past the last
  private readonly keys = new Int32Array(SIZE);
  private readonly symbols = new Int32Array(SIZE + 1); // and one beyond the row, 0
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
    this.prepareFirstRow(plane - AREA);
    for (let z = 0; z < SIZE; ++z) {
      this.readEvenSymbols(source);
      this.readOddSymbols(source);
      const next = z + 1 < SIZE && (carried >>> (z + 1)) & 1 ? CARRIED : LEVEL;
      const bad = this.readRow(source, plane, z, z > 0 && ((carried >>> z) & 1) === 0, next << KIND);
      source.checkRead();
      if (bad) throw new DecodeError('bad_number');
    }
  }

  /** The keys of row 0, but for the symbols beside columns: the row to its north is its floor, without steps. */
  private prepareFirstRow(floor: number): void {
    const { planes, keys } = this;
    const at = (x: number) => planes[floor + (x < SIZE ? x : SIZE - 1)]!;
    let rises = FLAT;
    for (let x = 0; x < SIZE; ++x) {
      const here = at(x);
      const west = rises;
      rises = sign(at(x + 1) - here);
      keys[x] = west | (rises << 2) | (sign(at(x + 2) - here) << 4) | (FLAT_STEPS << 6) | (FLAT << 16) | (FIRST << KIND);
    }
  }

  private readEvenSymbols(source: Source): void {
    const { keys, symbols } = this;
    const { fill, keys: cached, ends: cachedEnds } = this.even;
    const { bytes, states } = source;
    let next = source.next;
    let lastKey = -1; // neighbours are often alike
    let ends = 0;
    for (let lane = 0; lane < LANES; ++lane) {
      const key = keys[2 * lane]!;
      if (key !== lastKey) {
        const place = cachePlace(key);
        ends = cached[place] === key ? cachedEnds[place]! : fill(key, place);
        lastKey = key;
      }
      let state = states[lane]!;
      const slot = state & 0xff;
      const first = ends & 0xff;
      if (slot < first) {
        symbols[2 * lane] = 0;
        state = first * (state >> 8) + slot;
      } else {
        const second = (ends >> 8) & 0xff;
        const third = ends >> 16;
        const symbol = slot < second ? 1 : slot < third ? 2 : 3;
        const start = symbol === 1 ? first : symbol === 2 ? second : third;
        const end = symbol === 1 ? second : symbol === 2 ? third : 256;
        symbols[2 * lane] = symbol;
        state = (end - start) * (state >> 8) + slot - start;
      }
      if (state < 256) state = (state << 8) | bytes[next++]!;
      states[lane] = state;
    }
    source.next = next;
  }

  /** The same of odd columns, by the symbols to their west and east. */
  private readOddSymbols(source: Source): void {
    const { keys, symbols } = this;
    const { fill, keys: cached, ends: cachedEnds } = this.odd;
    const { bytes, states } = source;
    let next = source.next;
    let lastKey = -1;
    let ends = 0;
    let west = symbols[0]!;
    for (let lane = 0; lane < LANES; ++lane) {
      const east = symbols[2 * lane + 2]!; // 0 beyond the row
      const key = keys[2 * lane + 1]! | (west << SYMBOL_WEST) | (east << SYMBOL_EAST);
      west = east;
      if (key !== lastKey) {
        const place = cachePlace(key);
        ends = cached[place] === key ? cachedEnds[place]! : fill(key, place);
        lastKey = key;
      }
      let state = states[lane]!;
      const slot = state & 0xff;
      const first = ends & 0xff;
      if (slot < first) {
        symbols[2 * lane + 1] = 0;
        state = first * (state >> 8) + slot;
      } else {
        const second = (ends >> 8) & 0xff;
        const third = ends >> 16;
        const symbol = slot < second ? 1 : slot < third ? 2 : 3;
        const start = symbol === 1 ? first : symbol === 2 ? second : third;
        const end = symbol === 1 ? second : symbol === 2 ? third : 256;
        symbols[2 * lane + 1] = symbol;
        state = (end - start) * (state >> 8) + slot - start;
      }
      if (state < 256) state = (state << 8) | bytes[next++]!;
      states[lane] = state;
    }
    source.next = next;
  }

  /** Makes heights of the symbols of row z, and in the same go the keys of the row to its south: a column's key is
   *  known two columns later. True where a height is wrong. */
  private readRow(source: Source, plane: number, z: number, level: boolean, nextKind: number): boolean {
    const { planes, keys, symbols } = this;
    const { bytes } = source;
    const row = plane + z * SIZE;
    const floorRow = row - AREA;
    const north = z === 0 ? floorRow : row - SIZE;
    const floorNorth = z === 0 ? floorRow : floorRow - SIZE;
    let next = source.next;
    let bad = 0;
    let step = 0;
    let height = 0;
    let before = 0; // the height one column to the west, and two
    let before2 = 0;
    let rises = FLAT << 2; // west of the column before, and of that before it
    let steps = FLAT_STEPS;
    let thicks = 0;
    let floors = 0;
    for (let x = 0; x < SIZE; ++x) {
      const symbol = symbols[x]!;
      let change = symbol;
      if (symbol > 1) change = symbol === 2 ? -1 : (bytes[next++]! << 24) >> 24;
      step = level ? change : step + change;
      const floor = planes[floorRow + x]!;
      const toNorth = planes[north + x]!;
      height = (toNorth === planes[floorNorth + x]! || toNorth < floor ? floor : toNorth) + step;
      if (height < floor || height > SIZE) bad = 1;
      planes[row + x] = height;

      const thickness = height - floor;
      const thick = thickness < 2 ? thickness : 2;
      if (x === 0) {
        before = before2 = height;
        thicks = thick;
      }
      steps = ((steps << 2) | sign(step)) & 0x3ff;
      const rise = sign(height - before);
      if (x > 1) {
        keys[x - 2] =
          rises | (sign(height - before2) << 4) | (steps << 6) | ((floors & 0xc) << 14) | (thicks << 18) | nextKind;
      }
      // Two bits each: of rises the older first, as keys have them; of the others the newer.
      rises = (rises >> 2) | (rise << 2);
      thicks = ((thicks << 2) | thick) & 0x3f;
      floors = (floors << 2) | sign(planes[floorRow + SIZE + x]! - floor);
      before2 = before;
      before = height;
    }
    // Beyond the row's end heights repeat, and there are no steps.
    const thick = thicks & 3;
    steps = ((steps << 2) | FLAT) & 0x3ff;
    keys[SIZE - 2] =
      rises | (sign(before - before2) << 4) | (steps << 6) | ((floors & 0xc) << 14) | (thicks << 18) | nextKind;
    rises = (rises >> 2) | (FLAT << 2);
    thicks = ((thicks << 2) | thick) & 0x3f;
    steps = ((steps << 2) | FLAT) & 0x3ff;
    keys[SIZE - 1] = rises | (FLAT << 4) | (steps << 6) | ((floors & 3) << 16) | (thicks << 18) | nextKind;
    source.next = next;
    return bad !== 0;
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
