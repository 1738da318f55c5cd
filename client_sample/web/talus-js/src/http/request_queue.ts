// The application's requests: in their order, alternating with the View's requests, and before them.
import type { TalusError } from '../errors.js';

export class RequestQueue {
  private readonly waiting: (() => void)[] = [];
  running = 0;

  /** `ended()` returns why nothing may start any more, or null; `pump()` is called when something may start. */
  constructor(
    private readonly ended: () => TalusError | null,
    private readonly pump: () => void,
  ) {}

  inTurn<T>(what: () => Promise<T>): Promise<T> {
    return new Promise((resolve, reject) => {
      const error = this.ended();
      if (error !== null) throw error;
      this.waiting.push(() => {
        const ended = this.ended();
        if (ended !== null) {
          reject(ended);
          return;
        }
        ++this.running;
        what()
          .then(resolve, reject)
          .finally(() => {
            --this.running;
            this.pump();
          });
      });
      this.pump();
    });
  }

  /** Returns true if there was a request to start. */
  startNext(): boolean {
    const next = this.waiting.shift();
    next?.();
    return next !== undefined;
  }

  /** The client ended: all requests fail at once. */
  failAll(): void {
    for (const start of this.waiting.splice(0)) start();
  }
}
