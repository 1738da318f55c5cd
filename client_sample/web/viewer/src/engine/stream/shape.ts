// Chunks of a View, level by level, from which the engine knows what is missing.
import { ViewShape, type LodRing, type View, type World } from 'talus';

export interface Square {
  readonly x0: number;
  readonly x1: number;
  readonly z0: number;
  readonly z1: number;
}

/** Columns and rows of one level, in chunks of it, both ends included. */
export interface LevelShape extends Square {
  readonly lod: number;
  readonly y0: number;
  readonly y1: number;
  /** Columns left out because the previous level has them. */
  readonly hole: Square | null;
}

/** By level; levels that the View lacks are absent. */
export type Shape = readonly (LevelShape | undefined)[];

const floorDiv = (a: number, b: number) => Math.floor(a / b);

/** Rings of ascending levels, each twice as far as the previous one, out to `horizon` blocks. */
export function ringsFor(radius: number, horizon: number): LodRing[] {
  const far = Math.ceil(horizon / 32);
  const rings: LodRing[] = [];
  for (let lod = 1, reach = radius; lod <= 6 && reach < far; lod++) {
    reach = lod === 6 ? far : Math.min(radius * 2 ** lod, far);
    rings.push({ lod, radius: reach });
  }
  return rings;
}

/** A View around a camera. Level 0 contains all rows of the world if the limits allow it. */
export function viewFor(
  world: Pick<World, 'minY' | 'maxY' | 'limits'>,
  camera: { x: number; y: number; z: number },
  direction: { x: number; y: number; z: number },
  radius: number,
  horizon: number,
): View {
  const limits = world.limits;
  const lowest = floorDiv(world.minY, 32);
  const highest = floorDiv(world.maxY - 1, 32);
  // Centred on the world's rows, so that ground precedes land deep below; centred on the player if the limits do not
  // allow all rows.
  const vertical = Math.min(Math.max(Math.ceil((highest - lowest) / 2), 1), limits.viewVerticalRadius);
  const row = Math.max(lowest + vertical, Math.min(floorDiv(camera.y, 32), highest - vertical));
  return {
    centre: { x: Math.floor(camera.x), y: row * 32 + 16, z: Math.floor(camera.z) },
    direction,
    horizontalRadius: Math.min(radius, limits.viewHorizontalRadius),
    verticalRadius: vertical,
    rings: ringsFor(Math.min(radius, limits.viewHorizontalRadius), horizon),
    horizon: limits.viewHorizon,
  };
}

export function shapeOf(view: View, world: Pick<World, 'minY' | 'maxY'>): Shape {
  const shape: (LevelShape | undefined)[] = [];
  for (const { lod, x, y, z, innerX, innerZ } of new ViewShape(view, world).boxes) {
    const hole = { x0: innerX.first, x1: innerX.last, z0: innerZ.first, z1: innerZ.last };
    const none = hole.x1 < hole.x0 || hole.z1 < hole.z0;
    shape[lod] = { lod, x0: x.first, x1: x.last, z0: z.first, z1: z.last, y0: y.first, y1: y.last, hole: none ? null : hole };
  }
  return shape;
}

export const inSquare = (square: Square, x: number, z: number): boolean =>
  x >= square.x0 && x <= square.x1 && z >= square.z0 && z <= square.z1;

/** True if a View of this shape has chunks of the column. */
export function hasColumn(shape: Shape, lod: number, x: number, z: number): boolean {
  const level = shape[lod];
  return level !== undefined && inSquare(level, x, z) && !(level.hole !== null && inSquare(level.hole, x, z));
}

/** The columns, among this and the eight around it, in a View of this shape, as bits (dz + 1) * 3 + dx + 1. */
export function columnsAround(shape: Shape, lod: number, x: number, z: number): number {
  const level = shape[lod];
  if (level === undefined) return 0;
  const { hole } = level;
  const isWithin = x > level.x0 && x < level.x1 && z > level.z0 && z < level.z1;
  const isByHole = hole !== null && x >= hole.x0 - 1 && x <= hole.x1 + 1 && z >= hole.z0 - 1 && z <= hole.z1 + 1;
  if (isWithin && !isByHole) return 511;
  let around = 0;
  for (let bit = 0; bit < 9; bit++) {
    if (hasColumn(shape, lod, x + (bit % 3) - 1, z + Math.floor(bit / 3) - 1)) around |= 1 << bit;
  }
  return around;
}

/** True if the level, or a finer one in its place, contains the column. */
export function reaches(shape: Shape, lod: number, x: number, z: number): boolean {
  const level = shape[lod];
  return level !== undefined && inSquare(level, x, z);
}

export function chunksOf(shape: Shape): number {
  const count = (first: number, last: number) => Math.max(0, last - first + 1);
  const area = (s: Square) => count(s.x0, s.x1) * count(s.z0, s.z1);
  let chunks = 0;
  for (const level of shape) {
    if (level === undefined) continue;
    chunks += (area(level) - (level.hole === null ? 0 : area(level.hole))) * count(level.y0, level.y1);
  }
  return chunks;
}
