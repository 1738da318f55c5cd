// How one moves, said to who has just arrived: until he moves, or for a while.
import { find } from './dom';

const SHOWN_MS = 12_000;

export class Hint {
  readonly #box = find('hint');
  #isDone = false;
  /** Since when it has been read undisturbed; null: not yet. */
  #since: number | null = null;

  constructor(onClosed: () => void) {
    find('hint-close').addEventListener('click', () => {
      this.#isDone = true;
      this.#box.hidden = true;
      onClosed();
    });
  }

  /** `isSettled`: all of the land is here and no panel hides the hint, so that one has the time to read. */
  tick(now: number, isSettled: boolean, hasMoved: boolean): void {
    if (this.#isDone) return;
    // Who points at it, or came to its button by keyboard, is not done with it.
    const isHeld = this.#box.matches(':hover, :focus-within');
    if (!isSettled || isHeld) this.#since = null;
    else this.#since ??= now;
    this.#isDone = hasMoved || (this.#since !== null && now - this.#since > SHOWN_MS);
    if (this.#box.hidden !== this.#isDone) this.#box.hidden = this.#isDone;
  }
}
