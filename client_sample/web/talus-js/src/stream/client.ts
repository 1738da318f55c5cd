// A client over a stream of frames: PROTOCOL.md from "States" on.
import { ClientBase } from '../client/base.js';
import { PayloadCache } from '../client/payload_cache.js';
import { decodeChunk } from '../decode.js';
import { readRuns } from '../edits/runs.js';
import { EDIT_ID_BIT } from '../edits/open_edits.js';
import { EditSession } from '../edits/session.js';
import { encodeChunk } from '../encode.js';
import { TalusError } from '../errors.js';
import { hashVoxels } from '../hash.js';
import { checkKey, keyName, sameKey } from '../keys.js';
import type { Chunk, ChunkKey, ConnectOptions, Edit, EditDone, EditLimits, Places } from '../types.js';
import { materialOf, uniformPayload } from '../uniform.js';
import { FrameReader } from '../wire/frames.js';
import { readMessage, type ServerMessage } from '../wire/messages.js';
import { broken } from '../wire/table.js';
import {
  CHUNK_REQUEST_BYTES,
  type ChunkRequest,
  COLUMN_BYTES,
  creditFrame,
  getChunksFrame,
  getHeightsFrame,
  helloFrame,
  KNOWN_CHUNK_BYTES,
  type KnownChunk,
  pingFrame,
  REST_BYTES,
  viewFrame,
} from '../wire/write.js';
import { Pace } from './pace.js';
import { Requests } from './requests.js';
import type { OpenTransport, Transport } from './transport.js';

const OLDEST_PROTOCOL = 1;
const PROTOCOL = 2;
const CODEC = 4;
const CHUNK_VOLUME = 32_768;
const MAX_TEXT_BYTES = 4_096; // of token and client in Hello
const DEFAULT_WINDOW_BYTES = 1 << 20;
const DEFAULT_KEEP_BYTES = 16 << 20;
const DEFAULT_CONNECT_TIMEOUT_MS = 10_000;
const PING_INTERVAL_MS = 20_000;
const SILENCE_MS = 60_000;
/** A server ignores what a View knows beyond a bound; this fits any frame. */
const MAX_KNOWN = 8_192;
/** Far outside every world: a View without chunks. */
const NOWHERE = 2 ** 40;

type Message<K extends ServerMessage['kind']> = Extract<ServerMessage, { kind: K }>;

interface OpenPing {
  readonly sent: number;
  resolve(milliseconds: number): void;
  reject(error: TalusError): void;
}

/** Of a chunk whose credit is not given yet. */
interface Debt {
  readonly connection: number;
  readonly bytes: number;
}

export class StreamClient extends ClientBase {
  private transport: Transport | null = null;
  private connection = 0; // counts attempts
  private reader = new FrameReader();
  private readonly requests = new Requests();
  private readonly pace = new Pace();
  private readonly cache: PayloadCache;
  private readonly pings = new Map<bigint, OpenPing>();
  private lastNonce = 0;
  private debts = new WeakMap<Chunk, Debt>();
  private takenBytes = 0;
  private creditedBytes = 0;
  private viewNumber = 0;
  private viewToSend = false;
  private completeToTell = false;
  /** Whether the chunk changed again while it is on its way. */
  private readonly refetching = new Map<string, boolean>();
  private readonly edits = new EditSession(() => this.connected && this.sendLater(0));
  private leaving: TalusError | null = null; // since GoAway, or an Error that ends the connection
  private heardAt = 0;
  private deadline: ReturnType<typeof setTimeout> | undefined;
  private heartbeat: ReturnType<typeof setInterval> | undefined;
  private sendTimer: ReturnType<typeof setTimeout> | undefined;
  private readonly uniform = new Map<number, Uint8Array<ArrayBuffer>>();

  constructor(
    options: ConnectOptions,
    private readonly open: OpenTransport,
  ) {
    super(options);
    for (const [name, text] of [['token', options.token], ['clientName', options.clientName]] as const) {
      const bytes = new TextEncoder().encode(text ?? '').length;
      if (bytes > MAX_TEXT_BYTES) {
        throw new TalusError('out_of_range', `${name} has ${bytes} bytes; at most ${MAX_TEXT_BYTES} are allowed`);
      }
    }
    this.cache = new PayloadCache(options.keepBytes ?? DEFAULT_KEEP_BYTES);
    this.attempt();
  }

