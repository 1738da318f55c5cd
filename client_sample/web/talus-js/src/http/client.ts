// A client over HTTP, through any cache: PROTOCOL.md, "HTTP". Of each column of the View it gets all chunks at once, of
// far ones by squares.
import { ClientBase } from '../client/base.js';
import { TalusError } from '../errors.js';
import { checkKey, keyName } from '../keys.js';
import type { Chunk, ChunkKey, ConnectOptions, EditDone, EditLimits, Places } from '../types.js';
import { materialOf } from '../uniform.js';
import type { Range } from '../view_shape.js';
import { broken } from '../wire/table.js';
import { MAX_BODY_BYTES, readColumn, readSquare } from './columns.js';
import { get, type Getter, HttpError } from './get.js';
import { readHeights } from './heights.js';
import { forEachColumn, quarters, type Tile, tileName, tilesOf } from './tiles.js';
import { readWorld } from './world.js';

const MAX_PAYLOAD_BYTES = 65_538;
const MAX_WORLD_BYTES = 4 << 20;
const MAX_REQUESTS_AT_ONCE = 6; // a browser's connections to one server
const DEFAULT_WINDOW_BYTES = 1 << 20;
const HEIGHTS_PATH_BYTES = 700; // of columns; servers and caches bound the length of a path

/** Something to get; nearest first. */
type Task = { readonly tile: Tile } | { readonly key: ChunkKey };

function columnName(lod: number, x: number, z: number): string {
  return `${lod}/${x}/${z}`;
}

export class HttpClient extends ClientBase {
  private readonly base: string;
  private readonly getter: Getter;
  private abort = new AbortController();
  private tasks: Task[] = [];
  private running = new Map<Task, AbortController>();
  private readonly asked: (() => void)[] = []; // requests of the application, before all tasks
  private askedRunning = 0;
  private readonly columns = new Map<string, Range>(); // which rows of them the application was given
  private completeToTell = false;
  private holdTimer: ReturnType<typeof setTimeout> | undefined;
  private readonly debts = new WeakMap<Chunk, number>();
  private owedBytes = 0; // of chunks with which the application is not done

  constructor(options: ConnectOptions, url: URL) {
    super(options);
    this.base = url.href.replace(/\/$/, '');
    this.getter = { fetch: options.fetch ?? globalThis.fetch.bind(globalThis), token: options.token };
    this.attempt();
  }

  private get chunksUrl(): string {
    return `${this.base}/v1/${this.world!.fingerprint}/${this.world!.codec}`;
  }

  private async get(url: string, most: number, signal = this.abort.signal, method = 'GET'): Promise<Uint8Array> {
    const began = performance.now();
    ++this.stats.requests;
    const body = await get(this.getter, url, most, signal, method);
    this.stats.latencyMs = performance.now() - began;
    this.stats.receivedBytes += body.length;
    return body;
  }

  // ---- the connection, as far as HTTP has one: whether the server answered last

  protected attempt(): void {
    const { signal } = (this.abort = new AbortController());
    this.getWorld().then(
      (world) => {
        if (!signal.aborted) this.joined(world);
      },
      (error: TalusError) => {
        if (!signal.aborted) this.fail(error);
      },
    );
  }

  private async getWorld(): Promise<ReturnType<typeof readWorld>> {
    const body = await this.get(`${this.base}/v1/world`, MAX_WORLD_BYTES);
    try {
      return readWorld(JSON.parse(new TextDecoder().decode(body)));
    } catch (error) {
      throw error instanceof TalusError ? error : broken(`a world that is no JSON: ${(error as Error).message}`);
    }
  }

  protected worldKnown(sameWorld: boolean): void {
    if (!sameWorld) this.columns.clear();
    this.pump();
  }

  private fail(error: TalusError): void {
    this.halt();
    this.lost(error);
  }

  private halt(): void {
    this.abort.abort();
    this.tasks = [];
    for (const controller of this.running.values()) controller.abort();
    this.running.clear();
    clearTimeout(this.holdTimer);
    this.holdTimer = undefined;
    this.completeToTell = false;
  }

  protected stopped(): void {
    this.halt();
    for (const start of this.asked.splice(0)) start(); // they fail at once
  }

  // ---- the View

