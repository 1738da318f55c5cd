// The world made in this page, where no server is: answers what a server would.
import type { Client, TalusError } from 'talus';
import { IndexedDbEdits, source, workersFor, World, WorldError } from 'talus/local';
import { Server, type Obstacle, type ServerWorld } from '../connection/server';
import { bestHeading, OUTLOOK } from '../place/outlook';
import { DEFAULT_WORLD, modelsOf, shippedWorld, WORLD_NAMES } from './shipped';
import { LinkError, unpacked } from './world_link';

const TILE_PIXELS = 256;

export class Here extends Server {
  override readonly source = () => this.#source();
  /** Called when edits are not kept, with the reason. */
  onNotKept: (why: string) => void = () => {};
  #opened: World | null = null;
  #opening: Promise<World> | null = null;

  readonly #link: string;

  /** `link`: the name of a shipped world, or a packed world file; null: the default world. */
  constructor(page: string, link: string | null) {
    super(page, () => null);
    this.#link = link ?? DEFAULT_WORLD;
  }

  readonly names = WORLD_NAMES;
  /** The shipped world's name; null: it is of a link. */
  get name(): string | null {
    return WORLD_NAMES.includes(this.#link) ? this.#link : null;
  }

  override async world(): Promise<ServerWorld> {
    const world = await this.#open();
    const { x, y, z } = await world.spawn();
    return { server: 'this page', fingerprint: world.fingerprint, spawn: [x, y, z] };
  }

  override async ground(x: number, z: number): Promise<number> {
    const world = await this.#open();
    const [height] = await world.heights({ x: Math.floor(x), z: Math.floor(z), width: 1, depth: 1 });
    return (height! + 127) >> 8;
  }

  /** By a coarse level: a hundredth of the work, and as good a view. */
  override async outlook(x: number, z: number): Promise<number> {
    const world = await this.#open();
    const { step, reach, lod } = OUTLOOK;
    const size = 2 ** lod;
    const at = (middle: number, i: number) => Math.floor((Math.floor(middle) + (i - reach) * step) / size);
    const area = { x: at(x, 0), z: at(z, 0), width: at(x, 2 * reach) - at(x, 0) + 1, depth: at(z, 2 * reach) - at(z, 0) + 1 };
    const heights = await world.heights({ lod, ...area });
    const samples: number[] = [];
    for (let row = 0; row <= 2 * reach; ++row)
      for (let column = 0; column <= 2 * reach; ++column)
        samples.push(heights[(at(z, row) - area.z) * area.width + at(x, column) - area.x]! * size);
    return bestHeading(samples);
  }

  override async obstacle(): Promise<Obstacle | null> {
    try {
      await this.#open();
      return null;
    } catch (error) {
      return { kind: 'no-world', text: reasonOf(error as Error) };
    }
  }

  /** Answers the map's requests. */
  override async fetch(path: string, { signal }: RequestInit = {}): Promise<Response> {
    const world = await this.#open();
    const tile = /\/map\/(\d+)\/(-?\d+)\/(-?\d+)\.png$/.exec(path);
    if (tile !== null) {
      const [zoom, x, z] = tile.slice(1).map(Number) as [number, number, number];
      return new Response(await picture(await world.map({ zoom, x, z }, signal ?? undefined)));
    }
    const column = /^v1\/heights\?columns=(-?\d+),(-?\d+)/.exec(path);
    if (column === null) return new Response(null, { status: 404 });
    const heights = await world.heights({ x: Number(column[1]), z: Number(column[2]), width: 1, depth: 1 });
    return Response.json({ heights: [...heights] });
  }

  #source(): Client {
    const world = this.#opened!;
    const client = source(world, { store: IndexedDbEdits.open(world), manualCredit: true });
    client.on('error', (error: TalusError) => error.kind === 'not_kept' && this.onNotKept(error.message));
    return client;
  }

  #open(): Promise<World> {
    this.#opening ??= this.#start();
    this.#opening.catch(() => (this.#opening = null)); // another attempt may succeed
    return this.#opening;
  }

  async #start(): Promise<World> {
    const toml = this.name === null ? await unpacked(this.#link) : await shippedWorld(this.name);
    const world = await World.open(toml, {
      files: await modelsOf(toml),
      workers: workersFor(navigator.hardwareConcurrency ?? 2),
    });
    this.#opened = world;
    return world;
  }
}

function reasonOf(error: Error): string {
  if (error instanceof LinkError) return error.message;
  if (!(error instanceof WorldError) || error.kind !== 'spec') return `the world cannot be made here: ${error.message}`;
  const { line, column, message } = error;
  const place = line === 0 ? '' : `, line ${line}${column === 0 ? '' : `, column ${column}`}`;
  return `its world file is wrong${place}: ${message.replace(/^[\d:]+ /, '')}`;
}

/** PNG of red, green and blue. */
async function picture(rgb: Uint8Array): Promise<Blob> {
  const pixels = new ImageData(TILE_PIXELS, TILE_PIXELS);
  for (let i = 0, at = 0; i < rgb.length; i += 3, at += 4) {
    pixels.data[at] = rgb[i]!;
    pixels.data[at + 1] = rgb[i + 1]!;
    pixels.data[at + 2] = rgb[i + 2]!;
    pixels.data[at + 3] = 255;
  }
  const canvas = new OffscreenCanvas(TILE_PIXELS, TILE_PIXELS);
  canvas.getContext('2d')!.putImageData(pixels, 0, 0);
  return canvas.convertToBlob();
}
