/** How far below its voxel's top a liquid's surface is drawn, in blocks. */
export const SURFACE_BELOW_TOP = 0.14;

/** Where an eye is to the drawn surface of a liquid in its column. `close`: within half a block of it. */
export function waterline(liquidAt: (y: number) => boolean, y: number): { under: boolean; close: boolean } {
  const aligned = y + SURFACE_BELOW_TOP; // a surface counts as its voxel's top
  return {
    under: liquidAt(y) && liquidAt(aligned),
    close: liquidAt(aligned - 0.5) !== liquidAt(aligned + 0.5),
  };
}
