// Which level of detail is drawn where. Columns of chunks form a quadtree: a column of level l stands where four of
// level l - 1 do. The cover draws every place by one level: the finest that is wholly there, and where the View asks
// for a level that has not come yet, what was drawn before.
import { hasColumn, reaches, type Shape } from './shape.js';

export interface CoverColumn {
  readonly lod: number;
  readonly x: number;
  readonly z: number;
  /** All that can be seen of it is meshed. */
  readonly ready: boolean;
  /** Something of it is. */
  readonly begun: boolean;
}

export interface Columns<C extends CoverColumn> {
  get(lod: number, x: number, z: number): C | undefined;
  values(): Iterable<C>;
}

/** Columns to draw. No two of them overlap. */
export function coverOf<C extends CoverColumn>(shape: Shape, columns: Columns<C>): Set<C> {
  const drawn = new Set<C>();
  const top = shape.length - 1;

  const covered = (lod: number, x: number, z: number): boolean => {
    if (columns.get(lod, x, z)?.ready) return true;
    return lod > 0 && kidsCovered(lod, x, z);
  };
  const kidsCovered = (lod: number, x: number, z: number): boolean =>
    covered(lod - 1, 2 * x, 2 * z) && covered(lod - 1, 2 * x + 1, 2 * z) &&
    covered(lod - 1, 2 * x, 2 * z + 1) && covered(lod - 1, 2 * x + 1, 2 * z + 1);

  const visitKids = (lod: number, x: number, z: number): boolean => {
    const a = visit(lod - 1, 2 * x, 2 * z);
    const b = visit(lod - 1, 2 * x + 1, 2 * z);
    const c = visit(lod - 1, 2 * x, 2 * z + 1);
    const d = visit(lod - 1, 2 * x + 1, 2 * z + 1);
    return a || b || c || d;
  };

  /** Whether anything was drawn. */
  const visit = (lod: number, x: number, z: number): boolean => {
    const column = columns.get(lod, x, z);
    if (lod > 0 && reaches(shape, lod - 1, 2 * x, 2 * z) && reaches(shape, lod - 1, 2 * x + 1, 2 * z + 1) &&
      kidsCovered(lod, x, z)) {
      return visitKids(lod, x, z);
    }
    if (column?.ready) {
      drawn.add(column);
      return true;
    }
    if (lod > 0 && visitKids(lod, x, z)) return true;
    if (column?.begun) {
      drawn.add(column);
      return true;
    }
    return false;
  };

  if (top < 0) return drawn;
  const roots = shape[top]!;
  for (let z = roots.z0; z <= roots.z1; z++) for (let x = roots.x0; x <= roots.x1; x++) visit(top, x, z);
  // Columns may be held that lie beyond the coarsest level's square: they left the View, and go.
  return drawn;
}

/** Distance in blocks from (x, z) to the nearest column of the View that is not ready; null: none is. */
export function nearestMissing<C extends CoverColumn>(shape: Shape, columns: Columns<C>, x: number, z: number): number | null {
  let nearest = Infinity;
  for (const level of shape) {
    if (level === undefined) continue;
    const size = 32 * 2 ** level.lod;
    for (let cz = level.z0; cz <= level.z1; cz++) {
      for (let cx = level.x0; cx <= level.x1; cx++) {
        if (!hasColumn(shape, level.lod, cx, cz) || columns.get(level.lod, cx, cz)?.ready) continue;
        const dx = Math.max(cx * size - x, x - (cx + 1) * size, 0);
        const dz = Math.max(cz * size - z, z - (cz + 1) * size, 0);
        nearest = Math.min(nearest, dx * dx + dz * dz);
      }
    }
  }
  return nearest === Infinity ? null : Math.sqrt(nearest);
}
