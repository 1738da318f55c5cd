/** Distance in blocks of a liquid's drawn surface below its voxel's top. */
export const SURFACE_BELOW_TOP = 0.14;

/** Position of an eye relative to the drawn surface of a liquid in its column. `close`: within half a block. */
export function waterline(liquidAt: (y: number) => boolean, y: number): { under: boolean; close: boolean } {
  const aligned = y + SURFACE_BELOW_TOP; // a surface counts as its voxel's top
  return {
    under: liquidAt(y) && liquidAt(aligned),
    close: liquidAt(aligned - 0.5) !== liquidAt(aligned + 0.5),
  };
}
