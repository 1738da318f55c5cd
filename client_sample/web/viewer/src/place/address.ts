// The page's address follows the player, so that it leads to the view that is on the screen.
import { writeLink, type Place } from './place';

/** Browsers refuse more than some hundred changes in half a minute. */
const EVERY_MS = 500;

export class Address {
  #written = 0;
  #last = '';

  follow(now: number, place: Place): void {
    if (now - this.#written >= EVERY_MS) this.write(place, now);
  }

  write(place: Place, now = performance.now()): void {
    this.#written = now;
    const link = writeLink(place, location.hash);
    if (link === this.#last) return;
    this.#last = link;
    history.replaceState(history.state, '', link);
  }
}
