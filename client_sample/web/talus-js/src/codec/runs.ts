// Run-length coding: FORMAT.md, "Runs".
import { DecodeError } from './decode_error.js';
import { readDigits } from './digits.js';
import { MaterialCode } from './material_code.js';
import { fillSlots, LANES, type Slots, type Source } from './source.js';

const VOLUME = 32_768;
const DIGIT_COUNTS = 16;

export class RunsDecoder {
  private readonly materials = new MaterialCode();
  private readonly digits: Slots = new Int32Array(256);
  private readonly lengths = new Int32Array(LANES);

  decode(source: Source, voxels: Uint16Array): void {
    this.materials.take(source);
    const count = source.number();
    const single = count === VOLUME;
    if (!single) {
      if (source.left() < DIGIT_COUNTS) throw new DecodeError('truncated');
      fillSlots(this.digits, source.bytes.subarray(source.next, source.next + DIGIT_COUNTS));
      source.next += DIGIT_COUNTS;
    }
    source.takeStates();
    if (single) {
      this.readSingle(source, voxels);
    } else {
      this.readRuns(source, count, voxels);
    }
    source.checkAllRead();
    source.checkFinalStates();
  }

  private readSingle(source: Source, voxels: Uint16Array): void {
    for (let i = 0; i < VOLUME; ++i) {
      voxels[i] = this.materials.read(source, i % LANES);
      if (i % 256 === 255) source.checkRead();
    }
  }

  private readRuns(source: Source, count: number, voxels: Uint16Array): void {
    let filled = 0;
    for (let left = count; left > 0; left -= LANES) {
      const size = Math.min(left, LANES);
      readDigits(source, this.digits, size, this.lengths);
      // Materials are read to the group's end even if a length is invalid, because truncation is reported first.
      let bad = false;
      for (let i = 0; i < size; ++i) {
        const id = this.materials.read(source, i);
        const end = filled + this.lengths[i]! + 1;
        bad ||= end > VOLUME;
        if (bad) continue;
        if (end === filled + 1) voxels[filled] = id;
        else voxels.fill(id, filled, end);
        filled = end;
      }
      source.checkRead();
      if (bad) throw new DecodeError('bad_number');
    }
    if (filled !== VOLUME) throw new DecodeError('bad_number');
  }
}
