// What a client may change, and what it is told: PROTOCOL.md, "Edit".
import type { Position, Voxels } from '../types.js';

/** Of an edit's writes, what a voxel is to be of; of its guards, what it must be of. */
export interface VoxelWrite {
  /** Base voxel. */
  readonly voxel: Position;
  readonly material: number;
}

/** Every voxel of a box. */
export interface Fill {
  /** The lowest corner, and the highest; both are of the box. */
  readonly first: Position;
  readonly last: Position;
  /** 'generated' undoes edits: as the voxels were made. */
  readonly material: number | 'generated';
  /** Voxels of other materials stay as they are; absent: all are filled. */
  readonly only?: number;
}

/** A chunk's voxels, at any place. */
export interface Paste {
  /** Base voxel to which voxel (0, 0, 0) comes. */
  readonly origin: Position;
  readonly voxels: Voxels;
  /** Whether its air is written too; default false. */
  readonly withAir?: boolean;
}

/** Where all guards hold, writes, fills and the paste are done in this order, each on what those before it left. It
 *  happens whole or not at all, in whatever chunks it reaches. */
export interface Edit {
  readonly guards?: readonly VoxelWrite[];
  readonly writes?: readonly VoxelWrite[];
  readonly fills?: readonly Fill[];
  readonly paste?: Paste;
  /** Of a game server whose token has the right "gateway": the player for whom it edits, at most 256 bytes. */
  readonly subject?: string;
}

/** The edit happened, and is stored. */
export interface EditDone {
  /** Of the world after it. */
  readonly revision: bigint;
  /** Voxels; 0: all was so before. */
  readonly changed: number;
}

/** What one edit may have, and how fast edits may come; 0: no limit. */
export interface EditLimits {
  /** That an edit names, guards and all operations together. */
  readonly voxels: number;
  /** Of level 0 that it reaches. */
  readonly chunks: number;
  /** Edits without an answer; the client keeps more back by itself. */
  readonly unanswered: number;
  readonly voxelsPerSecond: number;
}
