// A client over HTTP, through any cache: PROTOCOL.md, "HTTP". It fetches all chunks of a column at once, and distant
// columns in squares. Before columns, and again at an interval, it asks which columns of their region were edited:
// edited ones are fetched by revision, all others as generated, which every cache keeps for ever.
import { ClientBase } from '../client/base.js';
import { TalusError } from '../errors.js';
import { checkColumns, checkKey, keyName } from '../keys.js';
import type { Chunk, ChunkKey, ConnectOptions, EditDone, EditLimits, Places } from '../types.js';
import { decodeChunk } from '../decode.js';
import { hashVoxels } from '../hash.js';
import type { MadeTiles } from '../local/made_tiles.js';
import { materialOf } from '../uniform.js';
import type { Range } from '../view_shape.js';
import { broken } from '../wire/table.js';
import { RequestQueue } from './request_queue.js';
import { MAX_BODY_BYTES, readColumn, readSquare } from './columns.js';
import { EditedRegions } from './edited_regions.js';
import {
  EditedColumns,
  MAX_REGION_BYTES,
  type Region,
  regionName,
  regionOf,
  revisionOf,
  revisionOfAnswer,
} from './edits.js';
import { get, type Getter, type Got, HttpError } from './get.js';
import { askHeights } from './heights.js';
import { forEachColumn, quarters, type Tile, tileName, tilesOf } from './tiles.js';
import { readWorld } from './world.js';

const MAX_PAYLOAD_BYTES = 65_538;
const MAX_WORLD_BYTES = 4 << 20;
const MAX_REQUESTS_AT_ONCE = 6; // a browser's connections to one server
const DEFAULT_WINDOW_BYTES = 1 << 20;

const DEFAULT_EDITS_INTERVAL_MS = 5_000;
const NO_STORE = '0'.repeat(32);
/** Statuses below 500 that a server may give for a while. */
const MAY_PASS: ReadonlySet<number> = new Set([401, 403, 408, 425, 429]);

/** A unit of fetching; nearest first. */
type Task = { readonly tile: Tile } | { readonly key: ChunkKey } | { readonly region: Region };

/** A column delivered to the application. */
interface GivenColumn {
  readonly rows: Range;
  readonly revision: bigint;
  /** For a column with edits, by row: only differences to it are delivered from the next revision. */
  readonly payloads: ReadonlyMap<number, Uint8Array> | null;
}

function columnName(lod: number, x: number, z: number): string {
  return `${lod}/${x}/${z}`;
}

export class HttpClient extends ClientBase {
  private readonly base: string;
  private readonly getter: Getter;
  private abort = new AbortController();
  private tasks: Task[] = [];
  private running = new Map<Task, AbortController>();
  private readonly asked = new RequestQueue(
    () => (this.isClosed ? this.closedError() : null),
    () => this.pump(),
  );
  private readonly columns = new Map<string, GivenColumn>();
  private store = NO_STORE; // whose edits are in the columns
  private readonly regions = new EditedRegions();
  private editsTimer: ReturnType<typeof setTimeout> | undefined;
  private completeToTell = false;
  private holdTimer: ReturnType<typeof setTimeout> | undefined;
  /** Makes columns as generated (ConnectOptions.generate); null: they are fetched. */
  private maker: MadeTiles | null = null;
  private opening = new AbortController();
  private openedFor = ''; // fingerprint of the world that was opened, or could not be
  private readonly debts = new WeakMap<Chunk, number>();
  private owedBytes = 0; // of chunks with which the application is not done

  constructor(options: ConnectOptions, url: URL) {
    super(options);
    this.base = url.href.replace(/\/$/, '');
    this.getter = { fetch: options.fetch ?? globalThis.fetch.bind(globalThis), token: options.token };
    this.attempt();
  }

  private get worldUrl(): string {
    return `${this.base}/v1/${this.world!.fingerprint}`;
  }