  protected viewApplied(): void {
    const { view, shape } = this.tracker;
    this.completeToTell = view !== null;
    this.tasks = [];
    for (const [name, rows] of this.columns) {
      const [lod, x, z] = name.split('/').map(Number) as [number, number, number];
      const now = shape?.rows(lod, x, z);
      if (now?.first !== rows.first || now.last !== rows.last) this.columns.delete(name);
    }
    const coming = new Set<string>();
    for (const [task, controller] of this.running) {
      if (!('tile' in task)) continue;
      let wanted = false;
      forEachColumn(task.tile, (x, z) => {
        if (!shape?.hasColumn(task.tile.lod, x, z)) return;
        wanted = true;
        coming.add(columnName(task.tile.lod, x, z));
      });
      if (!wanted) {
        this.running.delete(task);
        controller.abort();
      }
    }
    if (view !== null && shape !== null) {
      this.tasks = tilesOf(view, shape, (lod, x, z) => {
        const name = columnName(lod, x, z);
        return !this.columns.has(name) && !coming.has(name);
      }).map((tile) => ({ tile }));
    }
    this.pump();
  }

  /** Starts what may be started, the application's own requests first. */
  private pump(): void {
    if (!this.connected) return;
    const most = Math.max(1, Math.min(MAX_REQUESTS_AT_ONCE, this.options.requestsAtOnce ?? MAX_REQUESTS_AT_ONCE));
    const isFull = () => this.askedRunning + this.running.size >= most;
    while (!isFull() && this.asked.length > 0) this.asked.shift()!();
    const window = this.options.windowBytes ?? DEFAULT_WINDOW_BYTES;
    while (!isFull() && this.holdTimer === undefined && this.owedBytes < window) {
      const task = this.tasks.shift();
      if (task === undefined) break;
      const controller = new AbortController();
      this.running.set(task, controller);
      void this.run(task, controller);
    }
    if (this.completeToTell && this.tasks.length === 0 && this.running.size === 0) {
      this.completeToTell = false;
      this.tellComplete();
    }
  }

  private async run(task: Task, controller: AbortController): Promise<void> {
    try {
      const name = 'tile' in task ? tileName(task.tile) : keyName(task.key);
      const most = 'tile' in task ? MAX_BODY_BYTES : MAX_PAYLOAD_BYTES;
      const body = await this.get(`${this.chunksUrl}/${name}`, most, controller.signal);
      if (controller.signal.aborted) return;
      this.backoff.reset();
      this.stats.chunkBytes += body.length;
      if ('tile' in task) this.takeTile(task.tile, body);
      else this.give({ key: task.key, revision: 0n, hash: null, payload: body.slice(), material: materialOf(body) });
    } catch (error) {
      if (controller.signal.aborted) return;
      if (!(error instanceof TalusError)) throw error; // of an application's handler
      this.running.delete(task);
      this.failTask(task, error);
    }
    this.running.delete(task);
    this.pump();
  }

  private takeTile(tile: Tile, body: Uint8Array): void {
    const bodies = tile.n === 1 ? [body] : readSquare(body, tile.n);
    let i = 0;
    forEachColumn(tile, (x, z) => {
      const column = bodies[i++]!;
      const rows = this.tracker.shape?.rows(tile.lod, x, z);
      if (rows === undefined || rows.last < rows.first || !this.connected) return;
      const runs = readColumn(column, tile.lod);
      this.columns.set(columnName(tile.lod, x, z), rows);
      for (const run of runs) {
        const last = Math.min(rows.last, run.firstY + run.count - 1);
        const first = Math.max(rows.first, run.firstY);
        if (first > last) continue;
        const material = materialOf(run.payload);
        for (let y = first; y <= last && this.connected; ++y) {
          this.give({
            key: { lod: tile.lod, x, y, z },
            revision: 0n,
            hash: null,
            payload: new Uint8Array(run.payload),
            material,
          });
        }
      }
    });
  }

  private give(chunk: Chunk): void {
    if (!this.deliver(chunk) || !this.options.manualCredit) return;
    this.debts.set(chunk, chunk.payload.length);
    this.owedBytes += chunk.payload.length;
  }

  taken(chunk: Chunk): void {
    const bytes = this.debts.get(chunk);
    if (bytes === undefined) return;
    this.debts.delete(chunk);
    this.owedBytes -= bytes;
    this.pump();
  }

