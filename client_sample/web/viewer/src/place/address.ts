// The page's address follows the player, so that it leads to the current view.
import { writeLink, type Place } from './place';

/** Browsers limit changes to some hundreds in half a minute, and each takes milliseconds: the address is updated when
 *  the player rests, and after several checks. */
const CHECK_INTERVAL_MS = 500;
const MAX_CHECKS = 10;

export class Address {
  #checked = 0;
  #checks = 0;
  #seen = '';
  #written = '';

  follow(now: number, place: Place): void {
    if (now - this.#checked < CHECK_INTERVAL_MS) return;
    this.#checked = now;
    const link = writeLink(place, location.hash);
    const rests = link === this.#seen;
    this.#seen = link;
    if (link !== this.#written && (rests || ++this.#checks >= MAX_CHECKS)) this.#put(link);
  }

  write(place: Place): void {
    this.#put(writeLink(place, location.hash));
  }

  #put(link: string): void {
    this.#checks = 0;
    if (link === this.#written) return;
    this.#written = link;
    history.replaceState(history.state, '', link);
  }
}