  // ---- the connection

  protected attempt(): void {
    const connection = ++this.connection;
    const isCurrent = () => connection === this.connection && !this.isClosed;
    this.reader = new FrameReader();
    this.takenBytes = this.creditedBytes = 0;
    this.leaving = null;
    const timeout = this.options.connectTimeoutMs ?? DEFAULT_CONNECT_TIMEOUT_MS;
    this.deadline = setTimeout(() => {
      this.drop(new TalusError('timed_out', `${this.options.url} did not answer within ${timeout / 1_000} s`));
    }, timeout);
    this.transport = this.open({
      opened: () => isCurrent() && this.sayHello(),
      received: (bytes) => isCurrent() && this.receive(bytes, isCurrent),
      ended: (error) => isCurrent() && this.drop(this.leaving ?? error),
    });
  }

  private sayHello(): void {
    this.send(
      helloFrame({
        protocolMin: OLDEST_PROTOCOL,
        protocolMax: PROTOCOL,
        codecs: [CODEC],
        token: this.options.token ?? '',
        client: this.options.clientName ?? 'talus-client for JavaScript',
        windowBytes: this.options.windowBytes ?? DEFAULT_WINDOW_BYTES,
      }),
    );
  }

  private send(frame: Uint8Array): void {
    this.stats.sentBytes += frame.length;
    this.transport?.send(frame);
  }

  /** Ends this connection; another attempt may follow. */
  private drop(error: TalusError): void {
    this.disconnect();
    const wasJoined = this.connected;
    if (wasJoined) for (const ping of this.takePings()) ping.reject(error);
    this.lost(error);
  }

  private disconnect(): void {
    ++this.connection; // what the transport still says is of no interest
    clearTimeout(this.deadline);
    clearInterval(this.heartbeat);
    clearTimeout(this.sendTimer);
    this.sendTimer = undefined;
    this.transport?.close();
    this.transport = null;
    this.refetching.clear();
    this.completeToTell = false;
    this.viewToSend = false;
    this.requests.putAllBack();
    this.edits.connectionEnded();
  }

  private takePings(): OpenPing[] {
    const pings = [...this.pings.values()];
    this.pings.clear();
    return pings;
  }

  protected stopped(): void {
    this.disconnect();
    const error = this.closedError();
    for (const ping of this.takePings()) ping.reject(error);
    this.requests.failAll(error);
    this.edits.failAll(error);
    this.cache.clear();
  }

  private receive(bytes: Uint8Array, isCurrent: () => boolean): void {
    this.stats.receivedBytes += bytes.length;
    this.heardAt = performance.now();
    try {
      this.reader.push(bytes, (frame) => {
        if (isCurrent()) this.handle(readMessage(frame), frame.length);
      });
    } catch (error) {
      if (!(error instanceof TalusError)) throw error; // of an application's handler
      if (isCurrent()) this.drop(error);
    }
  }

  // ---- messages

  private handle(message: ServerMessage, frameBytes: number): void {
    if (!this.connected) {
      if (message.kind === 'welcome') this.handleWelcome(message);
      else if (message.kind === 'error') this.handleFatal(message);
      else if (message.kind === 'go_away') this.handleGoAway(message);
      else throw broken(`${message.kind} before Welcome`);
      return;
    }
    switch (message.kind) {
      case 'chunk':
        return this.handleChunk(message, frameBytes);
      case 'unchanged':
        return this.handleUnchanged(message);
      case 'uniform_column':
        return this.handleUniformColumn(message);
      case 'view_complete':
        return this.handleViewComplete(message);
      case 'heights':
        return this.handleHeights(message);
      case 'error':
        return this.handleError(message);
      case 'edit_broadcast':
        return this.handleEditBroadcast(message);
      case 'edit_result':
        this.backoff.reset();
        this.edits.handleResult(message);
        return this.sendRequests();
      case 'attached':
        this.backoff.reset();
        this.edits.handleAttached(message);
        return this.sendRequests();
      case 'pong':
        return this.handlePong(message);
      case 'go_away':
        return this.handleGoAway(message);
      default:
        throw broken(`an unexpected ${message.kind}`);
    }
  }

