// Tiles of the map: requested a few at a time, cached, and requested again when the server says.
import type { Server } from '../connection/server';
import { nameOf, type TileKey } from './projection';

const AT_ONCE = 4;
/** Exceeded only while more are wanted. */
const KEPT = 200;
const RETRY_MS = 2000;

type Tile =
  | { state: 'here'; picture: ImageBitmap }
  | { state: 'coming'; abort: AbortController }
  | { state: 'later'; at: number }
  | { state: 'none' };

export type Weather = 'fine' | 'away' | 'token' | 'no-map';

export class TileStore {
  readonly #tiles = new Map<string, Tile>();
  #wanted: TileKey[] = [];
  #coming = 0;
  #wake: ReturnType<typeof setTimeout> | undefined;
  weather: Weather = 'fine';

  constructor(
    private readonly server: Server,
    private readonly fingerprint: string,
    private readonly changed: () => void,
  ) {}

  get(tile: TileKey): ImageBitmap | null {
    const name = nameOf(tile);
    const found = this.#tiles.get(name);
    if (found?.state !== 'here') return null;
    // The most recently used come last in the map.
    this.#tiles.delete(name);
    this.#tiles.set(name, found);
    return found.picture;
  }

  /** Number of missing tiles among those wanted last. */
  get missing(): number {
    return this.#wanted.filter((tile) => !['here', 'none'].includes(this.#tiles.get(nameOf(tile))?.state ?? '')).length;
  }

  /** Sets the wanted tiles, most important first; cancels requests of all others. */
  want(tiles: TileKey[]): void {
    this.#wanted = tiles;
    const names = new Set(tiles.map(nameOf));
    for (const [name, tile] of this.#tiles) if (tile.state === 'coming' && !names.has(name)) tile.abort.abort();
    this.#forget();
    this.#next();
  }

  dispose(): void {
    clearTimeout(this.#wake);
    this.#wanted = [];
    for (const tile of this.#tiles.values()) {
      if (tile.state === 'coming') tile.abort.abort();
      if (tile.state === 'here') tile.picture.close();
    }
    this.#tiles.clear();
  }

  #next(): void {
    const now = performance.now();
    let soonest = Infinity;
    for (const tile of this.#wanted) {
      if (this.#coming >= AT_ONCE) return;
      const known = this.#tiles.get(nameOf(tile));
      if (known === undefined || (known.state === 'later' && known.at <= now)) void this.#ask(tile);
      else if (known.state === 'later') soonest = Math.min(soonest, known.at);
    }
    clearTimeout(this.#wake);
    if (soonest < Infinity) this.#wake = setTimeout(() => this.#next(), Math.max(50, soonest - now));
  }

  async #ask(tile: TileKey): Promise<void> {
    const name = nameOf(tile);
    const abort = new AbortController();
    this.#tiles.set(name, { state: 'coming', abort });
    ++this.#coming;
    try {
      const answer = await this.server.fetch(`v1/${this.fingerprint}/map/${name}.png`, { signal: abort.signal });
      if (answer.ok) {
        this.#tiles.set(name, { state: 'here', picture: await createImageBitmap(await answer.blob()) });
        this.weather = 'fine';
      } else if (answer.status === 429 || answer.status >= 500) {
        const seconds = Number(answer.headers.get('Retry-After') ?? 1);
        this.#tiles.set(name, { state: 'later', at: performance.now() + 1000 * Math.min(60, Math.max(0.25, Number.isFinite(seconds) ? seconds : 1)) });
      } else {
        this.#tiles.set(name, { state: 'none' });
        this.weather = answer.status === 401 ? 'token' : 'no-map';
      }
    } catch {
      if (abort.signal.aborted) this.#tiles.delete(name);
      else {
        this.#tiles.set(name, { state: 'later', at: performance.now() + RETRY_MS });
        this.weather = 'away';
      }
    }
    --this.#coming;
    this.#forget();
    this.changed();
    this.#next();
  }

  /** Keeps wanted tiles; of the rest, tiles without a picture are removed first. */
  #forget(): void {
    if (this.#tiles.size <= KEPT) return;
    const wanted = new Set(this.#wanted.map(nameOf));
    for (const goes of [['later', 'none'], ['here']]) {
      for (const [name, tile] of this.#tiles) {
        if (this.#tiles.size <= KEPT) return;
        if (wanted.has(name) || !goes.includes(tile.state)) continue;
        if (tile.state === 'here') tile.picture.close();
        this.#tiles.delete(name);
      }
    }
  }
}
