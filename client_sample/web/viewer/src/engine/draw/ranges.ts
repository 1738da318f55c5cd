// First-fit allocation of rows; free neighbours are merged.
export class Ranges {
  private free: { first: number; count: number }[];

  constructor(readonly size: number) {
    this.free = [{ first: 0, count: size }];
  }

  get freeRows(): number {
    return this.free.reduce((sum, range) => sum + range.count, 0);
  }

  /** Returns the first row; -1: no contiguous room. */
  take(count: number): number {
    for (let i = 0; i < this.free.length; i++) {
      const range = this.free[i]!;
      if (range.count < count) continue;
      const first = range.first;
      range.first += count;
      range.count -= count;
      if (range.count === 0) this.free.splice(i, 1);
      return first;
    }
    return -1;
  }

  give(first: number, count: number): void {
    let i = this.free.findIndex((range) => range.first > first);
    if (i < 0) i = this.free.length;
    const before = this.free[i - 1];
    const after = this.free[i];
    if (before !== undefined && before.first + before.count === first) {
      before.count += count;
      if (after !== undefined && before.first + before.count === after.first) {
        before.count += after.count;
        this.free.splice(i, 1);
      }
    } else if (after !== undefined && first + count === after.first) {
      after.first = first;
      after.count += count;
    } else {
      this.free.splice(i, 0, { first, count });
    }
  }
}
