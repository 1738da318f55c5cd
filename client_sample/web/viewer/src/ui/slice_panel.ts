// The slice: a vertical plane across the player's view; the land on the player's side is removed.
import type { Slice } from '../engine/engine';
import { wrapDegrees } from '../place/place';
import { find, say } from './dom';

/** Blocks from the player: the nearest cut, the slider's maximum, and the default without a near target. */
const NEAREST = 4;
export const SLICE_FARTHEST = 256;
const USUAL = 96;

export interface Stand {
  readonly x: number;
  readonly z: number;
  /** Degrees. */
  readonly yaw: number;
  /** Horizontal distance in blocks to the target in view; null: nothing near. */
  readonly seen?: number | null;
}

/** Initial distance of the cut: at the target in view. A nearer cut would often show only air. */
export const firstDistance = (seen: number | null | undefined): number =>
  Math.round(Math.min(SLICE_FARTHEST, Math.max(NEAREST, seen ?? USUAL)));

/** The plane at `distance` in front of a stand, across its direction. Land on the stand's side is not drawn. */
export function planeBefore(stand: Stand, distance: number): Slice {
  const yaw = (stand.yaw * Math.PI) / 180;
  return { x: stand.x + Math.sin(yaw) * distance, z: stand.z - Math.cos(yaw) * distance, yaw: yaw + Math.PI };
}

export class SlicePanel {
  readonly #on = find<HTMLInputElement>('slice-on');
  readonly #distance = find<HTMLInputElement>('slice-distance');
  readonly #yaw = find<HTMLInputElement>('slice-yaw');
  #stand: Stand = { x: 0, z: 0, yaw: 0 };

  constructor(
    private readonly standNow: () => Stand,
    private readonly apply: (slice: Slice | null) => void,
  ) {
    this.#on.addEventListener('change', () => (this.#on.checked ? this.cutHere() : this.#send()));
    this.#distance.addEventListener('input', () => this.#send());
    this.#yaw.addEventListener('input', () => {
      // The plane turns around its own position, not around the player.
      const { x, z } = planeBefore(this.#stand, Number(this.#distance.value));
      this.#stand = { x, z, yaw: Number(this.#yaw.value) };
      this.#distance.value = '0';
      this.#send();
    });
    find('slice-here').addEventListener('click', () => this.cutHere());
    this.#send();
  }

  get slice(): Slice | null {
    return this.#on.checked ? planeBefore(this.#stand, Number(this.#distance.value)) : null;
  }

  cutHere(): void {
    const { x, z, yaw, seen } = this.standNow();
    this.#stand = { x, z, yaw: Math.round(wrapDegrees(yaw)) % 360 };
    this.#distance.value = String(firstDistance(seen));
    this.#yaw.value = String(this.#stand.yaw);
    this.#on.checked = true;
    this.#send();
  }

  off(): void {
    this.#on.checked = false;
    this.#send();
  }

  move(by: number): void {
    if (!this.#on.checked) return this.cutHere();
    this.#distance.value = String(Number(this.#distance.value) + by);
    this.#send();
  }

  #send(): void {
    say(find('slice-distance-now'), `${this.#distance.value} blocks`);
    say(find('slice-yaw-now'), `${this.#yaw.value}°`);
    find('slice-said').hidden = !this.#on.checked;
    this.apply(this.slice);
  }
}
