// Chooses the level of detail drawn at each place. Columns of chunks form a quadtree: a column of level l covers four
// of level l - 1. Every place is drawn at one level: the finest that is complete there, or, while a level of the View
// is missing, what was drawn before.
import { hasColumn, inSquare, reaches, type Shape } from './shape.js';

export interface CoverColumn {
  readonly lod: number;
  readonly x: number;
  readonly z: number;
  /** Everything visible of it is meshed. */
  readonly ready: boolean;
  /** Some of it is meshed. */
  readonly begun: boolean;
}

export interface Columns<C extends CoverColumn> {
  get(lod: number, x: number, z: number): C | undefined;
  values(): Iterable<C>;
}

/** Columns of one level by place, while none is added or removed: most are looked up repeatedly. */
class Grid<C extends CoverColumn> {
  private readonly columns: C[] = [];
  private x0 = Infinity;
  private x1 = -Infinity;
  private z0 = Infinity;
  private z1 = -Infinity;
  private places: (C | undefined)[] = [];

  add(column: C): void {
    this.columns.push(column);
    this.x0 = Math.min(this.x0, column.x);
    this.x1 = Math.max(this.x1, column.x);
    this.z0 = Math.min(this.z0, column.z);
    this.z1 = Math.max(this.z1, column.z);
  }

  lay(): void {
    if (this.columns.length === 0) return;
    const width = this.x1 - this.x0 + 1;
    this.places = new Array<C | undefined>(width * (this.z1 - this.z0 + 1)).fill(undefined);
    for (const column of this.columns) this.places[(column.z - this.z0) * width + column.x - this.x0] = column;
  }

  get(x: number, z: number): C | undefined {
    if (x < this.x0 || x > this.x1 || z < this.z0 || z > this.z1) return undefined;
    return this.places[(z - this.z0) * (this.x1 - this.x0 + 1) + x - this.x0];
  }
}

/** By level; excludes columns outside the square of the coarsest level, which left the View. */
function gridsOf<C extends CoverColumn>(shape: Shape, columns: Columns<C>): Grid<C>[] {
  const top = shape.length - 1;
  const roots = shape[top]!;
  const grids = Array.from(shape, () => new Grid<C>());
  for (const column of columns.values()) {
    const { lod, x, z } = column;
    if (lod <= top && inSquare(roots, x >> (top - lod), z >> (top - lod))) grids[lod]!.add(column);
  }
  for (const grid of grids) grid.lay();
  return grids;
}

/** Columns to draw, without overlaps. */
export function coverOf<C extends CoverColumn>(shape: Shape, columns: Columns<C>): C[] {
  const drawn: C[] = [];
  const top = shape.length - 1;
  if (top < 0) return drawn;
  const grids = gridsOf(shape, columns);

  const covered = (lod: number, x: number, z: number): boolean => {
    if (grids[lod]!.get(x, z)?.ready) return true;
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

  /** Returns true if anything was drawn. */
  const visit = (lod: number, x: number, z: number): boolean => {
    const column = grids[lod]!.get(x, z);
    if (lod > 0 && reaches(shape, lod - 1, 2 * x, 2 * z) && reaches(shape, lod - 1, 2 * x + 1, 2 * z + 1) &&
      kidsCovered(lod, x, z)) {
      return visitKids(lod, x, z);
    }
    if (column?.ready) {
      drawn.push(column);
      return true;
    }
    if (lod > 0 && visitKids(lod, x, z)) return true;
    if (column?.begun) {
      drawn.push(column);
      return true;
    }
    return false;
  };

  const roots = shape[top]!;
  for (let z = roots.z0; z <= roots.z1; z++) for (let x = roots.x0; x <= roots.x1; x++) visit(top, x, z);
  return drawn;
}

/** Distance in blocks from (x, z) to the View's nearest column that is not ready; null if all are ready. */
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
