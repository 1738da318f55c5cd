// Arbitrary voxels, each predicted from its neighbours: FORMAT.md, "Volume". Works on rows of 32 voxels and masks with
// a bit for each: full masks, as in rock and in air, need no work per voxel.
import { DecodeError } from './decode_error.js';
import { Exceptions } from './exceptions.js';
import { MaterialCode } from './material_code.js';
import { LANES, type Source } from './source.js';
import { candidate } from './volume_candidates.js';
import { parseIntervals } from './volume_intervals.js';

const SIZE = 32;
const ROWS = SIZE * SIZE;
const WAVES = 94;
const EVEN = 0x55555555;
const ODD = 0xaaaaaaaa | 0;
const ALL = -1;
const MIXED = -1; // as a row's material
const WAVE_ROWS = 16;
const BATCH = WAVE_ROWS * (SIZE / 2);

export class VolumeDecoder {
  private readonly intervals = parseIntervals();
  private readonly materials = new MaterialCode();
  private readonly exceptions = new Exceptions();
  // The voxels, and one more row: the one around the first.
  private readonly buffer = new ArrayBuffer((ROWS + 1) * SIZE * 2);
  private readonly voxels = new Uint16Array(this.buffer);
  private readonly pairs = new Uint32Array(this.buffer);
  // For rows already read: their material or MIXED; masks of voxels equal to those to their west, north and below.
  private readonly rowMaterial = new Int32Array(ROWS + 1);
  private readonly equalsWest = new Int32Array(ROWS + 1);
  private readonly equalsNorth = new Int32Array(ROWS + 1);
  private readonly equalsBelow = new Int32Array(ROWS + 1);
  // For the rows of a wave: the rows around them, and masks.
  private readonly north = new Int32Array(WAVE_ROWS);
  private readonly below = new Int32Array(WAVE_ROWS);
  private readonly belowNorth = new Int32Array(WAVE_ROWS);
  private readonly belowSouth = new Int32Array(WAVE_ROWS);
  private readonly same = new Int32Array(WAVE_ROWS);
  private readonly upright = new Int32Array(WAVE_ROWS);
  private readonly level = new Int32Array(WAVE_ROWS);
  private readonly levelSouth = new Int32Array(WAVE_ROWS);
  private readonly full = new Int32Array(WAVE_ROWS); // `same`, and all surroundings
  private readonly quiet = new Uint8Array(WAVE_ROWS); // full, and as predicted so far
  // For the voxels of a batch that are not steady:
  private readonly contexts = new Int32Array(BATCH);
  private readonly places = new Int32Array(BATCH); // row of the wave << 16 | voxel
  private readonly escapes = new Int32Array(BATCH);
  private coded = 0;

  decode(source: Source, out: Uint16Array): void {
    this.materials.take(source);
    const exceptions = source.number();
    if (source.left() < 1 + 2 * LANES) throw new DecodeError('truncated');
    const intervals = this.intervals[source.bytes[source.next++]!];
    if (intervals === undefined) throw new DecodeError('bad_number');
    source.takeStates();
    this.begin(this.materials.ids[0]!);
    this.exceptions.begin(source, this.materials, exceptions);
    for (let wave = 0; wave < WAVES; ++wave) {
      const firstRow = Math.max(0, (wave - SIZE + 2) >> 1);
      const lastRow = Math.min(SIZE - 1, wave >> 1);
      const rows = lastRow - firstRow + 1;
      const first = firstRow * SIZE + wave - 2 * firstRow; // rows of a wave are 30 apart
      this.coded = 0;
      for (let i = 0; i < rows; ++i) this.beginRow(source, i, first + 30 * i);
      this.readBatch(source, intervals);
      this.coded = 0;
      for (let i = 0; i < rows; ++i) this.finishRow(source, i, first + 30 * i);
      this.readBatch(source, intervals);
      for (let i = 0; i < rows; ++i) this.compareRow(i, first + 30 * i);
    }
    this.exceptions.checkAllTaken();
    source.checkAllRead();
    source.checkFinalStates();
    out.set(this.voxels.subarray(0, ROWS * SIZE));
  }

