// Chunks of the land, and their columns.
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
  /** Expected hash of its voxels; null: unknown. */
  hash: string | null = null;
  /** Material of a uniform chunk. */
  material: number | null = null;
  arrived = 0;
  /** Neighbours that are held, as bits (Job.known). */
  known = 0;
  /** Neighbours with which the mesh was made; -1: not meshed yet. */
  meshedWith = -1;
  meshedSlice: SlicePlane | null = null;
  changed = false;
  /** It was edited: it precedes all unedited chunks. */
  hurried = false;
  job: { id: number; known: number; slice: SlicePlane | null; slot: number } | null = null;
  queued = false;
  /** Among queued chunks, the lowest goes first. */
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
  /** The held column at each (dz + 1) * 3 + dx + 1, with this one in the middle. */
  readonly near: (Column<D> | undefined)[] = Array.from({ length: 9 });
  /** Neighbouring columns in the View: bit (dz + 1) * 3 + dx + 1. */
  around = 0;
  wanted = false;
  drawn = false;
  /** Number of the last cover that contained it. */
  coveredIn = 0;
  ready = false;
  begun = false;
  /** Voxel rows of the level: highest solid voxel + 1, and liquid; a large negative number if there are none. */
  heights: Int16Array | null = null;
  liquids: Int16Array | null = null;
  lowest = -32768;
  /** Slots of its chunks' meshes. */
  readonly slots: number[] = [];
  /** Ends of all meshes. */
  bottom = Infinity;
  top = -Infinity;
  left = 0;
  /** True if a slice cut it at the last check. */
  cut = false;
  /** Sides (mesh/quad.ts, SKIRTS) next to another drawn level, as bits. */
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

  /** The meshes of its chunks changed. */
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
