// Explains movement to a new player, until the player moves, or for a while.
import { find } from './dom';

const SHOWN_MS = 12_000;

export class Hint {
  readonly #box = find('hint');
  #isDone = false;
  /** Since when it could be read undisturbed; null: not yet. */
  #since: number | null = null;

  constructor(onClosed: () => void) {
    find('hint-close').addEventListener('click', () => {
      this.#isDone = true;
      this.#box.hidden = true;
      onClosed();
    });
  }

  /** `isSettled`: all land is loaded and no panel hides the hint, so that there is time to read it. */
  tick(now: number, isSettled: boolean, hasMoved: boolean): void {
    if (this.#isDone) return;
    // Keeps it while it is pointed at or focused.
    const isHeld = this.#box.matches(':hover, :focus-within');
    if (!isSettled || isHeld) this.#since = null;
    else this.#since ??= now;
    this.#isDone = hasMoved || (this.#since !== null && now - this.#since > SHOWN_MS);
    if (this.#box.hidden !== this.#isDone) this.#box.hidden = this.#isDone;
  }
}