  /** URL of a chunk, a column or a square, by name, at a revision. */
  private chunksUrl(name: string, revision: bigint): string {
    if (revision === 0n) return `${this.worldUrl}/${this.world!.codec}/${name}`;
    return `${this.worldUrl}/${this.store}/${this.world!.codec}/${name}@${revision}`;
  }

  private regionUrl(region: Region): string {
    return `${this.worldUrl}/${this.store}/edits/${regionName(region)}`;
  }

  private async get(url: string, maxBytes: number, signal = this.abort.signal, method = 'GET'): Promise<Got> {
    const began = performance.now();
    ++this.stats.requests;
    const got = await get(this.getter, url, maxBytes, signal, method);
    this.stats.latencyMs = performance.now() - began;
    this.stats.receivedBytes += got.body.length;
    return got;
  }

  // ---- connection: for HTTP, whether the last request was answered

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
    const url = `${this.base}/v1/world`;
    const { body } = await this.get(url, MAX_WORLD_BYTES).catch((error: TalusError) => {
      const isFound = this.world !== null || !(error instanceof HttpError) || MAY_PASS.has(error.status);
      if (isFound || error.status >= 500) throw error;
      throw new TalusError('refused', `${url} answered ${error.status}: no Talus server has this URL`);
    });
    try {
      return readWorld(JSON.parse(new TextDecoder().decode(body)));
    } catch (error) {
      throw error instanceof TalusError ? error : broken(`a world that is no JSON: ${(error as Error).message}`);
    }
  }

  protected worldKnown(sameWorld: boolean): void {
    const { storeId } = this.world!;
    if (!sameWorld || storeId !== this.store) {
      this.columns.clear();
      this.regions.clear();
    }
    this.store = storeId;
    if (!sameWorld) this.stopMaking();
    if (this.options.generate === 'always') this.beginMaking();
    this.lookForEdits();
    this.askForEditsLater();
    this.pump();
  }

  // ---- chunks made here

  private beginMaking(): void {
    const world = this.world!;
    if (world.worldFile === '' || this.openedFor === world.fingerprint) return;
    const { fingerprint } = world;
    const { signal } = (this.opening = new AbortController());
    this.openedFor = fingerprint;
    const isCurrent = () => !this.isClosed && this.openedFor === fingerprint;
    const failed = (why: Error) => isCurrent() && this.cannotMake(why);
    const compare = async (key: ChunkKey): Promise<Chunk> => {
      ++this.stats.proofs;
      const { payload, revision } = await this.asked.inTurn(() => this.getPayload(key, this.abort.signal, 0n));
      return { key, revision, hash: hashVoxels(decodeChunk(payload)), payload, material: null };
    };
    import('../local/made_tiles.js')
      .then(({ MadeTiles }) => MadeTiles.open(this.options, this.base, world, { compare, failed }, signal))
      .then((maker) => (isCurrent() ? (this.maker = maker) : maker.end()), failed);
  }

  private cannotMake(why: Error): void {
    if (this.maker === null && this.saidWhy === this.openedFor) return;
    this.saidWhy = this.openedFor;
    const hasMade = this.maker !== null;
    this.stopMaking(false);
    this.emit('error', new TalusError('cannot_generate', `chunks are not made here: ${why.message}`));
    if (!hasMade) return;
    // What was made comes again.
    for (const [name, { revision }] of this.columns) if (revision === 0n) this.columns.delete(name);
    if (this.connected && this.tracker.view !== null) this.viewApplied();
  }
  private saidWhy = '';

  private stopMaking(mayOpen = true): void {
    this.opening.abort();
    this.maker?.end();
    this.maker = null;
    if (mayOpen) this.openedFor = '';
  }

  private async makeTile(tile: Tile, maker: MadeTiles, signal: AbortSignal): Promise<void> {
    const { shape } = this.tracker;
    if (shape === null) return;
    let made: Awaited<ReturnType<MadeTiles['make']>>;
    try {
      made = await maker.make(tile, shape);
    } catch (error) {
      if (maker !== this.maker || signal.aborted) return;
      this.tasks.unshift({ tile });
      this.cannotMake(error as Error);
      return;
    }
    if (signal.aborted) return;
    for (const { x, z, rows, chunks } of made) {
      const now = this.tracker.shape?.rows(tile.lod, x, z);
      if (now?.first !== rows.first || now.last !== rows.last) continue; // another View wants it anew
      const given = { rows, revision: 0n, payloads: null };
      this.columns.set(columnName(tile.lod, x, z), given);
      for (const chunk of chunks) if (this.connected && this.give(chunk)) ++this.stats.madeChunks;
      if (this.isOld(given, tile.lod, x, z)) this.tasks.unshift({ tile: { lod: tile.lod, x, z, n: 1 } }); // by now
    }
  }

  // ---- edits

  private get hasEdits(): boolean {
    return this.store !== NO_STORE;
  }

  private askForEditsLater(): void {
    const interval = this.options.editsIntervalMs ?? DEFAULT_EDITS_INTERVAL_MS;
    if (!this.hasEdits || !(interval > 0) || interval === Infinity) return;
    this.editsTimer ??= setTimeout(() => {
      this.editsTimer = undefined;
      this.lookForEdits();
      this.askForEditsLater();
      this.pump();
    }, interval);
  }

  /** Requests all regions of the View that are not being requested, before anything else. */
  private lookForEdits(): void {
    const asked = new Set<string>();
    for (const task of [...this.tasks, ...this.running.keys()]) {
      if ('region' in task) asked.add(regionName(task.region));
    }
    this.tasks.unshift(...this.regions.others(asked).map((region) => ({ region })));
  }

  private editedOf(lod: number, x: number, z: number): EditedColumns | null {
    if (!this.hasEdits) return EditedColumns.none;
    return this.regions.of(lod, x, z);
  }

  private isOld({ revision }: GivenColumn, lod: number, x: number, z: number): boolean {
    return (this.editedOf(lod, x, z)?.revision(x, z) ?? 0n) > revision;
  }

  private takeRegion(region: Region, edited: EditedColumns): void {
    if (!this.regions.take(region, edited)) return;
    const newer: Task[] = [];
    for (const [name, given] of this.columns) {
      const [lod, x, z] = name.split('/').map(Number) as [number, number, number];
      const its = regionOf(lod, x, z);
      if (lod !== region.lod || its.x !== region.x || its.z !== region.z) continue;
      if (this.isOld(given, lod, x, z)) newer.push({ tile: { lod, x, z, n: 1 } });
    }
    const coming = new Set([...this.tasks, ...this.running.keys()].map((task) => ('tile' in task ? tileName(task.tile) : '')));
    this.tasks.unshift(...newer.filter((task) => 'tile' in task && !coming.has(tileName(task.tile))));
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
    clearTimeout(this.editsTimer);
    this.editsTimer = undefined;
    this.completeToTell = false;
  }

  protected stopped(): void {
    this.halt();
    this.stopMaking();
    this.asked.failAll();
  }

  // ---- the View

  protected viewApplied(): void {
    const { view, shape } = this.tracker;
    this.completeToTell = view !== null;
    const toAsk = this.tasks.filter((task) => 'region' in task);
    this.tasks = [];
    this.regions.follow(this.hasEdits ? shape : null);
    for (const [name, { rows }] of this.columns) {
      const [lod, x, z] = name.split('/').map(Number) as [number, number, number];
      const now = shape?.rows(lod, x, z);
      if (now?.first !== rows.first || now.last !== rows.last) this.columns.delete(name);
    }
    const coming = new Set<string>();
    const asked = new Set<string>(); // regions
    for (const [task, controller] of this.running) {
      if ('region' in task) {
        if (this.regions.has(task.region)) {
          asked.add(regionName(task.region));
        } else {
          this.running.delete(task);
          controller.abort();
        }
      }
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
        const given = this.columns.get(columnName(lod, x, z));
        if (given !== undefined && !this.isOld(given, lod, x, z)) return false;
        return !coming.has(columnName(lod, x, z));
      }).map((tile) => ({ tile }));
    }
    for (const task of toAsk) {
      if (!('region' in task) || !this.regions.has(task.region)) continue;
      asked.add(regionName(task.region));
      this.tasks.unshift(task);
    }
    this.tasks.unshift(...this.regions.others(asked, true).map((region) => ({ region })));
    this.pump();
  }

  /** Starts as many tasks as allowed, the application's requests first. */
  private pump(): void {
    if (!this.connected) return;
    const maxRunning = Math.max(1, Math.min(MAX_REQUESTS_AT_ONCE, this.options.requestsAtOnce ?? MAX_REQUESTS_AT_ONCE));
    const isFull = () => this.asked.running + this.running.size >= maxRunning;
    while (!isFull() && this.asked.startNext());
    const window = this.options.windowBytes ?? DEFAULT_WINDOW_BYTES;
    while (!isFull() && this.holdTimer === undefined && this.owedBytes < window) {
      const next = this.tasks.findIndex((each) => this.mayStart(each));
      if (next < 0) break;
      const task = this.tasks.splice(next, 1)[0]!;
      const controller = new AbortController();
      this.running.set(task, controller);
      void this.run(task, controller);
    }
    if (this.completeToTell && this.tasks.length === 0 && this.running.size === 0) {
      this.completeToTell = false;
      this.tellComplete();
      if (this.connected && this.options.generate === 'auto') this.beginMaking();
    }
  }

  /** True if the edited columns of its region are known. */
  private mayStart(task: Task): boolean {
    if ('region' in task) return true;
    const { lod, x, z } = 'tile' in task ? task.tile : task.key;
    return this.editedOf(lod, x, z) !== null;
  }

  private async run(task: Task, controller: AbortController): Promise<void> {
    try {
      if ('region' in task) {
        const { body } = await this.get(this.regionUrl(task.region), MAX_REGION_BYTES, controller.signal);
        if (controller.signal.aborted) return;
        this.backoff.reset();
        this.takeRegion(task.region, EditedColumns.read(body));
      } else if ('tile' in task) {
        const { tile } = task;
        const edited = this.editedOf(tile.lod, tile.x, tile.z)!;
        const revision = revisionOf(tile, edited);
        if (this.maker !== null && (revision === 0n || tile.n > 1)) {
          if (revision === 0n) await this.makeTile(tile, this.maker, controller.signal);
          else this.tasks.unshift(...quarters(tile).map((part) => ({ tile: part }))); // only the edited columns come
          this.running.delete(task);
          this.pump();
          return;
        }
        const got = await this.get(this.chunksUrl(tileName(tile), revision), MAX_BODY_BYTES, controller.signal);
        if (controller.signal.aborted) return;
        this.backoff.reset();
        this.stats.chunkBytes += got.body.length;
        this.takeTile(tile, got.body, edited, revisionOfAnswer(got, revision));
      } else {
        const { key } = task;
        const { payload, revision } = await this.getPayload(key, controller.signal);
        if (controller.signal.aborted) return;
        this.backoff.reset();
        this.stats.chunkBytes += payload.length;
        this.give({ key, revision, hash: null, payload, material: materialOf(payload) });
      }
    } catch (error) {
      if (controller.signal.aborted) return;
      if (!(error instanceof TalusError)) throw error;
      this.running.delete(task);
      this.failTask(task, error);
    }
    this.running.delete(task);
    this.pump();
  }

  private async getPayload(
    key: ChunkKey,
    signal: AbortSignal,
    asked = this.editedOf(key.lod, key.x, key.z)?.revision(key.x, key.z) ?? 0n, // its column's
  ): Promise<{ payload: Uint8Array<ArrayBuffer>; revision: bigint }> {
    const got = await this.get(this.chunksUrl(keyName(key), asked), MAX_PAYLOAD_BYTES, signal);
    return { payload: got.body.slice(), revision: revisionOfAnswer(got, asked) };
  }

  /** `revision`: the square's. A column in it is at least at the revision known when it was requested. */
  private takeTile(tile: Tile, body: Uint8Array, edited: EditedColumns, revision: bigint): void {
    const bodies = tile.n === 1 ? [body] : readSquare(body, tile.n);
    let i = 0;
    forEachColumn(tile, (x, z) => {
      const column = bodies[i++]!;
      const rows = this.tracker.shape?.rows(tile.lod, x, z);
      if (rows === undefined || rows.last < rows.first || !this.connected) return;
      const runs = readColumn(column, tile.lod);
      const name = columnName(tile.lod, x, z);
      const its = tile.n === 1 ? revision : edited.revision(x, z);
      const before = this.columns.get(name);
      if (before !== undefined && before.revision > its) return;
      const payloads = its > 0n ? new Map<number, Uint8Array>() : null;
      const given = { rows, revision: its, payloads };
      this.columns.set(name, given);
      if (this.isOld(given, tile.lod, x, z)) this.tasks.unshift({ tile: { lod: tile.lod, x, z, n: 1 } }); // by now
      for (const run of runs) {
        const last = Math.min(rows.last, run.firstY + run.count - 1);
        const first = Math.max(rows.first, run.firstY);
        if (first > last) continue;
        const material = materialOf(run.payload);
        const kept = payloads === null ? run.payload : run.payload.slice();
        for (let y = first; y <= last && this.connected; ++y) {
          payloads?.set(y, kept);
          if (sameBytes(before?.payloads?.get(y), run.payload)) continue;
          this.give({
            key: { lod: tile.lod, x, y, z },
            revision: its,
            hash: null,
            payload: new Uint8Array(run.payload),
            material,
          });
        }
      }
    });
  }

  /** Returns true if it was new to the application. */
  private give(chunk: Chunk): boolean {
    if (!this.deliver(chunk)) return false;
    if (this.options.manualCredit) {
      this.debts.set(chunk, chunk.payload.length);
      this.owedBytes += chunk.payload.length;
    }
    return true;
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
      // Another world may be behind this address.
      this.fail(new TalusError('disconnected', error.message));
      return;
    }
    if (error instanceof HttpError && error.code === 'too_large' && 'tile' in task) {
      this.tasks.unshift(...this.smaller(task.tile));
      return;
    }
    if (error.kind === 'out_of_range' || error.kind === 'broken_protocol') {
      if ('region' in task) this.takeRegion(task.region, EditedColumns.none); // until it is requested again
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

  // ---- the application's requests

  async getChunk(key: ChunkKey): Promise<Chunk> {
    checkKey(key);
    const { payload, revision } = await this.asked.inTurn(async () => {
      if (!this.hasEdits) return this.getPayload(key, this.abort.signal);
      // Known data of its region may be outdated.
      const region = regionOf(key.lod, key.x, key.z);
      const { body } = await this.get(this.regionUrl(region), MAX_REGION_BYTES);
      const asked = EditedColumns.read(body).revision(key.x, key.z);
      return this.getPayload(key, this.abort.signal, asked);
    });
    return { key: { ...key }, revision, hash: null, payload, material: materialOf(payload) };
  }

  async getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    wanted: { readonly looks?: boolean; readonly fields?: readonly string[] } = {},
  ): Promise<Places> {
    checkColumns(columns);
    const get = async (query: string) => (await this.get(`${this.base}/v1/heights?${query}`, MAX_BODY_BYTES)).body;
    return askHeights(columns, wanted, () => this.world!.looks, (query) => this.asked.inTurn(() => get(query)));
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

function sameBytes(a: Uint8Array | undefined, b: Uint8Array): boolean {
  return a !== undefined && a.length === b.length && a.every((byte, i) => byte === b[i]);
}
