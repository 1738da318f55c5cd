// Steps the world at the display's rate, and draws it at that rate or at a cap.

/** After a pause (a sleeping tab) a step covers at most this time. */
const LONGEST_STEP_S = 0.25;

/** Pictures may take longer than this; streaming does not wait for them. */
const UPDATE_EVERY_MS = 20;

export interface Turns {
  /** Called for each step, and between steps that are far apart. */
  update: () => void;
  step: (now: number, seconds: number) => void;
  draw: (now: number) => void;
  /** Maximum pictures per second; 0: the display's rate. */
  cap: () => number;
}

export class Loop {
  #stepped = 0;
  #drawn = 0;
  #updated = 0;
  readonly #drawnAt: number[] = [];

  constructor(private readonly turns: Turns) {}

  start(): void {
    const tick = (now: number) => {
      requestAnimationFrame(tick);
      this.turns.step(now, Math.min(LONGEST_STEP_S, Math.max(0, (now - this.#stepped) / 1000)));
      this.#stepped = now;
      this.#update();
      const cap = this.turns.cap();
      // A millisecond of tolerance: a display's frames are not exactly periodic.
      if (cap > 0 && now - this.#drawn < 1000 / cap - 1) return;
      this.#drawn = now;
      this.#drawnAt.push(now);
      if (this.#drawnAt.length > 60) this.#drawnAt.shift();
      this.turns.draw(now);
    };
    requestAnimationFrame(tick);
    setInterval(() => {
      if (performance.now() - this.#updated >= UPDATE_EVERY_MS) this.#update();
    }, UPDATE_EVERY_MS);
  }

  #update(): void {
    this.turns.update();
    this.#updated = performance.now();
  }

  get framesPerSecond(): number {
    const [first, last] = [this.#drawnAt[0], this.#drawnAt.at(-1)];
    return first === undefined || last === undefined || last === first ? 0 : ((this.#drawnAt.length - 1) * 1000) / (last - first);
  }
}
