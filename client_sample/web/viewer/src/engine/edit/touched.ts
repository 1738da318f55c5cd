// Finds the neighbours affected by changes in a chunk, so that only these are remeshed.

/** All 27 bits of Job.known. */
export const ALL_AROUND = (1 << 27) - 1;
const VOLUME = 32_768;

/** Compares voxels, or uniform materials, before and after: bit (dy + 1) * 9 + (dz + 1) * 3 + dx + 1 for each neighbour
 *  that touches a changed voxel. */
export function touchedNeighbours(before: number | Uint16Array, after: number | Uint16Array): number {
  const at = (voxels: number | Uint16Array, i: number) => (typeof voxels === 'number' ? voxels : voxels[i]);
  let bits = 0;
  for (let i = 0; i < VOLUME; i++) {
    if (at(before, i) === at(after, i)) continue;
    const [x, z, y] = [i & 31, (i >> 5) & 31, i >> 10];
    const low = (v: number) => (v === 0 ? -1 : 0);
    const high = (v: number) => (v === 31 ? 1 : 0);
    for (let dy = low(y); dy <= high(y); dy++)
      for (let dz = low(z); dz <= high(z); dz++)
        for (let dx = low(x); dx <= high(x); dx++) bits |= 1 << ((dy + 1) * 9 + (dz + 1) * 3 + dx + 1);
  }
  return bits;
}
