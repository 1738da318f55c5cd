// The held columns, each with the eight around it.
import { Column, type Drawable } from './column.js';
import { columnKey } from './keys.js';

export class Columns<D extends Drawable> {
  private readonly held = new Map<number, Column<D>>();

  get(lod: number, x: number, z: number): Column<D> | undefined {
    return this.held.get(columnKey(lod, x, z));
  }

  values(): Iterable<Column<D>> {
    return this.held.values();
  }

  add(column: Column<D>): void {
    this.held.set(columnKey(column.lod, column.x, column.z), column);
    this.eachAround(column, (other, at) => {
      column.near[at] = other;
      other.near[8 - at] = column;
    });
  }

  delete(column: Column<D>): void {
    this.held.delete(columnKey(column.lod, column.x, column.z));
    this.eachAround(column, (other, at) => {
      column.near[at] = other.near[8 - at] = undefined;
    });
  }

  private eachAround({ lod, x, z }: Column<D>, visit: (other: Column<D>, at: number) => void): void {
    for (let at = 0; at < 9; at++) {
      const other = at === 4 ? undefined : this.get(lod, x + (at % 3) - 1, z + Math.floor(at / 3) - 1);
      if (other !== undefined) visit(other, at);
    }
  }
}
