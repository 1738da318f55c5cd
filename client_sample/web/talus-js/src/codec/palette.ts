// Palettes of version 3, with an adaptive binary range coder: FORMAT.md, "Version 3: palette".
import { DecodeError } from './decode_error.js';
import type { Source } from './source.js';

const SIZE = 32;
const BLOCK = 4;
const BLOCKS = SIZE / BLOCK;
const MAX_MATERIALS = 256;

/** Models of one kind of symbol: differs[5][3], then index[256]. */
const MODELS_OF_KIND = 15 + 256;

class RangeDecoder {
  private readonly fast: Uint16Array;
  private readonly slow: Uint16Array;
  private readonly age: Uint8Array;
  private range = 0xffffffff;
  private code = 0;
  private past = 0; // bytes read past the end
  private readonly allOnes: boolean;

  constructor(
    private readonly source: Source,
    models: number,
  ) {
    this.fast = new Uint16Array(models).fill(32_768);
    this.slow = new Uint16Array(models).fill(32_768);
    this.age = new Uint8Array(models);
    let ones = 0;
    for (let i = 0; i < 4; ++i) {
      const byte = this.byte();
      if (byte === 255) ++ones;
      this.code = (this.code * 256 + byte) >>> 0;
    }
    this.allOnes = ones === 4;
  }

  private byte(): number {
    if (this.source.next < this.source.end) return this.source.bytes[this.source.next++]!;
    if (++this.past > 2) throw new DecodeError('truncated');
    return 0;
  }

  read(model: number): number {
    const fast = this.fast[model]!;
    const slow = this.slow[model]!;
    const age = this.age[model]!;
    const bound = (this.range >>> 12) * ((fast + slow) >> 5);
    const bit = this.code < bound ? 0 : 1;
    const s = 32 - Math.clz32(age + 1);
    const f = Math.min(s, 4);
    if (age < 31) this.age[model] = age + 1;
    if (bit) {
      this.range -= bound;
      this.code -= bound;
      this.fast[model] = fast - (fast >> f);
      this.slow[model] = slow - (slow >> s);
    } else {
      this.range = bound;
      this.fast[model] = fast + ((65_536 - fast) >> f);
      this.slow[model] = slow + ((65_536 - slow) >> s);
    }
    while (this.range < 0x1000000) {
      this.range *= 256;
      this.code = this.code * 256 + this.byte();
    }
    return bit;
  }

  checkEnd(): void {
    if (this.past !== 2) throw new DecodeError('too_long');
    if (this.code > 0xffff || this.allOnes) throw new DecodeError('bad_ending');
  }
}

export function decodePalette(source: Source, voxels: Uint16Array): void {
  const ids = source.materials(MAX_MATERIALS);
  for (let i = 1; i < ids.length; ++i) {
    if (ids[i]! <= ids[i - 1]!) throw new DecodeError('bad_materials');
  }
  // Models: is_mixed[8], then those of blocks, then those of voxels.
  const coder = new RangeDecoder(source, 8 + 2 * MODELS_OF_KIND);
  const indices = new Uint8Array(SIZE * SIZE * SIZE);
  const mixed = new Uint8Array(BLOCKS * BLOCKS * BLOCKS);
  const at = (x: number, y: number, z: number): number =>
    x < 0 || y < 0 || z < 0 ? 0 : indices[(y * SIZE + z) * SIZE + x]!;

  const readSymbol = (models: number, x: number, y: number, z: number): number => {
    const below = at(x, y - 1, z);
    const west = at(x - 1, y, z);
    const north = at(x, y, z - 1);
    const pattern = below === west ? (west === north ? 0 : 1) : below === north ? 2 : west === north ? 3 : 4;
    const differs = models + pattern * 3;
    if (coder.read(differs) === 0) return below;
    if (west !== below && coder.read(differs + 1) === 0) return west;
    if (north !== below && north !== west && coder.read(differs + 2) === 0) return north;
    let node = 1;
    for (let i = 0; i < 8; ++i) node = node * 2 + coder.read(models + 15 + node);
    return node - 256;
  };

  const blockModels = 8;
  const voxelModels = 8 + MODELS_OF_KIND;
  for (let block = 0; block < mixed.length; ++block) {
    const bx = block % BLOCKS;
    const bz = (block >> 3) % BLOCKS;
    const by = block >> 6;
    const context =
      (bx > 0 ? mixed[block - 1]! : 0) +
      2 * (bz > 0 ? mixed[block - BLOCKS]! : 0) +
      4 * (by > 0 ? mixed[block - BLOCKS * BLOCKS]! : 0);
    mixed[block] = coder.read(context);
    const [x0, y0, z0] = [bx * BLOCK, by * BLOCK, bz * BLOCK];
    const only = mixed[block] ? 0 : readSymbol(blockModels, x0, y0, z0);
    for (let y = y0; y < y0 + BLOCK; ++y) {
      for (let z = z0; z < z0 + BLOCK; ++z) {
        for (let x = x0; x < x0 + BLOCK; ++x) {
          indices[(y * SIZE + z) * SIZE + x] = mixed[block] ? readSymbol(voxelModels, x, y, z) : only;
        }
      }
    }
  }
  coder.checkEnd();
  for (let i = 0; i < indices.length; ++i) {
    const index = indices[i]!;
    if (index >= ids.length) throw new DecodeError('bad_number');
    voxels[i] = ids[index]!;
  }
}
