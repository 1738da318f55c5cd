// Columns in drawing order, so that near land hides distant land before it is shaded.
import type { Column, Drawable } from '../stream/column.js';

const MOVED = 32; // blocks
/** Distance steps: within a step, any order will do. */
const STEP = 16;
const STEPS = 1024;

export class NearestFirst<D extends Drawable> {
  private version = -1;
  private x = 0;
  private z = 0;
  readonly columns: Column<D>[] = [];
  /** By column, in blocks of the world: west end, north end, side. Separate, as columns are scattered in memory. */
  squares = new Float64Array();
  private readonly unsorted: Column<D>[] = [];
  private readonly steps: number[] = [];
  private readonly ends = new Uint32Array(STEPS);

  /** `version`: version of the set drawn. */
  update(drawn: readonly Column<D>[], version: number, x: number, z: number): this {
    if (version === this.version && Math.abs(x - this.x) + Math.abs(z - this.z) <= MOVED) return this;
    this.version = version;
    this.x = x;
    this.z = z;
    this.sort(drawn);
    this.measure();
    return this;
  }

  /** A counting sort. */
  private sort(drawn: readonly Column<D>[]): void {
    const { columns, unsorted, steps, ends } = this;
    ends.fill(0);
    let count = 0;
    for (const column of drawn) {
      const step = this.stepOf(column);
      unsorted[count] = column;
      steps[count++] = step;
      ends[step]!++;
    }
    for (let step = 1; step < STEPS; step++) ends[step]! += ends[step - 1]!;
    columns.length = unsorted.length = count;
    for (let i = count - 1; i >= 0; i--) columns[--ends[steps[i]!]!] = unsorted[i]!;
  }

  private measure(): void {
    const { columns } = this;
    if (this.squares.length < 3 * columns.length) this.squares = new Float64Array(6 * columns.length);
    const { squares } = this;
    for (let i = 0; i < columns.length; i++) {
      const { lod, x, z } = columns[i]!;
      const size = 32 * 2 ** lod;
      squares[3 * i] = x * size;
      squares[3 * i + 1] = z * size;
      squares[3 * i + 2] = size;
    }
  }

  private stepOf(column: Column<D>): number {
    const size = 32 * 2 ** column.lod;
    const distance = Math.hypot((column.x + 0.5) * size - this.x, (column.z + 0.5) * size - this.z) - size / 2;
    return Math.min(STEPS - 1, Math.max(0, Math.floor(distance / STEP)));
  }
}
