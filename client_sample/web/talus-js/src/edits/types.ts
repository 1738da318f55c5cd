// Edits of a client, and their result: PROTOCOL.md, "Edit".
import type { Position, Voxels } from '../types.js';

/** In an edit's writes, the new material of a voxel; in its guards, the required one. */
export interface VoxelWrite {
  /** Base voxel. */
  readonly voxel: Position;
  readonly material: number;
}

/** All voxels of a box. */
export interface Fill {
  /** The lowest and the highest corner, both included. */
  readonly first: Position;
  readonly last: Position;
  /** 'generated' undoes edits: restores the generated voxels. */
  readonly material: number | 'generated';
  /** Only voxels of this material change; absent: all. */
  readonly only?: number;
}

/** A chunk's voxels, at any position. */
export interface Paste {
  /** Base voxel at which voxel (0, 0, 0) is placed. */
  readonly origin: Position;
  readonly voxels: Voxels;
  /** True if its air is written too; default false. */
  readonly withAir?: boolean;
}

/** If all guards hold, writes, fills and the paste are applied in this order, each on the result of the previous ones.
 *  The edit is applied completely or not at all, in all chunks that it touches. */
export interface Edit {
  readonly guards?: readonly VoxelWrite[];
  readonly writes?: readonly VoxelWrite[];
  readonly fills?: readonly Fill[];
  readonly paste?: Paste;
  /** For a game server whose token has the right "gateway": the player that edits, at most 256 bytes. */
  readonly subject?: string;
}

/** The edit was applied and is stored. */
export interface EditDone {
  /** World revision after the edit. */
  readonly revision: bigint;
  /** Voxels; 0: they already had these materials. */
  readonly changed: number;
}

/** Limits of one edit and of their rate; 0: unlimited. */
export interface EditLimits {
  /** Named voxels, guards and all operations together. */
  readonly voxels: number;
  /** Touched chunks of level 0. */
  readonly chunks: number;
  /** Unanswered edits; the client holds back further ones. */
  readonly unanswered: number;
  readonly voxelsPerSecond: number;
}
