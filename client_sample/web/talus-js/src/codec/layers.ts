// Layers: the boundary planes between materials. FORMAT.md, "Layered".
import { DecodeError } from './decode_error.js';
import { CARRIED, cachePlace, FIRST, KIND, LEVEL, PlaneModel, planeSlots, SYMBOL_EAST, SYMBOL_WEST } from './plane_model.js';
import { LANES, type Source } from './source.js';

const SIZE = 32;
const AREA = SIZE * SIZE;
const MAX_MATERIALS = 64;

// Signs in keys: 0, 1 and 2 for -, 0 and +.
const FLAT = 1;
const FLAT_STEPS = 0x155; // five of them
// Without branches, as in all that follows: which way terrain goes cannot be foreseen.
function sign(value: number): number {
  return ((value >> 31) | ((0 - value) >>> 31)) + 1;
}

export class LayersDecoder {
  private readonly even = new PlaneModel(false);
  private readonly odd = new PlaneModel(true);
  private readonly slots = planeSlots();
  // The planes one after the other, the first of them all 0: the floor of the second.
  private readonly planes = new Uint8Array(AREA * MAX_MATERIALS + SIZE); // and a row that is read past the last
  private readonly keys = new Int32Array(SIZE);
  private readonly symbols = new Int32Array(SIZE + 1); // and one beyond the row, 0
  // Columns whose boundary has one height: the column and how many more, and the plane; in lists by height.
  private readonly firstOfHeight = new Int32Array(SIZE + 1);
  private readonly runs = new Int32Array(AREA * MAX_MATERIALS);
  private readonly nextRun = new Int32Array(AREA * MAX_MATERIALS);
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
    const { keys, symbols, slots } = this;
    const { fill, keys: cached, found } = this.even;
    const { bytes, states } = source;
    let next = source.next;
    for (let lane = 0; lane < LANES; ++lane) {
      const key = keys[2 * lane]!;
      const place = cachePlace(key);
      const intervals = cached[place] === key ? found[place]! : fill(key, place);
      let state = states[lane]!;
      const slot = slots[intervals + (state & 0xff)]!;
      state = (slot >> 16) * (state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff);
      // Whether a byte is taken cannot be foreseen: it is read in any case.
      const taken = (state - 256) >>> 31;
      states[lane] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next += taken;
      symbols[2 * lane] = slot & 0xff;
    }
    source.next = next;
  }

  /** The same of odd columns, by the symbols to their west and east. */
  private readOddSymbols(source: Source): void {
    const { keys, symbols, slots } = this;
    const { fill, keys: cached, found } = this.odd;
    const { bytes, states } = source;
    let next = source.next;
    let west = symbols[0]!;
    for (let lane = 0; lane < LANES; ++lane) {
      const east = symbols[2 * lane + 2]!; // 0 beyond the row
      const key = keys[2 * lane + 1]! | (west << SYMBOL_WEST) | (east << SYMBOL_EAST);
      west = east;
      const place = cachePlace(key);
      const intervals = cached[place] === key ? found[place]! : fill(key, place);
      let state = states[lane]!;
      const slot = slots[intervals + (state & 0xff)]!;
      state = (slot >> 16) * (state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff);
      // Whether a byte is taken cannot be foreseen: it is read in any case.
      const taken = (state - 256) >>> 31;
      states[lane] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next += taken;
      symbols[2 * lane + 1] = slot & 0xff;
    }
    source.next = next;
  }

  /** Makes heights of the symbols of row z, and in the same go the keys of the row to its south: a column's key is
   *  known two columns later. True where a height is wrong. */
  private readRow(source: Source, plane: number, z: number, isLevel: boolean, nextKind: number): boolean {
    const { planes, keys, symbols } = this;
    const { bytes } = source;
    const row = plane + z * SIZE;
    const floorRow = row - AREA;
    const north = z === 0 ? floorRow : row - SIZE;
    const floorNorth = z === 0 ? floorRow : floorRow - SIZE;
    let next = source.next;
    const keep = isLevel ? 0 : -1;
    let bad = 0; // below 0 where a height is
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
      let change = (symbol & 1) - (symbol >> 1);
      if (symbol === 3) change = (bytes[next++]! << 24) >> 24;
      step = change + (step & keep);
      const floor = planes[floorRow + x]!;
      // To the north, but not below the floor, unless the material is absent there.
      const toNorth = planes[north + x]!;
      const above = toNorth - floor;
      height = floor + (above & ~(above >> 31) & ((planes[floorNorth + x]! - toNorth) >> 31)) + step;
      const thickness = height - floor;
      bad |= thickness | (SIZE - height);
      planes[row + x] = height;

      const thick = 2 + ((thickness - 2) & ((thickness - 2) >> 31));
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
    return bad < 0;
  }

  /** From planes to voxels: each slice is the one below it, but for the columns in which a material begins there. */
  expand(voxels: Uint16Array): void {
    const { ids, planes, firstOfHeight, nextRun, runs } = this;
    // Columns after one another of one height, by that height; of one height the lowest plane comes first, so that the
    // highest counts.
    firstOfHeight.fill(-1);
    let count = 0;
    for (let p = ids.length - 1; p > 0; --p) {
      const end = (p + 1) * AREA;
      for (let i = p * AREA; i < end; ) {
        const begin = i;
        const height = planes[i]!;
        do ++i;
        while (i < end && planes[i] === height);
        runs[count] = (begin & (AREA - 1)) | ((i - begin - 1) << 10) | (p << 20);
        nextRun[count] = firstOfHeight[height]!;
        firstOfHeight[height] = count++;
      }
    }
    voxels.fill(ids[0]!, 0, AREA);
    for (let y = 0; y < SIZE; ++y) {
      const slice = y * AREA;
      if (y > 0) voxels.copyWithin(slice, slice - AREA, slice);
      for (let at = firstOfHeight[y]!; at >= 0; at = nextRun[at]!) {
        const run = runs[at]!;
        const id = ids[run >> 20]!;
        const begin = slice + (run & (AREA - 1));
        const length = ((run >> 10) & (AREA - 1)) + 1;
        if (length > 64) voxels.fill(id, begin, begin + length);
        else for (let i = begin; i < begin + length; ++i) voxels[i] = id;
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
