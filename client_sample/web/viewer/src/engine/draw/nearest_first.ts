// Columns in the order in which they are drawn, so that what is near hides what is behind it before that is shaded.
import type { Column, Drawable } from '../stream/column.js';

const MOVED = 32; // blocks

export class NearestFirst<D extends Drawable> {
  private version = -1;
  private x = 0;
  private z = 0;
  private columns: Column<D>[] = [];

  /** `version`: of the set that is drawn. */
  of(drawn: Iterable<Column<D>>, version: number, x: number, z: number): readonly Column<D>[] {
    if (version === this.version && Math.abs(x - this.x) + Math.abs(z - this.z) <= MOVED) return this.columns;
    const distance = (c: Column<D>) => {
      const size = 32 * 2 ** c.lod;
      return Math.hypot((c.x + 0.5) * size - x, (c.z + 0.5) * size - z) - size / 2;
    };
    const keyed = Array.from(drawn, (column) => ({ column, at: distance(column) }));
    keyed.sort((a, b) => a.at - b.at);
    this.columns = keyed.map(({ column }) => column);
    this.version = version;
    this.x = x;
    this.z = z;
    return this.columns;
  }
}
