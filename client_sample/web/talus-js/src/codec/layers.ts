// Layers: the boundary planes between materials. FORMAT.md, "Layered".
import { DecodeError } from './decode_error.js';
import { PlaneKeys, signs } from './plane_keys.js';
import { planeSlots, PlaneModel } from './plane_model.js';
import { LANES, type Source } from './source.js';

const SIZE = 32;
const AREA = SIZE * SIZE;
const MAX_MATERIALS = 64;
// Without a bundler, each use of an imported constant is a load with checks; a module's own constant is inlined.
const STATES: number = LANES;

// Kinds of rows, in the order of their weights.
const LEVEL = 0;
const CARRIED = 1;
const FIRST = 2;

// Four columns at a time, a byte each: heights are at most 32, so a high bit is free to borrow from.
const WORDS = SIZE / 4;
const ONES = 0x01010101;
const SEVENS = 0x7f7f7f7f;
const GUARDS = 0x80808080 | 0;

export class LayersDecoder {
  private readonly even = new PlaneModel(false);
  private readonly odd = new PlaneModel(true);
  private readonly slots = planeSlots();
  // Consecutive planes, the first of them all 0: the floor of the second.
  private readonly planes = new Uint8Array(AREA * MAX_MATERIALS + SIZE); // and one row that is read past the last
  private readonly planeWords = new Int32Array(this.planes.buffer);
  private readonly keys = new PlaneKeys();
  private readonly intervals = new Int32Array(LANES); // starts in slots
  private readonly symbols = new Uint8Array(SIZE + 4); // and one beyond the row, 0
  private readonly symbolWords = new Int32Array(this.symbols.buffer);
  private readonly stepSigns = new Int32Array(WORDS);
  private readonly stepSignBytes = new Uint8Array(this.stepSigns.buffer);
  // Places in the planes, in lists by height.
  private readonly firstOfHeight = new Int32Array(SIZE + 1);
  private readonly nextOfHeight = new Int32Array(AREA * MAX_MATERIALS);
  private ids: number[] = [];

  /** Returns the material of a uniform chunk; otherwise null, and expand() produces the voxels. */
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
    let north = plane - AREA;
    let kind = FIRST;
    for (let z = 0; z < SIZE; ++z) {
      const row = plane + z * SIZE;
      const floor = row - AREA;
      this.keys.make(this.planeWords, north >> 2, (z === 0 ? floor : floor - SIZE) >> 2, floor >> 2, this.stepSigns, kind);
      this.readSymbols(source, this.even, this.keys.even, 0);
      this.keys.addSymbols(this.symbolWords);
      this.readSymbols(source, this.odd, this.keys.odd, 1);
      const bad = this.readRow(source, row, kind);
      source.checkRead();
      if (bad) throw new DecodeError('bad_number');
      kind = z + 1 < SIZE && (carried >>> (z + 1)) & 1 ? CARRIED : LEVEL;
      north = row;
    }
  }

  /** Reads the symbols of every second column from `first`. Unrolled four times: V8 checks and loads every array again
   *  in each iteration, which takes as long as two symbols. */
  private readSymbols(source: Source, model: PlaneModel, keys: Int32Array, first: number): void {
    const { symbols, slots, intervals } = this;
    const { bytes, states } = source;
    model.look(keys, intervals);
    let next = source.next;
    let state = 0;
    let slot = 0;
    let taken = 0;
    let at = first;
    for (let lane = 0; lane < STATES; lane = (lane + 4) | 0) {
      state = states[lane]!;
      slot = slots[(intervals[lane]! + (state & 0xff)) | 0]!;
      state = (Math.imul(slot >> 16, state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff)) | 0;
      taken = (state - 256) >>> 31;
      states[lane] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next = (next + taken) | 0;
      symbols[at] = slot;
      state = states[lane + 1]!;
      slot = slots[(intervals[lane + 1]! + (state & 0xff)) | 0]!;
      state = (Math.imul(slot >> 16, state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff)) | 0;
      taken = (state - 256) >>> 31;
      states[lane + 1] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next = (next + taken) | 0;
      symbols[at + 2] = slot;
      state = states[lane + 2]!;
      slot = slots[(intervals[lane + 2]! + (state & 0xff)) | 0]!;
      state = (Math.imul(slot >> 16, state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff)) | 0;
      taken = (state - 256) >>> 31;
      states[lane + 2] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next = (next + taken) | 0;
      symbols[at + 4] = slot;
      state = states[lane + 3]!;
      slot = slots[(intervals[lane + 3]! + (state & 0xff)) | 0]!;
      state = (Math.imul(slot >> 16, state >> 8) + (state & 0xff) - ((slot >> 8) & 0xff)) | 0;
      taken = (state - 256) >>> 31;
      states[lane + 3] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next = (next + taken) | 0;
      symbols[at + 6] = slot;
      at = (at + 8) | 0;
    }
    source.next = next;
  }

  /** Computes the heights of the row at `row`, and stepSigns, from the symbols. Returns true if a height is invalid. */
  private readRow(source: Source, row: number, kind: number): boolean {
    const { planeWords, symbolWords, stepSigns } = this;
    const floorRow = (row - AREA) >> 2;
    const north = kind === FIRST ? floorRow : (row - SIZE) >> 2;
    const floorNorth = kind === FIRST ? floorRow : (row - AREA - SIZE) >> 2;
    const at = row >> 2;
    let sum = 0; // of the changes so far, each plus 1
    let counts = 0x04030201; // number of these changes
    let good = GUARDS;
    for (let i = 0; i < WORDS; i = (i + 1) | 0) {
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
      const floor = planeWords[(floorRow + i) | 0]!;
      const toNorth = planeWords[(north + i) | 0]!;
      // The height to the north, but not below the floor, unless the material is absent there.
      const above = (toNorth | GUARDS) - floor;
      const present = ((toNorth ^ planeWords[(floorNorth + i) | 0]!) + SEVENS) >>> 7;
      const risen = above & Math.imul((above >>> 7) & present & ONES, 0x7f);
      const height = ((floor + risen) | GUARDS) + steps - bias;
      good &= (height - floor) & ((GUARDS | 0x20202020) - (height & SEVENS)) & height;
      planeWords[(at + i) | 0] = height & SEVENS;
      stepSigns[i] = signs(steps, bias);
    }
    return good !== GUARDS;
  }

  /** The same column by column, for rows with changes above 1. */
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

  /** Converts planes to voxels: each slice equals the one below, except in columns where a material begins. */
  expand(voxels: Uint16Array): void {
    const { ids, planeWords, firstOfHeight, nextOfHeight } = this;
    // Among planes of equal height the lowest comes first, so that the highest takes effect.
    firstOfHeight.fill(-1);
    for (let p = ids.length - 1; p > 0; --p) {
      const begin = p * WORDS * SIZE;
      for (let i = begin; i < begin + WORDS * SIZE; ++i) {
        const heights = planeWords[i]!;
        // Skips heights that the plane above covers in all four columns.
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