  private handleWelcome({ world }: Message<'welcome'>): void {
    if (world.protocol < OLDEST_PROTOCOL || world.protocol > PROTOCOL || world.codec !== CODEC) {
      throw broken(`a Welcome for protocol ${world.protocol} and codec ${world.codec}, which were not offered`);
    }
    clearTimeout(this.deadline);
    this.pace.begin(world.limits.sessionRates, performance.now());
    this.joined(world);
  }

  protected worldKnown(sameWorld: boolean): void {
    if (!sameWorld) this.cache.clear();
    this.edits.joined(this.world!, sameWorld);
    const idle = this.world!.limits.idleTimeoutMs || PING_INTERVAL_MS * 3;
    this.heardAt = performance.now();
    this.heartbeat = setInterval(() => this.beat(), Math.min(PING_INTERVAL_MS, idle / 3));
    this.sendRequests();
  }

  private beat(): void {
    const silent = performance.now() - this.heardAt;
    if (silent > SILENCE_MS) {
      this.drop(new TalusError('timed_out', `the server said nothing for ${Math.round(silent / 1_000)} s`));
      return;
    }
    this.ping().catch(() => {}); // the connection's end is told elsewhere
  }

  private handleChunk(message: Message<'chunk'>, frameBytes: number): void {
    const { id, key, revision, hash, payload } = message;
    this.stats.chunkBytes += frameBytes;
    const chunk: Chunk = { key, revision, hash, payload, material: materialOf(payload) };
    this.debts.set(chunk, { connection: this.connection, bytes: frameBytes });
    this.edits.saw(revision);
    let given = false;
    if (id !== 0) {
      const request = this.requests.find(id);
      if (request?.kind !== 'chunk' || !sameKey(request.key, key)) {
        throw broken(`chunk ${keyName(key)} as the answer to request ${id}, which did not ask for it`);
      }
      this.requests.take(id);
      this.backoff.reset();
      given = true;
      request.resolve(chunk);
      this.sendRequests();
    } else if (this.tracker.shape?.covers(key)) {
      this.backoff.reset();
      this.keep(chunk);
      given = this.deliver(chunk);
    }
    if (!given || !this.options.manualCredit) this.taken(chunk);
  }

  taken(chunk: Chunk): void {
    const debt = this.debts.get(chunk);
    if (debt === undefined) return;
    this.debts.delete(chunk);
    if (debt.connection !== this.connection || !this.connected) return;
    this.takenBytes += debt.bytes;
    if (2 * (this.takenBytes - this.creditedBytes) < this.world!.limits.windowBytes) return;
    this.creditedBytes = this.takenBytes;
    this.send(creditFrame(this.takenBytes));
  }

  private handleUnchanged({ id, key, revision, hash }: Message<'unchanged'>): void {
    if (id !== 0) throw broken(`Unchanged as the answer to request ${id}, which knew of no chunk`);
    if (!this.tracker.shape?.covers(key)) return;
    this.backoff.reset();
    ++this.stats.unchangedChunks;
    const held = this.tracker.find(key);
    if (held !== undefined && revision < held.revision) return; // it crossed an edit
    if (held?.hash === hash) return this.tracker.confirm(held, revision);
    const kept = this.cache.find(keyName(key));
    if (kept?.hash !== hash) this.refetch(key);
    else this.deliver({ key, revision, hash, payload: kept.payload.slice(), material: null });
  }

  /** The revision says whether it is news, and whether it applies to what is here. Where it does not, or what is here was
   *  not kept, the chunk is asked for: that is always right. */
  private handleEditBroadcast({ key, revision, previousRevision, runs }: Message<'edit_broadcast'>): void {
    const held = this.tracker.find(key);
    this.edits.saw(revision);
    if (held === undefined || revision <= held.revision) return;
    const payload = held.material === null ? this.cache.find(keyName(key)) : uniformPayload(held.material);
    const isHeld = payload instanceof Uint8Array || (payload !== undefined && payload.hash === held.hash);
    if (!isHeld || runs.length === 0 || previousRevision > held.revision) {
      this.refetch(key);
      return;
    }
    const edited = new Uint16Array(CHUNK_VOLUME);
    const before = decodeChunk(payload instanceof Uint8Array ? payload : payload!.payload, { into: edited });
    if (before.voxels === null) edited.fill(before.uniform);
    readRuns(runs, (first, end, material) => edited.fill(material, first, end));
    const after = encodeChunk({ uniform: null, voxels: edited });
    const chunk: Chunk = { key, revision, hash: hashVoxels({ uniform: null, voxels: edited }), payload: after, material: materialOf(after) };
    this.keep(chunk);
    this.deliver(chunk);
  }

