// What the page and its meshing workers say to each other.
import type { ChunkMesh } from '../mesh/mesher.js';
import type { Changes } from './changes.js';

export interface ChunkData {
  readonly lod: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** null where `material` is not. */
  readonly payload: Uint8Array | null;
  readonly material: number | null;
  /** What the voxels must have; null: nobody said. */
  readonly hash: string | null;
}

export interface SlicePlane {
  readonly x: number;
  readonly z: number;
  /** Of the side that is taken away. */
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
  /** Which of the 27 chunks around it to take: bit (dy + 1) * 9 + (dz + 1) * 3 + dx + 1. */
  readonly known: number;
  readonly slice: SlicePlane | null;
}

export type ToWorker =
  | { readonly kind: 'world'; readonly kinds: Uint8Array; readonly places: Uint16Array }
  /** The jobs are of what is held after the changes. */
  | { readonly kind: 'work'; readonly changes: Changes | null; readonly jobs: readonly Job[] };

export type FromWorker =
  | { readonly kind: 'meshed'; readonly id: number; readonly mesh: ChunkMesh; readonly ms: number; readonly heldBytes: number }
  | { readonly kind: 'failed'; readonly id: number; readonly text: string };
