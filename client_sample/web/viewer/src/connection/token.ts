// The server's token: for this tab, or stored on this device if the player chooses.

const KEY = 'talus.token';

export class TokenStore {
  #token: string | null = null;

  constructor() {
    for (const storage of [() => sessionStorage, () => localStorage]) {
      try {
        this.#token ??= storage().getItem(KEY);
      } catch {
        // Without storage, a token lasts until the page is left.
      }
    }
  }

  get token(): string | null {
    return this.#token;
  }

  set(token: string | null, keep: boolean): void {
    this.#token = token;
    const put = (storage: () => Storage, value: string | null) => {
      try {
        if (value === null) storage().removeItem(KEY);
        else storage().setItem(KEY, value);
      } catch {
        // As above.
      }
    };
    put(() => sessionStorage, token);
    put(() => localStorage, keep ? token : null);
  }
}
