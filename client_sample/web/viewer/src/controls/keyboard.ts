// Held keys move and turn; pressed keys call commands. The keyboard alone suffices. Keys are identified by position
// (event.code), so that WASD is in the same place on any layout.
import type { Device, Intent } from './intent';

type Axis = 'forward' | 'right' | 'up' | 'turn' | 'tilt';

const HELD: Record<string, readonly [Axis, 1 | -1]> = {
  KeyW: ['forward', 1],
  KeyS: ['forward', -1],
  KeyD: ['right', 1],
  KeyA: ['right', -1],
  Space: ['up', 1],
  KeyC: ['up', -1],
  ArrowUp: ['forward', 1],
  ArrowDown: ['forward', -1],
  ArrowRight: ['turn', 1],
  ArrowLeft: ['turn', -1],
  KeyE: ['turn', 1],
  KeyQ: ['turn', -1],
  PageUp: ['tilt', 1],
  PageDown: ['tilt', -1],
};

/** True if a key belongs to the focused element (a field, a slider, a button) rather than to the world. */
export function belongsToWidget(target: EventTarget | null, code: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)) return code !== 'Escape';
  const presses = /^(BUTTON|A|SUMMARY)$/.test(target.tagName);
  return presses && (code === 'Space' || code === 'Enter');
}

export class Keyboard implements Device {
  readonly #held = new Set<string>();

  constructor(commands: Readonly<Record<string, () => void>>, isShut: () => boolean) {
    addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || belongsToWidget(event.target, event.code)) return;
      if (isShut()) return;
      if (event.code in HELD) {
        this.#held.add(event.code);
        // Space and arrows would scroll, or press a button.
        event.preventDefault();
      } else if (event.key === 'Shift') {
        this.#held.add('Shift');
      } else if (!event.repeat) {
        const command = commands[event.code] ?? commands[event.key];
        if (command === undefined) return;
        event.preventDefault();
        command();
      }
    });
    addEventListener('keyup', (event) => this.#held.delete(event.key === 'Shift' ? 'Shift' : event.code));
  }

  read(intent: Intent): void {
    for (const code of this.#held) {
      const held = HELD[code];
      if (held !== undefined) intent[held[0]] += held[1];
    }
    for (const axis of ['forward', 'right', 'up', 'turn', 'tilt'] as const)
      intent[axis] = Math.max(-1, Math.min(1, intent[axis]));
    if (this.#held.has('Shift')) intent.fast = true;
  }

  release(): void {
    this.#held.clear();
  }
}
