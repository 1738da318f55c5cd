// A world made here behind the interface of a client: the same events, calls and chunks as of a server.
import { ClientBase } from '../client/base.js';
import { TalusError } from '../errors.js';
import { checkColumns, checkKey, keyName } from '../keys.js';
import type { Chunk, ChunkKey, Edit, EditDone, EditLimits, Limits, Places, World as WorldFacts } from '../types.js';
import { uniformPayload } from '../uniform.js';
import { EditQueue } from './edit_queue.js';
import type { EditStore } from './edit_store.js';
import { Making, type Made } from './making.js';
import type { Key } from './messages.js';
import { WorldError, type World } from './world.js';

/** Bounds of core/edits. */
const EDIT_LIMITS: EditLimits = { voxels: 65_536, chunks: 64, unanswered: 0, voxelsPerSecond: 0 };
const LIMITS: Limits = {
  frameBytes: 1 << 20,
  requestsInFlight: 0,
  heightsPerRequest: 65_536,
  viewHorizontalRadius: 128,
  viewVerticalRadius: 128,
  viewChunks: 1 << 20,
  windowBytes: 0,
  idleTimeoutMs: 0,
  sessionRates: null,
  addressRates: null,
  viewHorizon: true,
  viewBase: false,
};
/** Columns of a request for heights are made together if they lie in a square of this side. */
const HEIGHTS_SIDE = 32;

export interface SourceOptions {
  /** Keeps the edits; without one they last as long as the World. */
  readonly store?: EditStore | Promise<EditStore>;
  /** True if the application calls Client.taken() when it is done with a chunk, so that chunks are never made far ahead
   *  of a slow application. */
  readonly manualCredit?: boolean;
}

/** Chunks that are not uniform. */
const MOST_UNTAKEN = 512;

export class LocalSource extends ClientBase {
  private readonly making: Making;
  private readonly edits: EditQueue;
  /** Of chunks that were edited. */
  private readonly revisions = new Map<string, bigint>();
  /** World.edits when a chunk changed last. */
  private readonly changedAt = new Map<string, number>();
  private readonly untaken = new Set<Chunk>();
  private readonly uniform = new Map<number, Uint8Array<ArrayBuffer>>();

  constructor(
    private readonly made: World,
    { store, manualCredit = false }: SourceOptions,
  ) {
    super({ url: 'here:', manualCredit });
    this.making = new Making(made, {
      made: (chunk, edits) => this.take(chunk, edits),
      whole: () => this.tellComplete(),
      failed: (error) => this.emit('error', asTalusError(error)),
      isFull: () => this.untaken.size >= MOST_UNTAKEN,
    });
    this.edits = new EditQueue(made, store ?? null, {
      changed: (chunks, revision) => this.changed(chunks, revision),
      notKept: (error) => this.emit('error', error),
    });
    queueMicrotask(() => this.attempt());
  }

  protected attempt(): void {
    Promise.all([this.made.spawn(), this.edits.begin()]).then(
      ([spawn]) => {
        if (this.isClosed) return;
        const { fingerprint, codecVersion: codec, materials, heightRange } = this.made;
        const facts: WorldFacts = {
          protocol: 0,
          fingerprint,
          storeId: this.edits.storeId,
          codec,
          materials,
          minY: heightRange.low,
          maxY: heightRange.high,
          spawn,
          limits: LIMITS,
          server: 'made here',
          looks: [''],
          fields: [],
          worldFile: '',
        };
        this.joined(facts);
      },
      (error: Error) => this.end(asTalusError(error)),
    );
  }

  protected worldKnown(): void {}

  protected viewApplied(): void {
    const { view, shape } = this.tracker;
    this.making.want(view, shape);
  }

  protected stopped(): void {
    this.making.end();
    this.edits.end();
  }

  taken(chunk: Chunk): void {
    if (this.untaken.delete(chunk)) this.making.goOn();
  }

  async getChunk(key: ChunkKey): Promise<Chunk> {
    this.checkOpen();
    checkKey(key);
    const { edits } = this.made;
    const { uniform, payload } = await this.made.generate(key, { voxels: false, payload: true }).catch(rethrow);
    const chunk = this.chunkOf({ key: { ...key }, payload: payload as Uint8Array<ArrayBuffer> | null, material: uniform });
    return this.isStale(key, edits) ? this.getChunk(key) : chunk;
  }

