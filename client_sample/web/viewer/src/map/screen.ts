// The map with its surroundings: coordinates under the pointer, buttons, errors. Fills its element.
import type { Server } from '../connection/server';
import { make, say } from '../ui/dom';
import { MapView, type Marker } from './map_view';
import type { Camera } from './projection';
import { TileStore, type Weather } from './tile_store';

export interface MapWorld {
  readonly fingerprint: string;
  readonly spawn: { readonly x: number; readonly z: number };
}

export interface MapPlayer {
  readonly x: number;
  readonly z: number;
  readonly yaw: number;
}

export interface MapHandlers {
  go: (x: number, z: number) => void;
  close: () => void;
  /** 401: a token is missing or wrong. */
  token?: () => void;
}

const LOOK_DELAY_MS = 180;

const WORDS: Record<Weather, string> = {
  fine: '',
  away: 'The server is away. Trying again.',
  token: 'The server asks for a token.',
  'no-map': 'This server draws no map. You can still go anywhere: the coordinates are right.',
};

function button(label: string, text: string, onClick: () => void): HTMLButtonElement {
  const made = make('button', text);
  made.type = 'button';
  made.setAttribute('aria-label', label);
  made.title = label;
  made.addEventListener('click', onClick);
  return made;
}

export class MapScreen {
  readonly view: MapView;
  #tiles: TileStore | null = null;
  #player: MapPlayer | null = null;
  #world: MapWorld | null = null;
  readonly #at = make('p', ' ');
  readonly #weather = make('p');
  readonly #canvas = make('canvas');
  #lookTimer: ReturnType<typeof setTimeout> | undefined;
  #asked = 0;

  constructor(
    host: HTMLElement,
    private readonly server: Server,
    camera: Camera,
    private readonly handlers: MapHandlers,
  ) {
    this.#canvas.tabIndex = 0;
    this.#canvas.setAttribute('role', 'application');
    this.#canvas.setAttribute('aria-label', 'Map. Arrow keys move it, plus and minus zoom, Enter goes to its middle.');
    this.#at.className = 'map-at pill';
    this.#at.setAttribute('aria-live', 'polite');
    this.#weather.className = 'map-weather card';
    this.#weather.setAttribute('role', 'status');
    this.#weather.hidden = true;
    const tools = make('div');
    tools.className = 'map-tools';
    tools.append(
      button('Zoom in', '+', () => this.view.zoomBy(1)),
      button('Zoom out', '−', () => this.view.zoomBy(-1)),
      button('Where you are', 'Me', () => this.#player !== null && this.centre(this.#player)),
      button('The spawn', 'Spawn', () => this.#world !== null && this.centre(this.#world.spawn)),
    );
    const close = button('Close the map', '', handlers.close);
    close.className = 'map-close';
    close.innerHTML = '<svg aria-hidden="true"><use href="#i-close"/></svg>';
    const head = make('header');
    head.className = 'map-head';
    const title = make('p', 'Map');
    title.className = 'brand pill';
    head.append(title, this.#at, close);
    host.replaceChildren(this.#canvas, head, tools, this.#weather);
    this.view = new MapView(this.#canvas, () => this.#tiles, camera, {
      hover: (x, z) => this.#hover(x, z),
      go: (x, z) => handlers.go(Math.floor(x) + 0.5, Math.floor(z) + 0.5),
      moved: () => undefined,
    });
    host.addEventListener('keydown', this.#onKey);
    this.#hover(camera.x, camera.z);
  }

  /** Tiles on the screen that are still missing; null: the world is not known yet. */
  get missing(): number | null {
    return this.#tiles?.missing ?? null;
  }

  focus(): void {
    this.#canvas.focus({ preventScroll: true });
  }

  setWorld(world: MapWorld): void {
    if (this.#world?.fingerprint !== world.fingerprint) {
      this.#tiles?.dispose();
      this.#tiles = new TileStore(this.server, world.fingerprint, () => this.#tilesChanged());
    }
    this.#world = world;
    this.#mark();
  }

  setPlayer(player: MapPlayer): void {
    this.#player = player;
    this.#mark();
  }

  say(text: string): void {
    say(this.#weather, text);
    this.#weather.hidden = text === '';
  }

  dispose(): void {
    clearTimeout(this.#lookTimer);
    this.#tiles?.dispose();
    this.view.dispose();
    this.#canvas.parentElement?.removeEventListener('keydown', this.#onKey);
    this.#canvas.parentElement?.replaceChildren();
  }

  /** Centres the map there, and describes the place. */
  centre({ x, z }: { x: number; z: number }): void {
    this.view.look({ ...this.view.camera, x, z });
    this.#hover(x, z);
  }

  readonly #onKey = (event: KeyboardEvent) => {
    if (event.key === 'Escape' || (event.code === 'KeyM' && !event.ctrlKey && !event.metaKey)) {
      event.preventDefault();
      event.stopPropagation();
      this.handlers.close();
    }
  };

  #mark(): void {
    const markers: Marker[] = [];
    if (this.#world !== null) markers.push({ x: this.#world.spawn.x, z: this.#world.spawn.z, yaw: null, name: 'Spawn' });
    if (this.#player !== null) markers.push({ ...this.#player, name: 'You' });
    this.view.mark(markers);
  }

  #tilesChanged(): void {
    const weather = this.#tiles?.weather ?? 'fine';
    this.say(WORDS[weather]);
    if (weather === 'token') this.handlers.token?.();
    this.view.redraw();
  }

  #hover(x: number, z: number): void {
    const [bx, bz] = [Math.floor(x), Math.floor(z)];
    say(this.#at, `${bx}, ${bz}`);
    clearTimeout(this.#lookTimer);
    this.#lookTimer = setTimeout(() => void this.#tellLook(bx, bz), LOOK_DELAY_MS);
  }

  /** Describes a place: requested when the pointer rests. */
  async #tellLook(x: number, z: number): Promise<void> {
    const asked = ++this.#asked;
    try {
      const answer = await this.server.fetch(`v1/heights?columns=${x},${z}&looks=1`);
      if (!answer.ok || asked !== this.#asked) return;
      const { heights, looks } = (await answer.json()) as { heights: number[]; looks?: string[] };
      if (asked !== this.#asked || !this.#at.textContent!.startsWith(`${x}, ${z}`)) return;
      const height = `ground at ${(heights[0]! + 127) >> 8}`;
      say(this.#at, [`${x}, ${z}`, height, looks?.[0] ?? ''].filter((part) => part !== '').join(' · '));
    } catch {
      // Only the coordinates are shown.
    }
  }
}
