// Values by row of a column. A world has at most 4,354 rows, and a View far fewer: an array from the lowest row is
// smaller and faster than a Map.
export class ByRow<T> {
  size = 0;
  private lowest = 0;
  private readonly rows: (T | undefined)[] = [];

  get(y: number): T | undefined {
    const at = y - this.lowest;
    return at >= 0 && at < this.rows.length ? this.rows[at] : undefined;
  }

  set(y: number, value: T): void {
    if (this.size === 0) {
      this.rows.length = 0;
      this.lowest = y;
    }
    while (y < this.lowest) {
      this.rows.unshift(undefined);
      this.lowest--;
    }
    while (y > this.lowest + this.rows.length) this.rows.push(undefined);
    if (this.get(y) === undefined) this.size++;
    this.rows[y - this.lowest] = value;
  }

  delete(y: number): void {
    if (this.get(y) === undefined) return;
    this.rows[y - this.lowest] = undefined;
    this.size--;
  }

  /** A copy from the lowest row on: later changes do not matter. */
  values(): T[] {
    return this.rows.filter((value) => value !== undefined);
  }
}