  private failTask(task: Task, error: TalusError): void {
    if (error.kind === 'overloaded') {
      this.tasks.unshift(task);
      const wait = this.backoff.next(error.retryAfterMs);
      if (wait === null) {
        this.fail(error);
        return;
      }
      this.holdTimer ??= setTimeout(() => {
        this.holdTimer = undefined;
        this.pump();
      }, wait);
      return;
    }
    if (error instanceof HttpError && error.status === 404) {
      // Another world stands behind this address, perhaps.
      this.fail(new TalusError('disconnected', error.message));
      return;
    }
    if (error instanceof HttpError && error.code === 'too_large' && 'tile' in task) {
      this.tasks.unshift(...this.smaller(task.tile));
      return;
    }
    if (error.kind === 'out_of_range' || error.kind === 'broken_protocol') {
      this.emit('error', error);
      return;
    }
    this.fail(error);
  }

  private smaller(tile: Tile): Task[] {
    if (tile.n > 1) return quarters(tile).map((part) => ({ tile: part }));
    const { lod, x, z } = tile;
    const rows = this.tracker.shape?.rows(lod, x, z);
    const tasks: Task[] = [];
    if (rows === undefined) return tasks;
    for (let y = rows.first; y <= rows.last; ++y) tasks.push({ key: { lod, x, y, z } });
    return tasks;
  }

  // ---- what the application asks

  /** In turn with the View's requests, and before them. */
  private ask(path: () => string, most: number): Promise<Uint8Array> {
    return new Promise((resolve, reject) => {
      if (this.isClosed) throw this.closedError();
      this.asked.push(() => {
        if (this.isClosed) {
          reject(this.closedError());
          return;
        }
        ++this.askedRunning;
        this.get(path(), most)
          .then(resolve, reject)
          .finally(() => {
            --this.askedRunning;
            this.pump();
          });
      });
      this.pump();
    });
  }

  async getChunk(key: ChunkKey): Promise<Chunk> {
    checkKey(key);
    const payload = new Uint8Array(await this.ask(() => `${this.chunksUrl}/${keyName(key)}`, MAX_PAYLOAD_BYTES));
    return { key: { ...key }, revision: 0n, hash: null, payload, material: materialOf(payload) };
  }

  async getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    { looks = false, fields = [] }: { readonly looks?: boolean; readonly fields?: readonly string[] } = {},
  ): Promise<Places> {
    const all: Places = {
      heightsFx: new Int32Array(columns.length),
      looks: looks ? new Uint8Array(columns.length) : null,
      values: fields.length > 0 ? new Float32Array(columns.length * fields.length) : null,
    };
    const rest = [
      ...(looks ? ['&looks=1'] : []),
      ...(fields.length > 0 ? [`&fields=${fields.map(encodeURIComponent).join(',')}`] : []),
    ].join('');
    for (let at = 0; at < columns.length; ) {
      let list = '';
      let end = at;
      for (; end < columns.length && list.length < HEIGHTS_PATH_BYTES; ++end) {
        list += `${list === '' ? '' : ';'}${columns[end]!.x},${columns[end]!.z}`;
      }
      const body = await this.ask(() => `${this.base}/v1/heights?columns=${list}${rest}`, MAX_BODY_BYTES);
      const places = readHeights(body, end - at, looks, fields, this.world!.looks);
      all.heightsFx.set(places.heightsFx, at);
      if (places.looks !== null) all.looks!.set(places.looks, at);
      if (places.values !== null) all.values!.set(places.values, at * fields.length);
      at = end;
    }
    return all;
  }

  async edit(): Promise<EditDone> {
    throw new TalusError('refused', 'edits need a stream: connect by ws:, wss:, tcp: or tls: instead of http:');
  }

  editLimits(): Promise<EditLimits> {
    return this.edit() as Promise<never>;
  }

  async ping(): Promise<number> {
    if (!this.connected) throw new TalusError('disconnected', 'ping: the client is not connected');
    const began = performance.now();
    await this.get(`${this.base}/v1/world`, 0, this.abort.signal, 'HEAD');
    return (this.stats.latencyMs = performance.now() - began);
  }
}
