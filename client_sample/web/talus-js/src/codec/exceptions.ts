// Steady voxels that differ from the prediction: FORMAT.md, "Volume: reading a batch".
import { DecodeError } from './decode_error.js';
import { readDigits } from './digits.js';
import type { MaterialCode } from './material_code.js';
import { fillSlots, LANES, type Slots, type Source } from './source.js';
import { GAP_SIZES } from './volume_tables.js';

/** More than the steady voxels of a chunk. */
const NEVER = 1 << 30;

export class Exceptions {
  /** Steady voxels before the next exception, counted down by the caller. */
  gap = NEVER;
  private readonly counts: Slots = new Int32Array(256);
  private readonly gaps = new Int32Array(LANES);
  private readonly ids = new Int32Array(LANES);
  private materials!: MaterialCode;
  private inGroup = 0;
  private taken = 0; // from the group
  private left = 0; // after the group

  constructor() {
    fillSlots(this.counts, GAP_SIZES);
  }

  begin(source: Source, materials: MaterialCode, count: number): void {
    this.materials = materials;
    this.left = count;
    this.readGroup(source);
  }

  /** The material of the exception whose gap was counted down. May read past the end: the caller checks. */
  take(source: Source): number {
    const id = this.ids[this.taken++]!;
    if (this.taken < this.inGroup) this.gap = this.gaps[this.taken]!;
    else this.readGroup(source);
    return id;
  }

  checkAllTaken(): void {
    if (this.gap < NEVER - 32_768) throw new DecodeError('bad_number');
  }

  private readGroup(source: Source): void {
    const count = Math.min(this.left, LANES);
    this.taken = 0;
    this.inGroup = count;
    this.left -= count;
    this.gap = NEVER;
    if (count === 0) return;
    readDigits(source, this.counts, count, this.gaps);
    for (let i = 0; i < count; ++i) this.ids[i] = this.materials.read(source, i);
    this.gap = this.gaps[0]!;
  }
}
