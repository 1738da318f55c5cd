// Computes the voxels that an edit would change from the view: independent of page and engine.
import type { Hit, Vector } from '../engine/api';

export type Tool = 'dig' | 'build' | 'fill';

export const AIR = 0;
/** Maximum voxels of a fill, so that a few edits undo it. */
export const FILL_MAX = 4096;

/** Both corners included, the lowest first. */
export interface Box {
  readonly first: Vector;
  readonly last: Vector;
}

export const voxelOf = ({ x, y, z }: Vector): Vector => ({ x, y, z });

/** The voxel in front of the face hit; null: the ray began inside it. */
export function beforeFace({ x, y, z, normal }: Hit): Vector | null {
  if (normal.x === 0 && normal.y === 0 && normal.z === 0) return null;
  return { x: x + normal.x, y: y + normal.y, z: z + normal.z };
}

/** The voxel that a tool changes: the one in view for removing, otherwise the one in front of it. */
export function aim(hit: Hit, tool: Tool, material: number): Vector | null {
  return tool === 'dig' || material === AIR ? voxelOf(hit) : beforeFace(hit);
}

export function boxOf(a: Vector, b: Vector): Box {
  const both = (pick: (...of: number[]) => number) => ({ x: pick(a.x, b.x), y: pick(a.y, b.y), z: pick(a.z, b.z) });
  return { first: both(Math.min), last: both(Math.max) };
}

export function sidesOf({ first, last }: Box): readonly [number, number, number] {
  return [last.x - first.x + 1, last.y - first.y + 1, last.z - first.z + 1];
}

export function volumeOf(box: Box): number {
  return sidesOf(box).reduce((product, side) => product * side, 1);
}

export function eachVoxel({ first, last }: Box, visit: (voxel: Vector) => void): void {
  for (let y = first.y; y <= last.y; ++y)
    for (let z = first.z; z <= last.z; ++z) for (let x = first.x; x <= last.x; ++x) visit({ x, y, z });
}