  private begin(material: number): void {
    this.voxels.fill(material, ROWS * SIZE);
    this.rowMaterial[ROWS] = material;
    this.equalsWest[ROWS] = ALL;
  }

  /** Computes the masks of row `row`, number `i` of its wave, and its even columns, except coded ones. */
  private beginRow(source: Source, i: number, row: number): void {
    const z = row & (SIZE - 1);
    let north = row - 1;
    let below = row - SIZE;
    let belowNorth = below - 1;
    let belowSouth = below + 1;
    let same = ALL;
    let upright = ALL;
    let level = ALL;
    let levelSouth = ALL;
    if (row < SIZE) {
      if (z === 0) north = ROWS;
      below = belowNorth = belowSouth = north;
    } else {
      if (z === 0) {
        north = belowNorth = below;
      } else {
        upright = this.equalsBelow[north]!;
        level = this.equalsNorth[below]!;
        same = this.equalRows(north, below);
      }
      if (z === SIZE - 1) belowSouth = below;
      else levelSouth = this.equalsNorth[belowSouth]!;
    }
    const westNorth = this.equalsWest[north]!;
    const westBelow = this.equalsWest[below]!;
    const eastNorth = (westNorth >>> 1) | 0x80000000;
    const eastBelow = (westBelow >>> 1) | 0x80000000;
    const full = same & upright & levelSouth & westNorth & eastNorth & westBelow & eastBelow;
    this.north[i] = north;
    this.below[i] = below;
    this.belowNorth[i] = belowNorth;
    this.belowSouth[i] = belowSouth;
    this.same[i] = same;
    this.upright[i] = upright;
    this.level[i] = level;
    this.levelSouth[i] = levelSouth;
    this.full[i] = full;

    this.copyBase(row, north, below, level);
    const { exceptions } = this;
    const steady = full === ALL ? 16 : countBits(full & EVEN);
    if (exceptions.gap >= steady) {
      exceptions.gap -= steady;
      this.quiet[i] = full === ALL ? 1 : 0;
    } else {
      this.takeExceptions(source, row, full & EVEN, steady);
      this.quiet[i] = 0;
    }
    if (full === ALL) return;
    const { voxels, contexts, places } = this;
    let coded = this.coded;
    for (let left = ~full & EVEN; left !== 0; left &= left - 1) {
      const x = 31 - Math.clz32(left & -left);
      const sides =
        (((westNorth >>> x) & 1) << 2) |
        (((eastNorth >>> x) & 1) << 3) |
        (((westBelow >>> x) & 1) << 4) |
        (((eastBelow >>> x) & 1) << 5);
      const u = (upright >>> x) & 1;
      const s = (levelSouth >>> x) & 1;
      // The choice is unpredictable: compute both.
      const ofSame = u | (s << 1) | sides;
      const ofOther =
        64 |
        ((level >>> x) & 1) |
        (u << 1) |
        (s << 2) |
        (isZero(voxels[belowSouth * SIZE + x]! - voxels[north * SIZE + x]!) << 3) |
        ((sides & (sides << 1) & 8) << 1) |
        (sides & (sides << 1) & 32);
      contexts[coded] = ofOther ^ ((ofOther ^ ofSame) & -((same >>> x) & 1));
      places[coded++] = (i << 16) | (row * SIZE + x);
    }
    this.coded = coded;
  }

