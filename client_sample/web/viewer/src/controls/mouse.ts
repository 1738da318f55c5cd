// Looking by mouse: a click locks the pointer, Esc frees it; without the lock, dragging looks too. With editing tools,
// the click that locks has no other effect, so that returning to the page digs nothing.
import type { Device, Intent } from './intent';
import type { Settings } from '../place/settings';

/** Movement in pixels up to which a press is a click. */
const CLICK_SLACK = 4;

export class Mouse implements Device {
  #yaw = 0;
  #pitch = 0;
  #pressed: { x: number; y: number; moved: boolean } | null = null;

  constructor(
    private readonly canvas: HTMLElement,
    private readonly settings: Settings,
    /** `other`: by the right button. */
    onPick: (x: number, y: number, other: boolean) => void,
    onWheel: (notches: number, shift: boolean) => void,
    hasTools: () => boolean,
  ) {
    canvas.addEventListener('pointerdown', (event) => {
      if (event.pointerType !== 'mouse') return;
      const other = event.button === 2 && hasTools();
      if (event.button !== 0 && !other) return;
      if (this.isLocked) onPick(canvas.clientWidth / 2, canvas.clientHeight / 2, other);
      else if (other) onPick(event.clientX, event.clientY, true);
      else this.#pressed = { x: event.clientX, y: event.clientY, moved: false };
    });
    addEventListener('pointermove', (event) => {
      if (event.pointerType !== 'mouse') return;
      if (!this.isLocked && this.#pressed === null) return;
      if (this.#pressed !== null) {
        const away = Math.hypot(event.clientX - this.#pressed.x, event.clientY - this.#pressed.y);
        if (away > CLICK_SLACK) this.#pressed.moved = true;
        if (!this.#pressed.moved) return;
      }
      this.#turn(event.movementX, event.movementY);
    });
    addEventListener('pointerup', (event) => {
      if (event.pointerType !== 'mouse' || this.#pressed === null) return;
      const wasClick = !this.#pressed.moved;
      this.#pressed = null;
      if (!wasClick) return;
      const pick = () => onPick(event.clientX, event.clientY, false);
      if (hasTools()) return this.#lock(pick);
      pick();
      this.#lock();
    });
    canvas.addEventListener('contextmenu', (event) => {
      if (hasTools()) event.preventDefault();
    });
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        onWheel(-Math.sign(event.deltaY || event.deltaX), event.shiftKey);
      },
      { passive: false },
    );
  }

  get isLocked(): boolean {
    return document.pointerLockElement === this.canvas;
  }

  read(intent: Intent): void {
    intent.yaw += this.#yaw;
    intent.pitch += this.#pitch;
    this.#yaw = this.#pitch = 0;
  }

  release(): void {
    this.#pressed = null;
    this.#yaw = this.#pitch = 0;
  }

  #turn(x: number, y: number): void {
    const rate = this.settings.sensitivity;
    this.#yaw += x * rate;
    this.#pitch -= y * rate * (this.settings.invertLook ? -1 : 1);
  }

  #lock(otherwise = () => {}): void {
    // Fails in an iframe, or too soon after Esc: then dragging still works, and clicks apply at the pointer.
    const locking = this.canvas.requestPointerLock() as unknown as Promise<void> | undefined;
    locking?.catch(otherwise);
  }
}
