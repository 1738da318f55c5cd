// Common parts of clients over a stream and over HTTP: events, the View, statistics.
import { Emitter } from '../emitter.js';
import { checking, TalusError } from '../errors.js';
import type {
  Chunk,
  ChunkKey,
  Client,
  ClientEvents,
  ConnectOptions,
  Edit,
  EditDone,
  EditLimits,
  Places,
  Stats,
  View,
  World,
} from '../types.js';
import { checkedView, checkLimits, ViewShape } from '../view_shape.js';
import { Backoff } from './backoff.js';
import { Tracker } from './tracker.js';

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/** Minimum interval between Views, as servers do not apply them much more often. */
const VIEW_INTERVAL_MS = 50;

const COUNTS = {
  chunks: 0,
  madeChunks: 0,
  proofs: 0,
  uniformChunks: 0,
  unchangedChunks: 0,
  receivedBytes: 0,
  sentBytes: 0,
  chunkBytes: 0,
  connections: 0,
  requests: 0,
  latencyMs: null,
  firstChunkMs: null,
  viewCompleteMs: null,
} as const;

export abstract class ClientBase implements Client {
  world: World | null = null;
  connected = false;
  readonly stats: Mutable<Stats> = { ...COUNTS };

  protected readonly tracker = new Tracker();
  protected readonly backoff: Backoff;
  protected isClosed = false;
  private readonly events = new Emitter<ClientEvents>();
  private closeError: TalusError | null = null;
  private wanted: View | null = null; // the newest View; the tracker has the last one applied
  private viewTimer: ReturnType<typeof setTimeout> | undefined;
  private retryTimer: ReturnType<typeof setTimeout> | undefined;
  private appliedAt = -Infinity;
  private viewSince = 0;

  protected constructor(protected readonly options: ConnectOptions) {
    this.backoff = new Backoff(options.reconnect);
    globalThis.addEventListener?.('online', this.retryNow);
  }

  on<K extends keyof ClientEvents>(event: K, handler: ClientEvents[K]): this {
    this.events.on(event, handler);
    return this;
  }

  off<K extends keyof ClientEvents>(event: K, handler: ClientEvents[K]): this {
    this.events.off(event, handler);
    return this;
  }

  protected emit<K extends keyof ClientEvents>(event: K, ...args: Parameters<ClientEvents[K]>): void {
    this.events.emit(event, ...args);
  }

  ready(): Promise<World> {
    return new Promise((resolve, reject) => {
      if (this.connected && this.world !== null) {
        resolve(this.world);
        return;
      }
      if (this.isClosed) {
        reject(this.closedError());
        return;
      }
      const done = () => {
        this.off('connected', join).off('closed', end);
      };
      const join = (world: World) => {
        done();
        resolve(world);
      };
      const end = () => {
        done();
        reject(this.closedError());
      };
      this.on('connected', join).on('closed', end);
    });
  }

  protected closedError(): TalusError {
    return this.closeError ?? new TalusError('closed', 'the client is closed');
  }

  setView(view: View | null): void {
    if (this.isClosed) throw this.closedError();
    const checked = view === null ? null : checking('setView', () => checkedView(view));
    if (checked !== null && this.world !== null) {
      checkLimits(checked, new ViewShape(checked, this.world), this.world.limits);
    }
    if (sameView(checked, this.wanted)) return;
    this.wanted = checked;
    this.applyViewSoon();
  }

  private applyViewSoon(): void {
    if (!this.connected || this.viewTimer !== undefined) return;
    const wait = this.appliedAt + VIEW_INTERVAL_MS - performance.now();
    if (wait <= 0) {
      this.applyView();
      return;
    }
    this.viewTimer = setTimeout(() => {
      this.viewTimer = undefined;
      if (this.connected) this.applyView();
    }, wait);
  }

  /** Applies the newest View to the tracker, and sends it to the server. */
  private applyView(): void {
    const view = this.wanted;
    const before = this.tracker.view;
    this.appliedAt = performance.now();
    if (before === null || view === null || !sameChunks(before, view)) {
      this.viewSince = this.appliedAt;
      this.stats.firstChunkMs = this.stats.viewCompleteMs = null;
    }
    for (const key of this.tracker.replace(view, this.world!)) this.emit('chunkLeft', key);
    if (this.connected && this.tracker.view === view) this.viewApplied();
  }

  /** Called when the tracker has a new View. */
  protected abstract viewApplied(): void;

