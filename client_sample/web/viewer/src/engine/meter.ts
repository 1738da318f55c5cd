// Running figures for Stats.

/** The last `size` values, for percentiles. */
export class Sample {
  private readonly values: Float32Array;
  private count = 0;

  constructor(size: number) {
    this.values = new Float32Array(size);
  }

  add(value: number): void {
    this.values[this.count++ % this.values.length] = value;
  }

  percentiles(...wanted: number[]): number[] | null {
    const held = Math.min(this.count, this.values.length);
    if (held === 0) return null;
    const sorted = this.values.slice(0, held).sort();
    return wanted.map((p) => sorted[Math.min(held - 1, Math.floor(held * p))]!);
  }

  clear(): void {
    this.count = 0;
  }
}

/** Number of events in the last second. */
export class Rate {
  private readonly seconds = new Float64Array(2);
  private second = -1;

  add(now: number): void {
    this.turn(now);
    this.seconds[0]!++;
  }

  at(now: number): number {
    this.turn(now);
    const part = (now / 1000) % 1;
    return Math.round(this.seconds[0]! + this.seconds[1]! * (1 - part));
  }

  private turn(now: number): void {
    const second = Math.floor(now / 1000);
    if (second === this.second) return;
    this.seconds[1] = second === this.second + 1 ? this.seconds[0]! : 0;
    this.seconds[0] = 0;
    this.second = second;
  }
}
