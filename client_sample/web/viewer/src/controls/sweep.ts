// Moves a box through voxels along one axis until it touches something solid.

export type Vector = [number, number, number];

/** Corners of an axis-aligned box. A voxel (x, y, z) fills [x, x + 1) along each axis. */
export interface Box {
  readonly low: Readonly<Vector>;
  readonly high: Readonly<Vector>;
}

export type IsSolid = (x: number, y: number, z: number) => boolean;

/** Boxes that touch a voxel's face do not overlap it, even with rounding errors. */
const SKIN = 1e-4;

const firstVoxel = (low: number) => Math.floor(low + SKIN);
const lastVoxel = (high: number) => Math.ceil(high - SKIN) - 1;

export function overlaps(box: Box, solid: IsSolid): boolean {
  for (let y = firstVoxel(box.low[1]); y <= lastVoxel(box.high[1]); ++y)
    for (let z = firstVoxel(box.low[2]); z <= lastVoxel(box.high[2]); ++z)
      for (let x = firstVoxel(box.low[0]); x <= lastVoxel(box.high[0]); ++x) if (solid(x, y, z)) return true;
  return false;
}

/** The distance, out of `distance`, that the box moves along `axis` (0 to 2) before it touches something solid. */
export function sweep(box: Box, axis: 0 | 1 | 2, distance: number, solid: IsSolid): number {
  if (distance === 0) return 0;
  const [u, v] = axis === 0 ? ([1, 2] as const) : axis === 1 ? ([0, 2] as const) : ([0, 1] as const);
  const at: Vector = [0, 0, 0];
  const isWall = (layer: number) => {
    at[axis] = layer;
    for (at[u] = firstVoxel(box.low[u]); at[u] <= lastVoxel(box.high[u]); ++at[u])
      for (at[v] = firstVoxel(box.low[v]); at[v] <= lastVoxel(box.high[v]); ++at[v])
        if (solid(at[0], at[1], at[2])) return true;
    return false;
  };
  // Every layer of voxels between the leading face's start and end.
  if (distance > 0) {
    const face = box.high[axis];
    for (let layer = lastVoxel(face) + 1; layer <= lastVoxel(face + distance); ++layer)
      if (isWall(layer)) return Math.max(0, layer - face);
  } else {
    const face = box.low[axis];
    for (let layer = firstVoxel(face) - 1; layer >= firstVoxel(face + distance); --layer)
      if (isWall(layer)) return Math.min(0, layer + 1 - face);
  }
  return distance;
}