  async getPlaces(columns: readonly { readonly x: number; readonly z: number }[], wanted: { readonly looks?: boolean; readonly fields?: readonly string[] } = {}): Promise<Places> {
    this.checkOpen();
    checkColumns(columns);
    if (wanted.fields?.length) throw new TalusError('out_of_range', `fields: ${wanted.fields[0]} is not known here`);
    const heightsFx = new Int32Array(columns.length);
    const squares = new Map<string, number[]>();
    columns.forEach(({ x, z }, i) => {
      const name = `${Math.floor(x / HEIGHTS_SIDE)}/${Math.floor(z / HEIGHTS_SIDE)}`;
      squares.set(name, [...(squares.get(name) ?? []), i]);
    });
    const make = async (indices: number[]) => {
      const xs = indices.map((i) => columns[i]!.x);
      const zs = indices.map((i) => columns[i]!.z);
      const [x, z] = [Math.min(...xs), Math.min(...zs)];
      const width = Math.max(...xs) - x + 1;
      const ground = await this.made.heights({ x, z, width, depth: Math.max(...zs) - z + 1 }).catch(rethrow);
      for (const i of indices) heightsFx[i] = ground[(columns[i]!.z - z) * width + columns[i]!.x - x]!;
    };
    await Promise.all([...squares.values()].map(make));
    return { heightsFx, looks: wanted.looks === true ? new Uint8Array(columns.length) : null, values: null };
  }

  async edit(edit: Edit): Promise<EditDone> {
    this.checkOpen();
    return this.edits.edit(edit).catch(rethrow);
  }

  async editLimits(): Promise<EditLimits> {
    this.checkOpen();
    return EDIT_LIMITS;
  }

  async ping(): Promise<number> {
    this.checkOpen();
    return 0;
  }

  private checkOpen(): void {
    if (this.isClosed) throw this.closedError();
  }

  private take(made: Made, edits: number): void {
    if (this.isStale(made.key, edits)) return this.makeAgain(made.key);
    if (this.tracker.has(made.key)) return;
    const chunk = this.chunkOf(made);
    if (this.options.manualCredit === true && chunk.material === null) this.untaken.add(chunk);
    if (this.deliver(chunk)) ++this.stats.madeChunks;
    else this.untaken.delete(chunk);
  }

  private chunkOf({ key, payload, material }: Made): Chunk {
    const revision = this.revisions.size > 0 ? (this.revisions.get(keyName(key)) ?? 0n) : 0n;
    return { key, revision, hash: null, payload: material === null ? payload! : this.uniformPayload(material), material };
  }

  private uniformPayload(material: number): Uint8Array<ArrayBuffer> {
    let payload = this.uniform.get(material);
    if (payload === undefined) this.uniform.set(material, (payload = uniformPayload(material)));
    return payload.slice();
  }

  private isStale(key: ChunkKey, edits: number): boolean {
    return this.changedAt.size > 0 && (this.changedAt.get(keyName(key)) ?? 0) > edits;
  }

  private changed(chunks: readonly Key[], revision: bigint): void {
    for (const key of chunks) {
      const name = keyName(key);
      this.revisions.set(name, revision);
      this.changedAt.set(name, this.made.edits);
    }
    for (const key of chunks) if (this.tracker.has(key)) this.makeAgain(key);
  }

  private makeAgain(key: ChunkKey): void {
    this.getChunk(key).then(
      (chunk) => this.isClosed || this.deliver(chunk),
      (error: TalusError) => this.isClosed || this.emit('error', error),
    );
  }
}

function asTalusError(error: Error): TalusError {
  if (!(error instanceof WorldError)) return error instanceof TalusError ? error : new TalusError('server_failed', error.message);
  const kinds = { conflict: 'conflict', range: 'out_of_range', closed: 'closed' } as const;
  return new TalusError(kinds[error.kind as keyof typeof kinds] ?? 'server_failed', error.message);
}

function rethrow(error: Error): never {
  throw asTalusError(error);
}
