// What a column has in each of its rows. A world has 4,354 rows at most, and a View far fewer: an array from the lowest on
// is found quicker, and is smaller, than a Map.
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

  /** From the lowest row on, as they are now: what comes or goes meanwhile does not matter. */
  values(): T[] {
    return this.rows.filter((value) => value !== undefined);
  }
}
