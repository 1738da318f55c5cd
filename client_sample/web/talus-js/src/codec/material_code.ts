// Materials with probabilities: FORMAT.md, section of that name.
import { DecodeError } from './decode_error.js';
import { fillSlots, type Slots, type Source } from './source.js';

const MAX_MATERIALS = 256;

export class MaterialCode {
  readonly ids = new Uint16Array(MAX_MATERIALS);
  private readonly slots: Slots = new Int32Array(256);

  take(source: Source): void {
    const ids = source.materials(MAX_MATERIALS);
    for (let i = 1; i < ids.length; ++i) {
      if (ids[i] === ids[0] || (i > 1 && ids[i]! <= ids[i - 1]!)) throw new DecodeError('bad_materials');
    }
    if (source.left() < ids.length) throw new DecodeError('truncated');
    const sizes = ids.map((_, i) => source.bytes[source.next + i]! + 1);
    fillSlots(this.slots, sizes);
    this.ids.set(ids);
    source.next += ids.length;
  }

  read(source: Source, lane: number): number {
    return this.ids[source.read(this.slots, lane)]!;
  }
}
