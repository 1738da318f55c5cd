// Panels next to the view: one at a time, opened by a button or a key, closed by Esc.
import { find } from './dom';

export class Panels {
  #open: string | null = null;
  readonly #buttons = new Map<string, HTMLButtonElement>();
  /** Called when a panel is opened. */
  readonly onOpen = new Map<string, () => void>();

  constructor(private readonly giveBackFocus: () => void) {
    for (const button of document.querySelectorAll<HTMLButtonElement>('[data-panel]')) {
      const name = button.dataset.panel!;
      this.#buttons.set(name, button);
      button.setAttribute('aria-expanded', 'false');
      button.setAttribute('aria-controls', `panel-${name}`);
      button.addEventListener('click', () => this.toggle(name));
    }
  }

  isOpen(name: string): boolean {
    return this.#open === name;
  }

  get isAnyOpen(): boolean {
    return this.#open !== null;
  }

  /** `focus`: moves the focus into the panel for keyboard users; with the mouse it stays in the world. */
  toggle(name: string, focus = true): void {
    const opens = this.#open !== name;
    this.close(false);
    if (!opens) return this.giveBackFocus();
    this.#open = name;
    const panel = find(`panel-${name}`);
    panel.hidden = false;
    this.#buttons.get(name)!.setAttribute('aria-expanded', 'true');
    document.exitPointerLock?.();
    this.onOpen.get(name)?.();
    if (focus) panel.querySelector<HTMLElement>('input, button, select')?.focus({ preventScroll: true });
  }

  /** False if none was open. */
  close(giveBack = true): boolean {
    if (this.#open === null) return false;
    find(`panel-${this.#open}`).hidden = true;
    this.#buttons.get(this.#open)!.setAttribute('aria-expanded', 'false');
    this.#open = null;
    if (giveBack) this.giveBackFocus();
    return true;
  }
}
