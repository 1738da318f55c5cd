// Chunks of a published world that are made here, while the server sends edits: PROTOCOL.md, "View". What makes them is
// loaded only where it is used.
import type { Tracker } from '../client/tracker.js';
import { TalusError } from '../errors.js';
import type { LocalChunks } from '../local/local_chunks.js';
import type { Chunk, ChunkKey, ConnectOptions, World } from '../types.js';
import { parsedUrl } from '../url.js';
import type { ServerMessage } from '../wire/messages.js';

export type EditBroadcast = Extract<ServerMessage, { kind: 'edit_broadcast' }>;

export interface BaseHost {
  /** Null: not connected. */
  world(): World | null;
  /** The View was reported complete. */
  isViewWhole(): boolean;
  deliver(chunk: Chunk): void;
  refetch(key: ChunkKey): void;
  /** Resolves with null if the server's chunk has the hash `known`, else with the chunk. */
  compare(key: ChunkKey, known: string): Promise<Chunk | null>;
  /** Sends the View again. */
  askAgain(): void;
  /** The server sent all edits of the View, and all of it is made. */
  whole(): void;
  failed(error: TalusError): void;
}

/** With fewer cores, streaming costs less than it saves. */
const LEAST_CORES = 2;

export class BaseMaking {
  private local: LocalChunks | null = null;
  private opening = new AbortController();
  /** Of the world that is being opened, or was. */
  private fingerprint = '';
  private hasEnded = false;

  constructor(
    private readonly options: ConnectOptions,
    private readonly tracker: Tracker,
    private readonly host: BaseHost,
  ) {}

  /** Views say so to the server. */
  get isOn(): boolean {
    return this.local?.isOn ?? false;
  }

  joined(world: World, sameWorld: boolean): void {
    if (!sameWorld) {
      this.stop();
      this.fingerprint = '';
    }
    if (this.local !== null) {
      if (!world.limits.viewBase) this.stop();
      else this.local.joined();
    } else if (this.options.generate === 'always') {
      this.begin(world);
    }
  }

  viewIsWhole(): void {
    const world = this.host.world();
    const cores = (globalThis as { navigator?: { hardwareConcurrency?: number } }).navigator?.hardwareConcurrency ?? LEAST_CORES;
    if (this.options.generate === 'auto' && world !== null && cores >= LEAST_CORES) this.begin(world);
  }

  disconnected(): void {
    this.local?.disconnected();
  }

  viewApplied(): void {
    this.local?.viewApplied();
  }

  /** True if the edit was taken here. */
  edited(message: EditBroadcast): boolean {
    return this.local?.edited(message) ?? false;
  }

  came(chunk: Chunk): void {
    this.local?.came(chunk);
  }

  /** False if nothing is made here; else BaseHost.whole() follows. */
  serverIsDone(): boolean {
    if (!this.isOn) return false;
    this.local!.serverIsDone();
    return true;
  }

  end(): void {
    this.hasEnded = true;
    this.stop();
  }

  private begin(world: World): void {
    if (!world.limits.viewBase || world.worldFile === '' || this.fingerprint === world.fingerprint) return;
    const base = baseOf(this.options.url);
    if (base === null) return;
    const { fingerprint } = world;
    this.fingerprint = fingerprint;
    const isCurrent = () => !this.hasEnded && this.fingerprint === fingerprint;
    const { signal } = (this.opening = new AbortController());
    let isOver = false;
    const fail = (why: Error) => {
      if (isOver || !isCurrent()) return; // it is said once
      isOver = true;
      this.fail(why);
    };
    import('../local/local_chunks.js')
      .then(({ LocalChunks }) => LocalChunks.open(this.options, base, world, this.tracker, { ...this.host, failed: fail }, signal))
      .then(
        (local) => {
          if (!isCurrent()) return local.end();
          this.local = local;
          local.begin(this.host.isViewWhole());
          if (!this.host.isViewWhole()) this.host.askAgain();
        },
        fail,
      );
  }

  private fail(why: Error): void {
    const wasOn = this.isOn;
    this.stop();
    this.host.failed(new TalusError('cannot_generate', `chunks are not made here: ${why.message}`));
    if (wasOn) this.host.askAgain();
  }

  private stop(): void {
    this.opening.abort();
    this.local?.end();
    this.local = null;
  }
}

/** Where HTTP is, if the stream is a WebSocket. */
function baseOf(urls: ConnectOptions['url']): string | null {
  const url = parsedUrl(typeof urls === 'string' ? urls : urls[0]!);
  if (url.protocol !== 'ws:' && url.protocol !== 'wss:') return null;
  url.protocol = url.protocol === 'wss:' ? 'https:' : 'http:';
  url.pathname = url.pathname.replace(/\/v1\/stream$/, '').replace(/\/$/, '');
  return url.href.replace(/\/$/, '');
}