  /** Reports the server's world; the View is kept. */
  protected joined(world: World): void {
    const before = this.world;
    const sameWorld = before !== null && before.fingerprint === world.fingerprint;
    if (!sameWorld) {
      for (const key of this.tracker.forget()) this.emit('chunkLeft', key);
    } else if (before.storeId !== world.storeId) {
      this.tracker.forgetRevisions();
    }
    this.world = world;
    this.connected = true;
    ++this.stats.connections;
    this.worldKnown(sameWorld);
    this.emit('connected', world, before === null || sameWorld);
    if (!this.connected) return; // a handler closed the client
    if (this.wanted !== null) {
      try {
        checkLimits(this.wanted, new ViewShape(this.wanted, world), world.limits);
      } catch (error) {
        this.wanted = this.tracker.view = null;
        this.emit('error', error as TalusError);
      }
    }
    if (this.wanted !== null) this.applyView();
  }

  /** Called before the application is notified. */
  protected abstract worldKnown(sameWorld: boolean): void;

  /** Delivers a chunk of the View, unless the application has it. */
  protected deliver(chunk: Chunk): boolean {
    if (!this.tracker.deliver(chunk)) return false;
    ++this.stats.chunks;
    if (chunk.material !== null) ++this.stats.uniformChunks;
    this.stats.firstChunkMs ??= performance.now() - this.viewSince;
    this.emit('chunk', chunk);
    return true;
  }

  /** Unless a newer View is waiting to be applied. */
  protected tellComplete(): void {
    if (this.tracker.view !== this.wanted) return;
    this.stats.viewCompleteMs ??= performance.now() - this.viewSince;
    this.emit('viewComplete', this.tracker.view!);
  }

  /** The connection is gone: reconnects, or ends. */
  protected lost(error: TalusError): void {
    if (this.isClosed) return;
    this.connected = false;
    clearTimeout(this.viewTimer);
    this.viewTimer = undefined;
    // A delay requested by a server applies to this server, not to the next one.
    const asked = typeof this.options.url !== 'string' && this.options.url.length > 1 ? 0 : error.retryAfterMs;
    // Before it has joined, what is not a server's answer never becomes one.
    const isFinal = error.kind === 'refused' || (error.kind === 'broken_protocol' && this.world === null);
    const wait = isFinal ? null : this.backoff.next(asked);
    this.emit('disconnected', error, wait);
    if (this.isClosed) return;
    if (wait === null) {
      this.end(error);
      return;
    }
    this.retryTimer = setTimeout(this.retryNow, wait);
  }

  retry(): void {
    this.retryNow();
  }

  private readonly retryNow = (): void => {
    if (this.retryTimer === undefined) return;
    clearTimeout(this.retryTimer);
    this.retryTimer = undefined;
    this.attempt();
  };

  /** Connects; must call joined() or lost(). */
  protected abstract attempt(): void;

  protected end(error: TalusError | null): void {
    if (this.isClosed) return;
    this.isClosed = true;
    this.connected = false;
    this.closeError = error;
    clearTimeout(this.viewTimer);
    clearTimeout(this.retryTimer);
    this.retryTimer = undefined;
    globalThis.removeEventListener?.('online', this.retryNow);
    this.stopped();
    this.emit('closed', error);
  }

  /** Must free the connection's state, and fail what is unanswered. */
  protected abstract stopped(): void;

  close(): void {
    this.end(null);
  }

  abstract taken(chunk: Chunk): void;
  abstract getChunk(key: ChunkKey): Promise<Chunk>;
  abstract getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    wanted?: { readonly looks?: boolean; readonly fields?: readonly string[] },
  ): Promise<Places>;
  abstract edit(edit: Edit): Promise<EditDone>;
  abstract editLimits(): Promise<EditLimits>;
  abstract ping(): Promise<number>;
}

function sameRings(a: View, b: View): boolean {
  return JSON.stringify(a.rings) === JSON.stringify(b.rings);
}

/** True if two Views have the same chunks. */
function sameChunks(a: View, b: View): boolean {
  const chunk = (at: number) => Math.floor(at / 32);
  return (
    chunk(a.centre.x) === chunk(b.centre.x) &&
    chunk(a.centre.y) === chunk(b.centre.y) &&
    chunk(a.centre.z) === chunk(b.centre.z) &&
    a.horizontalRadius === b.horizontalRadius &&
    a.verticalRadius === b.verticalRadius &&
    a.horizon === b.horizon &&
    sameRings(a, b)
  );
}

/** True if a server would send the same chunks in nearly the same order: small turns need no new View. */
function sameView(a: View | null, b: View | null): boolean {
  if (a === null || b === null) return a === b;
  return sameChunks(a, b) && isNear(a.direction, b.direction);
}

function isNear(a: View['direction'], b: View['direction']): boolean {
  if (a === undefined || b === undefined) return a === b;
  const length = Math.hypot(a.x, a.y, a.z) * Math.hypot(b.x, b.y, b.z);
  return !(length > 0) || a.x * b.x + a.y * b.y + a.z * b.z > 0.97 * length;
}
