// The part of a chunk that a slice keeps.
import type { KeptColumns } from '../mesh/mesher.js';
import { PADDED } from '../mesh/volume.js';
import type { SlicePlane } from './messages.js';

/** Signed distance in blocks of (x, z) from the plane, positive on the removed side. */
export const beyond = (plane: SlicePlane, x: number, z: number): number => (x - plane.x) * plane.nx + (z - plane.z) * plane.nz;

export type Side = 'kept' | 'cut' | 'gone';

/** Side of a square of blocks. */
export function sideOf(plane: SlicePlane, x: number, z: number, size: number): Side {
  const distances = [beyond(plane, x, z), beyond(plane, x + size, z), beyond(plane, x, z + size), beyond(plane, x + size, z + size)];
  if (Math.max(...distances) <= 0) return 'kept';
  return Math.min(...distances) >= 0 ? 'gone' : 'cut';
}

/** Removes voxels whose centre is beyond the plane. */
export function keptOf(plane: SlicePlane, lod: number, cx: number, cz: number): KeptColumns {
  const scale = 2 ** lod;
  const mask = new Uint32Array(PADDED);
  const west = new Uint8Array(PADDED);
  const east = new Uint8Array(PADDED);
  const kept = (x: number, z: number) => beyond(plane, (cx * 32 + x + 0.5) * scale, (cz * 32 + z + 0.5) * scale) <= 0;
  for (let z = -1; z <= 32; z++) {
    let bits = 0;
    for (let x = 0; x < 32; x++) if (kept(x, z)) bits |= 1 << x;
    mask[z + 1] = bits;
    west[z + 1] = kept(-1, z) ? 1 : 0;
    east[z + 1] = kept(32, z) ? 1 : 0;
  }
  return { mask, west, east };
}
