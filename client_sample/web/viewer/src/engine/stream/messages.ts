// Messages between the page and its meshing workers.
import type { ChunkMesh } from '../mesh/mesher.js';
import type { Changes } from './changes.js';

export interface ChunkData {
  readonly lod: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** null if `material` is not null. */
  readonly payload: Uint8Array | null;
  readonly material: number | null;
  /** Expected hash of the voxels; null: unknown. */
  readonly hash: string | null;
}

export interface SlicePlane {
  readonly x: number;
  readonly z: number;
  /** Normal towards the side removed. */
  readonly nx: number;
  readonly nz: number;
}

export interface Job {
  readonly id: number;
  readonly lod: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly slot: number;
  /** The chunks to use of the 27 around it: bit (dy + 1) * 9 + (dz + 1) * 3 + dx + 1. */
  readonly known: number;
  readonly slice: SlicePlane | null;
}

export type ToWorker =
  | { readonly kind: 'world'; readonly kinds: Uint8Array; readonly places: Uint16Array }
  /** The jobs refer to the state after the changes. */
  | { readonly kind: 'work'; readonly changes: Changes | null; readonly jobs: readonly Job[] };

export type FromWorker =
  | { readonly kind: 'meshed'; readonly id: number; readonly mesh: ChunkMesh; readonly ms: number; readonly heldBytes: number }
  | { readonly kind: 'failed'; readonly id: number; readonly text: string };
