// Shows failures in view, with possible actions.
import type { Trouble } from '../connection/session';
import { find, make, say } from './dom';

export interface Answers {
  retry: () => void;
  again: () => void;
  reload: () => void;
  byHttp: () => void;
  askToken: (why: string) => void;
  toSpawn: () => void;
  openDefault: () => void;
}

export class Notices {
  readonly #box = find('notice');
  readonly #text = find('notice-text');
  #retryAt: number | null = null;
  #away = '';

  constructor(private readonly answers: Answers) {}

  trouble(trouble: Trouble | null): void {
    this.#retryAt = null;
    if (trouble === null) {
      if (!['world', 'not-kept'].includes(this.#box.dataset.kind ?? '')) this.hide();
      return;
    }
    switch (trouble.kind) {
      case 'away':
        this.#away = trouble.text;
        this.#retryAt = trouble.retryAt;
        this.#show('away', 'The server is away', '', [['Try now', this.answers.retry]]);
        this.tick(performance.now());
        break;
      case 'token':
        this.#show('token', 'The server asks for a token', trouble.text, [
          ['Give a token', () => this.answers.askToken(trouble.text)],
        ]);
        this.answers.askToken(trouble.text);
        break;
      case 'refused':
        this.#show('refused', 'The server refuses', trouble.text, [['Try again', this.answers.again]]);
        break;
      case 'no-world':
        this.#show('no-world', 'This link opens no world', trouble.text, [['Open the default world', this.answers.openDefault]]);
        break;
      case 'no-socket':
        this.#show('no-socket', 'The land does not come', trouble.text, [
          ['Take it by HTTP', this.answers.byHttp],
          ['Try again', this.answers.reload],
        ]);
        break;
      case 'no-webgl':
        this.#show('no-webgl', 'This browser shows no 3D here', `${sentence(trouble.text)} The map works without.`, [
          ['Open the map', () => location.assign('map.html' + location.hash)],
          ['Try again', this.answers.reload],
        ]);
        break;
      case 'graphics-lost':
        this.#show('graphics-lost', 'The system took the graphics away', 'The picture comes back in a moment.', [
          ['Now', this.answers.reload],
        ]);
    }
  }

  worldChanged(): void {
    this.#show('world', 'This is another world now', 'The server has a new one. You stand at the same coordinate in it.', [
      ['Go to its spawn', () => (this.answers.toSpawn(), this.hide())],
      ['Stay', () => this.hide()],
    ]);
  }

  notKept(why: string): void {
    this.#show('not-kept', 'This browser keeps no edits here', why, [['Play on', () => this.hide()]]);
  }

  hide(): void {
    this.#box.hidden = true;
    delete this.#box.dataset.kind;
  }

  tick(now: number): void {
    if (this.#box.dataset.kind !== 'away') return;
    const seconds = this.#retryAt === null ? null : Math.max(0, Math.ceil((this.#retryAt - now) / 1000));
    const when = seconds === null || seconds === 0 ? 'Trying again.' : `Trying again in ${seconds} s.`;
    const reason = this.#away === '' ? '' : sentence(this.#away) + ' ';
    say(this.#text, reason + when);
  }

  #show(kind: string, title: string, text: string, actions: [string, () => void][]): void {
    this.#box.dataset.kind = kind;
    say(find('notice-title'), title);
    say(this.#text, text === '' ? '' : sentence(text));
    find('notice-actions').replaceChildren(
      ...actions.map(([label, action]) => {
        const button = make('button', label);
        button.type = 'button';
        button.addEventListener('click', action);
        return button;
      }),
    );
    this.#box.hidden = false;
  }
}

const sentence = (text: string) => text.charAt(0).toUpperCase() + text.slice(1) + (/[.!?]$/.test(text) ? '' : '.');
