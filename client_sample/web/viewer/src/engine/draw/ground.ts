// Heights of the land by level of detail, for lighting: sky occlusion, distant shadows, depth of water. Each level is a
// square of voxels that wraps around as the View moves.
import { DataArrayTexture, DataUtils, HalfFloatType, LinearFilter, RGFormat, RepeatWrapping, type WebGLRenderer } from 'three';
import { NO_HEIGHT, type Column, type Drawable } from '../stream/column.js';
import { bind } from './pages.js';

const NONE = DataUtils.toHalfFloat(-2048);
const LIMIT = 2047;
const HALVES = Uint16Array.from({ length: 2 * LIMIT + 1 }, (_, i) => DataUtils.toHalfFloat(i - LIMIT));

const TEXEL_BYTES = 4;

export class Ground {
  readonly texture: DataArrayTexture;
  readonly size: number;
  private readonly part = new Uint16Array(32 * 32 * 2);

  /** `base`: the row, at level 0, of height 0: half floats are exact integers up to 2,048 from it. */
  constructor(
    private readonly renderer: WebGLRenderer,
    radius: number,
    readonly levels: number,
    private readonly base: number,
  ) {
    this.size = sizeFor(radius);
    const texture = new DataArrayTexture(null, this.size, this.size, levels);
    texture.format = RGFormat;
    texture.type = HalfFloatType;
    texture.internalFormat = 'RG16F';
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.wrapS = texture.wrapT = RepeatWrapping;
    texture.source.dataReady = false;
    texture.needsUpdate = true;
    this.texture = texture;
    this.clear();
  }

  isFor(radius: number, levels: number, base: number): boolean {
    return this.size === sizeFor(radius) && this.levels === levels && this.base === base;
  }

  get bytes(): number {
    return this.size * this.size * this.levels * TEXEL_BYTES;
  }

  set<D extends Drawable>(column: Column<D>): void {
    if (column.lod >= this.levels) return;
    const base = this.base >> column.lod;
    const { heights, liquids } = column;
    for (let i = 0; i < 1024; i++) {
      this.part[2 * i] = half(heights?.[i] ?? NO_HEIGHT, base);
      this.part[2 * i + 1] = half(liquids?.[i] ?? NO_HEIGHT, base);
    }
    const chunks = this.size / 32;
    const at = (c: number) => (((c % chunks) + chunks) % chunks) * 32;
    this.write(at(column.x), at(column.z), column.lod, 32, 32, this.part);
  }

  clear(): void {
    const rows = new Uint16Array(this.size * 64 * 2).fill(NONE);
    for (let level = 0; level < this.levels; level++) {
      for (let row = 0; row < this.size; row += 64) this.write(0, row, level, this.size, 64, rows);
    }
  }

  dispose(): void {
    this.texture.dispose();
  }

  private write(x: number, y: number, level: number, width: number, height: number, data: Uint16Array): void {
    const gl = bind(this.renderer, this.texture, 0x8c1a);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, x, y, level, width, height, 1, gl.RG, gl.HALF_FLOAT, data);
  }
}

/** Columns of level 0, with a margin, must not wrap onto each other. */
const sizeFor = (radius: number): number => ((2 * radius + 3) * 32 <= 1024 ? 1024 : 2048);

function half(height: number, base: number): number {
  if (height === NO_HEIGHT) return NONE;
  return HALVES[Math.min(Math.max(height - base, -LIMIT), LIMIT) + LIMIT]!;
}
