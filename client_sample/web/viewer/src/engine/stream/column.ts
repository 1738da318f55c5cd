// Chunks of the land, and the columns that they stand in.
import { ByRow } from './by_row.js';
import type { SlicePlane } from './messages.js';

/** Row of a column without ground, or without liquid. */
export const NO_HEIGHT = -32768;

/** A mesh on the GPU. */
export interface Drawable {
  readonly slot: number;
  /** Its lowest and highest ends, in blocks of the world. */
  readonly bottom: number;
  readonly top: number;
}

export type Kind = 'gas' | 'liquid' | 'solid';

export class Chunk<D extends Drawable = Drawable> {
  payload: Uint8Array | null = null;
  /** What its voxels must have; null: nobody said. */
  hash: string | null = null;
  /** Of a chunk of one material. */
  material: number | null = null;
  arrived = 0;
  /** Neighbours that are held, as bits (Job.known). */
  known = 0;
  /** What the mesh was made with; -1: not meshed yet. */
  meshedWith = -1;
  meshedSlice: SlicePlane | null = null;
  changed = false;
  /** Something in it was edited: it goes before all that is not. */
  hurried = false;
  job: { id: number; known: number; slice: SlicePlane | null; slot: number } | null = null;
  queued = false;
  /** Among those that are queued, the least goes first. */
  order = 0;
  left = false;
  drawable: D | null = null;
  tops: Uint8Array | null = null;
  liquidTops: Uint8Array | null = null;

  constructor(
    readonly column: Column<D>,
    readonly y: number,
  ) {}

  get lod(): number {
    return this.column.lod;
  }
  get x(): number {
    return this.column.x;
  }
  get z(): number {
    return this.column.z;
  }
}

export class Column<D extends Drawable = Drawable> {
  readonly chunks = new ByRow<Chunk<D>>();
  /** At (dz + 1) * 3 + dx + 1 the column there, where one is held, and this one in the middle. */
  readonly near: (Column<D> | undefined)[] = Array.from({ length: 9 });
  /** Of the View: bit (dz + 1) * 3 + dx + 1 for the columns around. */
  around = 0;
  wanted = false;
  drawn = false;
  /** The last cover that had it, of those that Land counts. */
  coveredIn = 0;
  ready = false;
  begun = false;
  /** Voxel rows of the level, of the highest solid voxel + 1 and of liquid; a great negative number: none. */
  heights: Int16Array | null = null;
  liquids: Int16Array | null = null;
  lowest = -32768;
  /** Of the meshes of its chunks. */
  readonly slots: number[] = [];
  /** Ends of all of them. */
  bottom = Infinity;
  top = -Infinity;
  left = 0;
  /** Whether a slice cut it when that was last looked at. */
  cut = false;
  /** Sides (mesh/quad.ts, SKIRTS) beyond which another level is drawn, as bits. */
  skirts = 0;

  constructor(
    readonly lod: number,
    readonly x: number,
    readonly z: number,
  ) {
    this.near[4] = this;
  }

  findSkirts(): void {
    const { near } = this;
    this.skirts = (near[3]?.drawn ? 0 : 1) | (near[1]?.drawn ? 0 : 2) | (near[5]?.drawn ? 0 : 4) | (near[7]?.drawn ? 0 : 8);
  }

  /** What its chunks are drawn by has changed. */
  gather(): void {
    this.slots.length = 0;
    this.bottom = Infinity;
    this.top = -Infinity;
    for (const { drawable } of this.chunks.values()) {
      if (drawable === null) continue;
      this.slots.push(drawable.slot);
      this.bottom = Math.min(this.bottom, drawable.bottom);
      this.top = Math.max(this.top, drawable.top);
    }
  }
}