  /** Computes the odd columns of a row, except coded ones. */
  private finishRow(source: Source, i: number, row: number): void {
    const { voxels, exceptions, contexts, places } = this;
    if (this.quiet[i]) {
      if (exceptions.gap >= 16) {
        exceptions.gap -= 16;
      } else {
        this.quiet[i] = 0;
        this.takeExceptions(source, row, ODD, 16);
      }
      return;
    }
    const north = this.north[i]! * SIZE;
    const below = this.below[i]! * SIZE;
    const same = this.same[i]!;
    const upright = this.upright[i]!;
    const level = this.level[i]!;
    const levelSouth = this.levelSouth[i]!;
    const full = this.full[i]!;
    const westNorth = this.equalsWest[this.north[i]!]!;
    const westBelow = this.equalsWest[this.below[i]!]!;
    const at = row * SIZE;
    let steady = 0;
    let coded = this.coded;
    let west = voxels[at]!;
    for (let x = 1; x < SIZE; x += 2) {
      const east = x === SIZE - 1 ? west : voxels[at + x + 1]!;
      const n = voxels[north + x]!;
      if (west === east) {
        voxels[at + x] = west;
        const isSame = (same >>> x) & 1;
        if (isSame && n === west) {
          if ((full >>> x) & 1) {
            steady |= 1 << x;
          } else {
            contexts[coded] =
              128 |
              ((upright >>> x) & 1) |
              (((levelSouth >>> x) & 1) << 1) |
              (((westNorth >>> x) & 1) << 2) |
              ((x === SIZE - 1 ? 1 : (westNorth >>> (x + 1)) & 1) << 3) |
              (((westBelow >>> x) & 1) << 4) |
              ((x === SIZE - 1 ? 1 : (westBelow >>> (x + 1)) & 1) << 5);
            places[coded++] = (i << 16) | (at + x);
          }
        } else {
          const b = voxels[below + x]!;
          const isLevel = (level >>> x) & 1;
          const base = isLevel ? n : b;
          const other = isLevel ? b : n;
          contexts[coded] =
            192 |
            (base === west ? 1 : 0) |
            (other === west ? 2 : 0) |
            (isSame << 2) |
            (((upright >>> x) & 1) << 3) |
            (isLevel << 4) |
            (((levelSouth >>> x) & 1) << 5);
          places[coded++] = (i << 16) | (at + x);
        }
      } else {
        const b = voxels[below + x]!;
        const isLevel = (level >>> x) & 1;
        const base = isLevel ? n : b;
        const other = isLevel ? b : n;
        const eastFirst = base === east || (base !== west && other === east);
        const first = eastFirst ? east : west;
        const second = eastFirst ? west : east;
        voxels[at + x] = first;
        contexts[coded] =
          256 |
          (base === first ? 1 : 0) |
          (other === first ? 2 : 0) |
          (base === second ? 4 : 0) |
          (other === second ? 8 : 0) |
          (((upright >>> x) & 1) << 4) |
          (isLevel << 5) |
          (((levelSouth >>> x) & 1) << 6);
        places[coded++] = (i << 16) | (at + x);
      }
      west = east;
    }
    this.coded = coded;
    const count = countBits(steady);
    if (exceptions.gap >= count) exceptions.gap -= count;
    else this.takeExceptions(source, row, steady, count);
  }

  /** Assigns the materials of exceptions among the steady voxels of a row. */
  private takeExceptions(source: Source, row: number, steady: number, count: number): void {
    const { exceptions } = this;
    while (exceptions.gap < count) {
      for (let skip = exceptions.gap; skip > 0; --skip) steady &= steady - 1;
      const x = 31 - Math.clz32(steady & -steady);
      steady &= steady - 1;
      count -= exceptions.gap + 1;
      this.voxels[row * SIZE + x] = exceptions.take(source);
    }
    exceptions.gap -= count;
  }

  private readBatch(source: Source, intervals: Int32Array): void {
    const { contexts, places, voxels, escapes, coded } = this;
    const { bytes, states } = source;
    let next = source.next;
    let escaped = 0;
    let bad = false;
    for (let i = 0; i < coded; ++i) {
      const ends = intervals[contexts[i]!]!;
      const lane = i & (LANES - 1);
      let state = states[lane]!;
      const slot = state & 0xff;
      const first = ends & 0xff;
      if (slot < first) {
        state = first * (state >> 8) + slot;
      } else {
        const second = (ends >> 8) & 0xff;
        const third = ends >> 16;
        const place = places[i]!;
        if (slot >= third) {
          state = (256 - third) * (state >> 8) + slot - third;
          escapes[escaped++] = place & 0xffff;
        } else {
          let symbol = 1;
          if (slot < second) {
            state = (second - first) * (state >> 8) + slot - first;
          } else {
            symbol = 2;
            state = (third - second) * (state >> 8) + slot - second;
          }
          const found = this.candidate(place, symbol);
          if (found < 0) bad = true;
          else voxels[place & 0xffff] = found;
        }
      }
      const taken = (state - 256) >>> 31;
      states[lane] = (state << (taken << 3)) | (bytes[next]! & -taken);
      next += taken;
    }
    source.next = next;
    for (let i = 0; i < escaped; ++i) voxels[escapes[i]!] = this.materials.read(source, i & (LANES - 1));
    source.checkRead();
    if (bad) throw new DecodeError('bad_number');
  }

