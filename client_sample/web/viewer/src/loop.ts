// Calls for a frame as often as the display does, or less often where a cap says so.

/** A frame after a pause (a tab that slept) moves nobody by the whole pause. */
const LONGEST_FRAME_S = 0.25;

export class Loop {
  #last = 0;
  readonly #ends: number[] = [];

  constructor(
    private readonly cap: () => number,
    private readonly frame: (now: number, seconds: number) => void,
  ) {}

  start(): void {
    const tick = (now: number) => {
      requestAnimationFrame(tick);
      const cap = this.cap();
      // A millisecond's slack: a display's frames do not come on the dot.
      if (cap > 0 && now - this.#last < 1000 / cap - 1) return;
      const seconds = Math.min(LONGEST_FRAME_S, Math.max(0, (now - this.#last) / 1000));
      this.#last = now;
      this.#ends.push(now);
      if (this.#ends.length > 60) this.#ends.shift();
      this.frame(now, seconds);
    };
    requestAnimationFrame(tick);
  }

  get framesPerSecond(): number {
    const [first, last] = [this.#ends[0], this.#ends.at(-1)];
    return first === undefined || last === undefined || last === first ? 0 : ((this.#ends.length - 1) * 1000) / (last - first);
  }
}