  /** So that it can be told by its hash, and changed by what is broadcast. */
  private keep({ key, revision, hash, payload, material }: Chunk): void {
    if (material === null && hash !== null) this.cache.put(keyName(key), { key, revision, hash, payload });
    else this.cache.erase(keyName(key));
  }

  private handleUniformColumn({ x, z, lod, revision, runs }: Message<'uniform_column'>): void {
    for (const run of runs) {
      const payload = this.uniformPayload(run.material);
      const shape = this.tracker.shape;
      if (shape === null) return;
      // A run may name 2^32 rows: only those of the View count.
      const rows = shape.rows(lod, x, z);
      const last = Math.min(rows.last, run.lastY);
      for (let y = Math.max(rows.first, run.firstY); y <= last; ++y) {
        this.backoff.reset();
        this.deliver({ key: { lod, x, y, z }, revision, hash: null, payload: payload.slice(), material: run.material });
        if (!this.connected) return; // a handler closed the client
      }
    }
  }

  private uniformPayload(material: number): Uint8Array<ArrayBuffer> {
    let payload = this.uniform.get(material);
    if (payload === undefined) {
      if (!this.world!.materials.some(({ id }) => id === material)) {
        throw broken(`a UniformColumn of material ${material}, which is not in Welcome`);
      }
      payload = uniformPayload(material);
      this.uniform.set(material, payload);
    }
    return payload;
  }

  private handleViewComplete({ number }: Message<'view_complete'>): void {
    if (number !== this.viewNumber || this.viewToSend || this.tracker.view === null) return; // one replaced since
    this.completeToTell = true;
    // Sent, but while a View that the server then refused did not have it.
    for (const key of this.tracker.missing()) this.refetch(key);
    this.tellCompleteIfWhole();
  }

  private tellCompleteIfWhole(): void {
    if (!this.completeToTell || this.refetching.size > 0 || !this.connected) return;
    this.completeToTell = false;
    this.tellComplete();
  }

  private handleHeights({ id, heightsFx, looks, values }: Message<'heights'>): void {
    const request = this.requests.find(id);
    const count = heightsFx.length;
    if (request?.kind !== 'places' || request.columns.length !== count) {
      throw broken(`${count} heights as the answer to request ${id}, which did not ask for them`);
    }
    if (looks.length !== (request.looks ? count : 0) || values.length !== count * request.fields.length) {
      throw broken(`${looks.length} looks and ${values.length} values of ${count} columns for request ${id}`);
    }
    if (looks.some((look) => look >= this.world!.looks.length)) throw broken('a look that is not in Welcome');
    this.requests.take(id);
    this.backoff.reset();
    request.resolve({
      heightsFx,
      looks: request.looks ? looks : null,
      values: request.fields.length > 0 ? values : null,
    });
    this.sendRequests();
  }

  private handlePong({ nonce }: Message<'pong'>): void {
    const ping = this.pings.get(nonce);
    if (ping === undefined) throw broken('a Pong that no Ping asked for');
    this.pings.delete(nonce);
    this.stats.latencyMs = performance.now() - ping.sent;
    ping.resolve(this.stats.latencyMs);
  }

  private handleGoAway({ reason, retryAfterMs }: Message<'go_away'>): void {
    this.leaving = new TalusError('disconnected', `the server goes away: ${reason}`, retryAfterMs);
  }

  private handleFatal(message: Message<'error'>): void {
    this.leaving = errorOf(message);
    this.drop(this.leaving);
  }

