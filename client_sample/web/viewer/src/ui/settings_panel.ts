// The settings form.
import type { Reach } from '../place/device';
import { defaults, mend, type Settings } from '../place/settings';
import { find, say } from './dom';

const figures = {
  radius: ({ radius }: Reach) => `${radius} chunks`,
  horizon: ({ horizon }: Reach) => (horizon === 0 ? 'none' : `${(horizon / 1000).toFixed(1)} km`),
  sensitivity: ({ sensitivity }: Settings) => `${Math.round(sensitivity * 100)}`,
};

export class SettingsPanel {
  readonly #form = find<HTMLFormElement>('settings');

  constructor(
    private readonly settings: Settings,
    onChange: (changed: Partial<Settings>) => void,
    isPhone: boolean,
    cap: Reach | null,
  ) {
    if (cap !== null) this.#tellCap(cap);
    this.#form.addEventListener('submit', (event) => event.preventDefault());
    this.#form.addEventListener('input', (event) => {
      const field = event.target as HTMLInputElement | HTMLSelectElement;
      const text = field instanceof HTMLInputElement && field.type === 'checkbox' ? String(field.checked) : field.value;
      const value = text === 'null' ? null : text === 'true' ? true : text === 'false' ? false : Number.isNaN(Number(text)) ? text : Number(text);
      const mended = mend(settings, { [field.name]: value });
      const key = field.name as keyof Settings;
      if (mended[key] !== settings[key]) onChange({ [key]: mended[key] });
      this.show();
    });
    find('settings-reset').addEventListener('click', () => {
      onChange(defaults(isPhone));
      this.show();
    });
    this.show();
  }

  #tellCap(cap: Reach): void {
    for (const key of ['radius', 'horizon'] as const) (this.#form.elements.namedItem(key) as HTMLInputElement).max = String(cap[key]);
    const said = find('settings-cap');
    said.hidden = false;
    const [radius, horizon] = [figures.radius(cap), figures.horizon(cap)];
    say(said, `On this device at most ${radius} of full detail and a horizon of ${horizon}: more would take memory that it may not have.`);
  }

  show(): void {
    for (const [key, value] of Object.entries(this.settings)) {
      const field = this.#form.elements.namedItem(key);
      if (field instanceof HTMLInputElement && field.type === 'checkbox') field.checked = value as boolean;
      else if (field instanceof HTMLInputElement) field.value = String(value);
      else if (field instanceof HTMLSelectElement) {
        // A link may set a value that is not among the choices.
        if (![...field.options].some((option) => option.value === String(value))) field.add(new Option(String(value)));
        field.value = String(value);
      }
      if (key in figures) say(find(`${key}-now`), figures[key as keyof typeof figures](this.settings));
    }
  }
}
