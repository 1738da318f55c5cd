// A world's heights as received, from which a View with a horizon computes its rows.
import type { Heights } from '../view_shape.js';
import { broken } from './table.js';

/** Maximum rows of a world: no generator makes more (core/voxel/include/talus/voxel/coords.h). */
const MAX_WORLD_ROWS = 2 ** 17;
const WORLD_EDGE = 2 ** 36;

/** Throws a TalusError if no world can have these heights. */
export function checkHeights({ minY, maxY }: Heights): void {
  if (minY >= -WORLD_EDGE && maxY <= WORLD_EDGE && minY <= maxY && maxY - minY <= MAX_WORLD_ROWS) return;
  throw broken(`a world with heights from ${minY} to ${maxY}; worlds have at most ${MAX_WORLD_ROWS} rows`);
}