  private candidate(place: number, symbol: number): number {
    const i = place >>> 16;
    const voxel = place & 0xffff;
    return candidate(
      this.voxels,
      voxel & ~(SIZE - 1),
      this.north[i]! * SIZE,
      this.below[i]! * SIZE,
      this.belowNorth[i]! * SIZE,
      this.belowSouth[i]! * SIZE,
      voxel & (SIZE - 1),
      symbol,
    );
  }

  /** Fills a row with the first candidates of its even columns: north if level, otherwise below. */
  private copyBase(row: number, north: number, below: number, level: number): void {
    const { pairs, voxels } = this;
    const to = row * (SIZE / 2);
    const from = (level === ALL ? north : below) * (SIZE / 2);
    for (let i = 0; i < SIZE / 2; ++i) pairs[to + i] = pairs[from + i]!;
    if (level === ALL) return;
    for (let left = level & EVEN; left !== 0; left &= left - 1) {
      const x = 31 - Math.clz32(left & -left);
      voxels[row * SIZE + x] = voxels[north * SIZE + x]!;
    }
  }

  /** Computes what later rows need of a row. */
  private compareRow(i: number, row: number): void {
    const north = this.north[i]!;
    if (this.quiet[i]) {
      // Rows around it are of one material, according to `full`, and so is this row.
      this.rowMaterial[row] = this.rowMaterial[north]!;
      this.equalsWest[row] = this.equalsNorth[row] = this.equalsBelow[row] = ALL;
      return;
    }
    const { pairs } = this;
    const below = this.below[i]!;
    const at = row * (SIZE / 2);
    const atNorth = north * (SIZE / 2);
    const atBelow = below * (SIZE / 2);
    let before = pairs[at]! << 16;
    let equalsWest = 0;
    let equalsNorth = 0;
    let equalsBelow = 0;
    for (let k = 0; k < SIZE / 2; ++k) {
      const pair = pairs[at + k]! | 0;
      equalsWest |= equalInPair(pair, (pair << 16) | (before >>> 16)) << (2 * k);
      equalsNorth |= equalInPair(pair, pairs[atNorth + k]!) << (2 * k);
      equalsBelow |= equalInPair(pair, pairs[atBelow + k]!) << (2 * k);
      before = pair;
    }
    this.equalsWest[row] = equalsWest;
    this.equalsNorth[row] = equalsNorth;
    this.equalsBelow[row] = equalsBelow;
    this.rowMaterial[row] = equalsWest === ALL ? before >>> 16 : MIXED;
  }

  private equalRows(a: number, b: number): number {
    const material = this.rowMaterial[a]!;
    if (material !== MIXED && this.rowMaterial[b] !== MIXED) return material === this.rowMaterial[b] ? ALL : 0;
    const { pairs } = this;
    const atA = a * (SIZE / 2);
    const atB = b * (SIZE / 2);
    let equal = 0;
    for (let k = 0; k < SIZE / 2; ++k) equal |= equalInPair(pairs[atA + k]!, pairs[atB + k]!) << (2 * k);
    return equal;
  }
}

/** For two voxels each, in two halves: bit 0 is set if the low ones are equal, bit 1 if the high ones are. Avoids an
 *  unpredictable branch. */
function equalInPair(a: number, b: number): number {
  const differ = a ^ b;
  return (((differ & 0xffff) - 1) >>> 31) | ((((differ >>> 16) - 1) >>> 30) & 2);
}

function isZero(value: number): number {
  return ((value | -value) >>> 31) ^ 1;
}

function countBits(bits: number): number {
  bits -= (bits >>> 1) & 0x55555555;
  bits = (bits & 0x33333333) + ((bits >>> 2) & 0x33333333);
  return Math.imul((bits + (bits >>> 4)) & 0x0f0f0f0f, 0x01010101) >>> 24;
}
