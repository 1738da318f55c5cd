// Asks for the server's token.
import type { TokenStore } from '../connection/token';
import { find, say } from './dom';

export class TokenDialog {
  readonly #dialog = find<HTMLDialogElement>('token');
  readonly #text = find<HTMLInputElement>('token-text');

  constructor(tokens: TokenStore, onToken: () => void) {
    find('token-form').addEventListener('submit', () => {
      tokens.set(this.#text.value.trim(), find<HTMLInputElement>('token-keep').checked);
      this.#text.value = '';
      onToken();
    });
    find('token-cancel').addEventListener('click', () => this.#dialog.close());
  }

  ask(why: string): void {
    say(find('token-why'), why);
    if (!this.#dialog.open) this.#dialog.showModal();
    this.#text.focus();
  }
}
