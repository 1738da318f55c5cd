// Fingers: on the left half a stick appears under the finger and moves; on the right half a finger looks; a tap picks.
import type { Device, Intent } from './intent';
import type { Settings } from '../place/settings';

/** Pixels from the centre of the stick to its edge. */
const REACH = 56;
const TAP_MS = 250;
const TAP_SLACK = 8;
/** A finger has less room than a mouse. */
const FINGER = 2;

interface Finger {
  readonly x: number;
  readonly y: number;
  readonly began: number;
  readonly moves: boolean;
  atX: number;
  atY: number;
  strayed: boolean;
}

export class Touch implements Device {
  readonly #fingers = new Map<number, Finger>();
  #yaw = 0;
  #pitch = 0;
  /** Held buttons: 1 up, -1 down. */
  up = 0;

  constructor(
    private readonly canvas: HTMLElement,
    private readonly stick: HTMLElement,
    private readonly settings: Settings,
    private readonly onPick: (x: number, y: number) => void,
    private readonly onFirst: () => void,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#move(event));
    canvas.addEventListener('pointerup', (event) => this.#lift(event, true));
    canvas.addEventListener('pointercancel', (event) => this.#lift(event, false));
  }

  /** A held button moves up or down. */
  hold(button: HTMLElement, direction: 1 | -1): void {
    const set = (to: number) => (event: Event) => {
      event.preventDefault();
      this.up = to;
    };
    button.addEventListener('pointerdown', set(direction));
    for (const end of ['pointerup', 'pointercancel', 'pointerleave']) button.addEventListener(end, set(0));
  }

  read(intent: Intent): void {
    const finger = this.#mover();
    if (finger !== undefined) {
      const [x, y] = [finger.atX - finger.x, finger.atY - finger.y];
      const length = Math.hypot(x, y);
      const push = Math.min(1, Math.max(0, length - TAP_SLACK) / (REACH - TAP_SLACK));
      if (push > 0) {
        intent.right += (x / length) * push;
        intent.forward -= (y / length) * push;
        // Pushing the stick beyond its edge runs.
        if (length > REACH * 1.6) intent.fast = true;
      }
    }
    intent.up += this.up;
    intent.yaw += this.#yaw;
    intent.pitch += this.#pitch;
    this.#yaw = this.#pitch = 0;
  }

  release(): void {
    this.#fingers.clear();
    this.up = this.#yaw = this.#pitch = 0;
    this.#show();
  }

  #mover(): Finger | undefined {
    return [...this.#fingers.values()].find((finger) => finger.moves);
  }

  #down(event: PointerEvent): void {
    if (event.pointerType === 'mouse') return;
    this.onFirst();
    this.canvas.setPointerCapture(event.pointerId);
    const moves = event.clientX < innerWidth / 2 && this.#mover() === undefined;
    const { clientX: x, clientY: y, timeStamp: began } = event;
    this.#fingers.set(event.pointerId, { x, y, began, moves, atX: x, atY: y, strayed: false });
    this.#show();
  }

  #move(event: PointerEvent): void {
    const finger = this.#fingers.get(event.pointerId);
    if (finger === undefined) return;
    if (!finger.moves) {
      const rate = this.settings.sensitivity * FINGER;
      this.#yaw += (event.clientX - finger.atX) * rate;
      this.#pitch -= (event.clientY - finger.atY) * rate * (this.settings.invertLook ? -1 : 1);
    }
    finger.atX = event.clientX;
    finger.atY = event.clientY;
    if (Math.hypot(finger.atX - finger.x, finger.atY - finger.y) > TAP_SLACK) finger.strayed = true;
    this.#show();
  }

  #lift(event: PointerEvent, ended: boolean): void {
    const finger = this.#fingers.get(event.pointerId);
    if (!this.#fingers.delete(event.pointerId)) return;
    if (ended && finger !== undefined && !finger.strayed && event.timeStamp - finger.began < TAP_MS)
      this.onPick(finger.x, finger.y);
    this.#show();
  }

  #show(): void {
    const finger = this.#mover();
    this.stick.hidden = finger === undefined;
    if (finger === undefined) return;
    const [x, y] = [finger.atX - finger.x, finger.atY - finger.y];
    const reach = Math.max(1, Math.hypot(x, y) / REACH);
    this.stick.style.transform = `translate(${finger.x}px, ${finger.y}px)`;
    (this.stick.firstElementChild as HTMLElement).style.transform = `translate(${x / reach}px, ${y / reach}px)`;
  }
}
