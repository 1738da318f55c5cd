// The bar of tools and materials, the message below the crosshair, and the buttons that open the bar.
import { find, make, say } from '../ui/dom';
import type { Builder } from './builder';
import type { Tool } from './target';

const SAID_MS = 4_000;
const KEYS = 9;

export class EditBar {
  readonly #bar = find('edit-bar');
  readonly #said = find('edit-said');
  readonly #palette = find('edit-palette');
  readonly #undo = find<HTMLButtonElement>('edit-undo');
  readonly #waiting = find('edit-waiting');
  readonly #tools = [...document.querySelectorAll<HTMLButtonElement>('[data-edit-tool]')];
  readonly #openers = [find<HTMLButtonElement>('edit-open'), find<HTMLButtonElement>('thumb-edit')];
  #builder!: Builder;
  #shown: unknown = null;
  #hides: ReturnType<typeof setTimeout> | undefined;

  /** `giveBackFocus`: returns the focus, so that keys work in the world again. */
  constructor(private readonly giveBackFocus: () => void) {}

  attach(builder: Builder): void {
    this.#builder = builder;
    const press = (button: HTMLElement, action: () => void) =>
      button.addEventListener('click', () => {
        action();
        this.giveBackFocus();
      });
    for (const button of this.#openers) press(button, () => void builder.toggle());
    press(find('edit-close'), () => void builder.toggle());
    for (const button of this.#tools) press(button, () => builder.choose(button.dataset.editTool as Tool));
    press(this.#undo, () => builder.undo());
    press(this.#palette, () => {});
    this.#palette.addEventListener('click', ({ target }) => {
      const swatch = (target as Element).closest<HTMLElement>('[data-material]');
      if (swatch !== null) builder.chooseMaterial(Number(swatch.dataset.material));
    });
    this.show();
  }

  show(): void {
    const { isOn, tool, material, palette, whyNot, canUndo } = this.#builder;
    this.#bar.hidden = !isOn;
    document.body.classList.toggle('editing', isOn);
    for (const button of this.#openers) {
      button.setAttribute('aria-pressed', String(isOn));
      button.setAttribute('aria-disabled', String(whyNot !== null));
      button.title = whyNot ?? '';
    }
    for (const button of this.#tools) button.setAttribute('aria-pressed', String(button.dataset.editTool === tool));
    this.#undo.disabled = !canUndo;
    if (this.#shown !== palette) {
      this.#shown = palette;
      this.#palette.replaceChildren(
        ...palette.map(({ id, name, colour }, i) => {
          const swatch = make('button');
          swatch.type = 'button';
          swatch.dataset.material = String(id);
          swatch.setAttribute('aria-label', i < KEYS ? `${name}, key ${i + 1}` : name);
          swatch.title = name;
          const patch = make('i');
          if (id !== 0) patch.style.background = '#' + colour.toString(16).padStart(6, '0');
          else patch.className = 'air';
          swatch.append(patch);
          if (i < KEYS) swatch.append(make('span', String(i + 1)));
          return swatch;
        }),
      );
    }
    for (const swatch of this.#palette.children) {
      const isChosen = (swatch as HTMLElement).dataset.material === String(material);
      swatch.setAttribute('aria-pressed', String(isChosen));
      if (isChosen && isOn) swatch.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    }
    say(find('edit-material'), palette.find(({ id }) => id === material)?.name ?? '');
  }

  /** Shows a message near the crosshair for a while. */
  say(text: string, isBad: boolean): void {
    say(this.#said, text);
    this.#said.classList.toggle('bad', isBad);
    this.#said.hidden = text === '';
    clearTimeout(this.#hides);
    this.#hides = setTimeout(() => (this.#said.hidden = true), SAID_MS);
  }

  /** Shows the number of unanswered edits while the server is away. */
  waits(count: number): void {
    this.#waiting.hidden = count === 0;
    if (count > 0) say(this.#waiting, `${count} ${count === 1 ? 'edit waits' : 'edits wait'} for the server`);
  }
}