  private handleError(message: Message<'error'>): void {
    const error = errorOf(message);
    const comesBack = message.code === 'overloaded' && message.retryAfterMs > 0;
    if (comesBack) this.pace.refused(message.retryAfterMs, performance.now());
    // A server that leaves takes nothing any more: what it did not take goes to the next.
    const waits = message.code === 'overloaded' && (comesBack || this.leaving !== null);
    switch (message.about) {
      case 'request':
        if (message.requestId >= EDIT_ID_BIT) {
          this.edits.editRefused(message, error, waits);
          return this.sendRequests();
        }
        if (this.requests.find(message.requestId) === undefined) {
          throw broken(`an Error about request ${message.requestId}, which is not in flight`);
        }
        if (waits) this.requests.putBack(message.requestId);
        else this.requests.take(message.requestId)!.reject(error);
        this.sendRequests();
        return;
      case 'view':
        if (message.viewNumber !== this.viewNumber) return;
        if (comesBack) this.viewToSend = true;
        else this.emit('error', error);
        this.sendRequests();
        return;
      case 'attach':
        this.edits.attachRefused(error, waits);
        return this.sendRequests();
      case 'view_chunk':
        if (message.chunk !== null && this.tracker.shape?.covers(message.chunk)) this.refetch(message.chunk);
        return;
      case 'ping': {
        // Pings are answered in their order.
        const [oldest] = this.pings.entries();
        if (oldest === undefined) return;
        this.pings.delete(oldest[0]);
        oldest[1].reject(error);
        return;
      }
      case 'connection':
        this.leaving = error; // the close that follows tells
        return;
      default:
        this.emit('error', error);
    }
  }

  // ---- what the application asks

  protected viewApplied(): void {
    this.completeToTell = false;
    this.viewToSend = true;
    this.viewNumber = (this.viewNumber % 0xffffffff) + 1;
    this.sendRequests();
  }

  private sendView(): void {
    const { view } = this.tracker;
    this.viewToSend = false;
    if (view === null) {
      const nowhere = { centre: { x: NOWHERE, y: 0, z: 0 }, horizontalRadius: 0, verticalRadius: 0 };
      this.send(viewFrame(nowhere, this.viewNumber, []));
      return;
    }
    const room = (this.world!.limits.frameBytes - 2 * REST_BYTES) / KNOWN_CHUNK_BYTES;
    const known: KnownChunk[] = [];
    for (const [, { key, hash }] of this.cache.entries()) {
      if (known.length >= Math.min(room, MAX_KNOWN)) break;
      if (this.tracker.shape!.covers(key)) known.push({ key, hash });
    }
    this.send(viewFrame(view, this.viewNumber, known));
  }

  getChunk(key: ChunkKey): Promise<Chunk> {
    return new Promise((resolve, reject) => {
      checkKey(key);
      this.ask({ kind: 'chunk', key: { ...key }, resolve, reject });
    });
  }

  getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    wanted: { readonly looks?: boolean; readonly fields?: readonly string[] } = {},
  ): Promise<Places> {
    return new Promise((resolve, reject) => {
      for (const { x, z } of columns) {
        if (Number.isSafeInteger(x) && Number.isSafeInteger(z)) continue;
        throw new TalusError('out_of_range', `column ${x}, ${z}: its coordinates must be whole numbers`);
      }
      const { looks = false, fields = [] } = wanted;
      this.ask({ kind: 'places', columns: [...columns], looks, fields: [...fields], resolve, reject });
    });
  }

  edit(edit: Edit): Promise<EditDone> {
    if (this.isClosed) return Promise.reject(this.closedError());
    return this.edits.edit(edit, this.connected ? this.world : null);
  }

  editLimits(): Promise<EditLimits> {
    if (this.isClosed) return Promise.reject(this.closedError());
    return this.edits.askLimits(this.connected ? this.world : null);
  }

  private ask(request: Parameters<Requests['add']>[0]): void {
    if (this.isClosed) throw this.closedError();
    this.requests.add(request);
    // Soon, so that requests that are made together go together.
    if (this.connected) this.sendLater(0);
  }

  /** Asks anew for a chunk of the View. */
  private refetch(key: ChunkKey): void {
    const name = keyName(key);
    if (this.refetching.has(name)) return void this.refetching.set(name, true);
    this.refetching.set(name, false);
    this.getChunk(key).then(
      (chunk) => {
        const again = this.refetching.get(name) ?? false;
        this.refetching.delete(name);
        const before = this.tracker.find(key)?.revision ?? -1n;
        if (this.tracker.shape?.covers(key) && chunk.revision >= before) this.keep(chunk);
        const given = this.deliver(chunk);
        if (!given || !this.options.manualCredit) this.taken(chunk);
        if (again && this.connected && this.tracker.has(key)) this.refetch(key);
        this.tellCompleteIfWhole();
      },
      (error: TalusError) => {
        this.refetching.delete(name);
        if (this.isClosed) return;
        if (this.tracker.shape?.covers(key)) this.emit('error', error);
        this.tellCompleteIfWhole();
      },
    );
  }

  private sendLater(milliseconds: number): void {
    if (this.sendTimer !== undefined) {
      if (milliseconds > 0) return;
      clearTimeout(this.sendTimer);
    }
    this.sendTimer = setTimeout(() => {
      this.sendTimer = undefined;
      this.sendRequests();
    }, milliseconds);
  }

  /** Sends what the server's limits and rates allow. */
  private sendRequests(): void {
    if (!this.connected || this.leaving !== null) return;
    const { limits } = this.world!;
    const room = limits.frameBytes - 2 * REST_BYTES;
    let chunks: ChunkRequest[] = [];
    const flush = () => {
      if (chunks.length > 0) this.send(getChunksFrame(chunks));
      chunks = [];
    };
    for (;;) {
      const wait = this.pace.wait(performance.now());
      const next = this.requests.peek();
      const hasNext = next !== undefined && this.requests.inFlightCount < limits.requestsInFlight;
      if (!this.viewToSend && !hasNext && !this.edits.hasNext) break;
      if (wait > 0) {
        this.sendLater(wait);
        break;
      }
      this.pace.take();
      if (this.viewToSend) {
        this.sendView();
        continue;
      }
      if (this.edits.hasNext) {
        const frame = this.edits.next(limits.frameBytes);
        if (frame !== null) this.send(frame);
        continue;
      }
      const { id, request } = this.requests.next()!;
      if (request.kind === 'chunk') {
        chunks.push({ id, key: request.key, known: null });
        if (CHUNK_REQUEST_BYTES * (chunks.length + 1) > room) flush();
        continue;
      }
      flush();
      const most = Math.min(limits.heightsPerRequest, Math.floor(room / COLUMN_BYTES));
      const fields = request.fields.map((name) => this.world!.fields.indexOf(name));
      if (request.columns.length > most) {
        const count = request.columns.length;
        this.requests.take(id)!.reject(new TalusError('out_of_range', `${count} columns; this server takes ${most}`));
      } else if (fields.includes(-1)) {
        const name = request.fields[fields.indexOf(-1)];
        const known = this.world!.fields.join(', ');
        this.requests.take(id)!.reject(new TalusError('out_of_range', `no field ${name} here; there are: ${known}`));
      } else {
        this.send(getHeightsFrame(id, request.columns, request.looks, fields));
      }
    }
    flush();
  }

  ping(): Promise<number> {
    return new Promise((resolve, reject) => {
      if (!this.connected) throw new TalusError('disconnected', 'ping: the client is not connected');
      this.pace.take();
      this.pings.set(BigInt(++this.lastNonce), { sent: performance.now(), resolve, reject });
      this.send(pingFrame(this.lastNonce));
    });
  }
}

function errorOf({ code, text, retryAfterMs }: Message<'error'>): TalusError {
  const said = `the server says: ${text}`;
  switch (code) {
    case 'version':
    case 'unauthorized':
    case 'forbidden':
    case 'unsupported':
      return new TalusError('refused', said);
    case 'malformed':
    case 'unexpected':
      return new TalusError('broken_protocol', said);
    case 'too_large':
    case 'too_many_requests':
    case 'out_of_range':
      return new TalusError('out_of_range', said);
    case 'overloaded':
      return new TalusError('overloaded', said, retryAfterMs);
    case 'cancelled':
      return new TalusError('cancelled', said);
    case 'conflict':
    case 'not_applied':
      return new TalusError(code, said);
    case 'timeout':
      return new TalusError('timed_out', said);
    default:
      return new TalusError('server_failed', said, retryAfterMs);
  }
}
