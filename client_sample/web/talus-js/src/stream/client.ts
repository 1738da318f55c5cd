// A client over a stream of frames: PROTOCOL.md from "States" on.
import { ClientBase } from '../client/base.js';
import { EDIT_ID_BIT } from '../edits/open_edits.js';
import { EditSession } from '../edits/session.js';
import { TalusError } from '../errors.js';
import { checkColumns, checkKey, keyName, sameKey } from '../keys.js';
import type { Chunk, ChunkKey, ConnectOptions, Edit, EditDone, EditLimits, Places } from '../types.js';
import { shownUrl, urlsOf } from '../url.js';
import type { ViewShape } from '../view_shape.js';
import { FrameReader } from '../wire/frames.js';
import { readMessage, type ServerMessage } from '../wire/messages.js';
import { broken } from '../wire/table.js';
import { creditFrame, helloFrame, KNOWN_CHUNK_BYTES, pingFrame, REST_BYTES, viewFrame } from '../wire/write.js';
import { BaseMaking } from './base_making.js';
import { Credit } from './credit.js';
import { KeptChunks } from './kept_chunks.js';
import { Pace } from './pace.js';
import { Pings } from './pings.js';
import { Requests } from './requests.js';
import { SendScheduler } from './send_scheduler.js';
import { errorOf } from './server_error.js';
import type { OpenTransport, Transport } from './transport.js';
import { chunkOf, ViewContents } from './view_contents.js';

const PROTOCOL = 2;
const CODEC = 4;
const MAX_TEXT_BYTES = 4_096; // for token and client in Hello
const DEFAULT_WINDOW_BYTES = 1 << 20;
const DEFAULT_KEEP_BYTES = 16 << 20;
const DEFAULT_CONNECT_TIMEOUT_MS = 10_000;
const PING_INTERVAL_MS = 20_000;
/** Applied whatever a server's idle timeout is. */
const SHORTEST_PING_INTERVAL_MS = 5;
const SILENCE_MS = 60_000;
/** A server ignores further known chunks in a View; this number fits any frame. */
const MAX_KNOWN = 8_192;
/** Far outside every world: a View without chunks. */
const NOWHERE = 2 ** 40;

type Message<K extends ServerMessage['kind']> = Extract<ServerMessage, { kind: K }>;

export class StreamClient extends ClientBase {
  private transport: Transport | null = null;
  private connection = 0; // counts attempts
  private reader = new FrameReader();
  private readonly requests = new Requests();
  private readonly pace = new Pace();
  private readonly kept: KeptChunks;
  private readonly pings = new Pings();
  private readonly credit = new Credit();
  private viewNumber = 0;
  /** The shape of the server's View; null: no View, or unknown. */
  private sentShape: ViewShape | null = null;
  private readonly contents: ViewContents;
  private readonly edits = new EditSession(() => this.connected && this.sending.later(0));
  private readonly sending = new SendScheduler(
    {
      openWorld: () => (this.connected && this.leaving === null ? this.world : null),
      send: (frame) => this.send(frame),
      sendView: () => this.sendView(),
    },
    this.pace,
    this.requests,
    this.edits,
  );
  private readonly base: BaseMaking;
  private leaving: TalusError | null = null; // since GoAway, or an Error that ends the connection
  private heardAt = 0;
  private deadline: ReturnType<typeof setTimeout> | undefined;
  private heartbeat: ReturnType<typeof setInterval> | undefined;

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
    this.kept = new KeptChunks(options.keepBytes ?? DEFAULT_KEEP_BYTES);
    this.contents = new ViewContents(this.tracker, this.kept, {
      world: () => (this.connected ? this.world : null),
      isClosed: () => this.isClosed,
      served: () => this.backoff.reset(),
      deliver: (chunk) => this.deliver(chunk),
      settle: (chunk, given) => this.settle(chunk, given),
      getChunk: (key) => this.getChunk(key),
      failed: (error) => this.emit('error', error),
      countUnchanged: () => void ++this.stats.unchangedChunks,
      tellComplete: () => {
        this.tellComplete();
        this.base.viewIsWhole();
      },
    });
    this.base = new BaseMaking(options, this.tracker, {
      world: () => (this.connected ? this.world : null),
      isViewWhole: () => this.contents.isToldWhole,
      deliver: (chunk) => {
        const given = this.deliver(chunk);
        if (given) ++this.stats.madeChunks;
        if (chunk.hash !== null) this.contents.keep(chunk);
        this.settle(chunk, given);
      },
      refetch: (key) => this.contents.refetch(key),
      compare: (key, known) => this.compare(key, known),
      askAgain: () => {
        if (this.connected && this.tracker.view !== null) this.viewApplied();
      },
      whole: () => this.contents.viewComplete(),
      failed: (error) => this.emit('error', error),
    });
    this.attempt();
  }

  // ---- the connection

  protected attempt(): void {
    const connection = ++this.connection;
    const isCurrent = () => connection === this.connection && !this.isClosed;
    this.reader = new FrameReader();
    this.credit.begin();
    this.leaving = null;
    const timeout = this.options.connectTimeoutMs ?? DEFAULT_CONNECT_TIMEOUT_MS;
    this.deadline = setTimeout(() => {
      this.drop(new TalusError('timed_out', `no answer from ${urlsOf(this.options.url).map(shownUrl).join(', ')} within ${timeout / 1_000} s: it is away, or this program is too busy`));
    }, timeout);
    try {
      this.transport = this.open({
        opened: () => isCurrent() && this.sayHello(),
        received: (bytes) => isCurrent() && this.receive(bytes, isCurrent),
        ended: (error) => isCurrent() && this.drop(this.leaving ?? error),
      });
    } catch (error) {
      // A page by https may not open ws:, and TLS rejects wrong options: another attempt would fail alike.
      const refused = new TalusError('refused', `the connection cannot be opened: ${(error as Error).message}`);
      queueMicrotask(() => isCurrent() && this.drop(refused));
    }
  }

  private sayHello(): void {
    this.send(
      helloFrame({
        protocolMin: PROTOCOL,
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
    if (wasJoined) this.pings.failAll(error);
    this.lost(error);
  }

  private disconnect(): void {
    ++this.connection; // ignore further events of the transport
    clearTimeout(this.deadline);
    clearInterval(this.heartbeat);
    this.sending.stop();
    this.transport?.close();
    this.transport = null;
    this.contents.stop();
    this.sentShape = null;
    this.base.disconnected();
    this.requests.putAllBack();
    this.edits.connectionEnded();
  }

  protected stopped(): void {
    this.disconnect();
    this.base.end();
    const error = this.closedError();
    this.pings.failAll(error);
    this.requests.failAll(error);
    this.edits.failAll(error);
    this.kept.clear();
  }

  private receive(bytes: Uint8Array, isCurrent: () => boolean): void {
    this.stats.receivedBytes += bytes.length;
    this.heardAt = performance.now();
    try {
      this.reader.push(bytes, (frame) => {
        if (isCurrent()) this.handle(readMessage(frame), frame.length);
      });
    } catch (error) {
      if (!(error instanceof TalusError)) throw error;
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
        return this.contents.uniformColumn(message);
      case 'view_complete':
        return this.handleViewComplete(message);
      case 'heights':
        return this.handleHeights(message);
      case 'error':
        return this.handleError(message);
      case 'edit_broadcast':
        this.edits.saw(message.revision);
        if (this.base.edited(message)) return;
        return this.contents.editBroadcast(message);
      case 'edit_result':
        this.backoff.reset();
        this.edits.handleResult(message);
        return this.sending.now();
      case 'attached':
        this.backoff.reset();
        this.edits.handleAttached(message);
        return this.sending.now();
      case 'pong':
        return this.handlePong(message);
      case 'go_away':
        return this.handleGoAway(message);
      default:
        throw broken(`an unexpected ${message.kind}`);
    }
  }

  private handleWelcome({ world }: Message<'welcome'>): void {
    if (world.protocol !== PROTOCOL || world.codec !== CODEC) {
      throw broken(`a Welcome for protocol ${world.protocol} and codec ${world.codec}, which were not offered`);
    }
    clearTimeout(this.deadline);
    this.pace.begin(world.limits, performance.now());
    this.joined(world);
  }

  protected worldKnown(sameWorld: boolean): void {
    if (!sameWorld) this.kept.clear();
    this.edits.joined(this.world!, sameWorld);
    this.base.joined(this.world!, sameWorld);
    const idle = this.world!.limits.idleTimeoutMs || PING_INTERVAL_MS * 3;
    this.heardAt = performance.now();
    this.heartbeat = setInterval(() => this.beat(), Math.max(SHORTEST_PING_INTERVAL_MS, Math.min(PING_INTERVAL_MS, idle / 3)));
    this.sending.now();
  }

  private beat(): void {
    const silent = performance.now() - this.heardAt;
    if (silent > SILENCE_MS) {
      this.drop(new TalusError('timed_out', `the server said nothing for ${Math.round(silent / 1_000)} s`));
      return;
    }
    if (!this.pings.isEmpty) return; // it is not idle
    this.ping().catch(() => {}); // the connection's end is reported elsewhere
  }

  private handleChunk(message: Message<'chunk'>, frameBytes: number): void {
    const { id, key } = message;
    this.stats.chunkBytes += frameBytes;
    const chunk = chunkOf(message);
    this.credit.owe(chunk, frameBytes);
    this.edits.saw(chunk.revision);
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
      this.sending.now();
    } else {
      this.base.came(chunk);
      given = this.contents.chunk(chunk);
    }
    this.settle(chunk, given);
  }

  private settle(chunk: Chunk, given: boolean): void {
    if (!given || !this.options.manualCredit) this.taken(chunk);
  }

  taken(chunk: Chunk): void {
    if (!this.connected) return;
    const sum = this.credit.taken(chunk, this.world!.limits.windowBytes);
    if (sum !== null) this.send(creditFrame(sum));
  }

  private handleViewComplete({ number }: Message<'view_complete'>): void {
    if (number !== this.viewNumber || this.sending.viewWaits || this.tracker.view === null) return; // replaced
    if (!this.base.serverIsDone()) this.contents.viewComplete();
  }

  private handleUnchanged(message: Message<'unchanged'>): void {
    const request = message.id === 0 ? undefined : this.requests.find(message.id);
    if (request?.kind !== 'chunk' || request.known === null) return this.contents.unchanged(message);
    if (!sameKey(request.key, message.key) || request.known !== message.hash) throw broken(`Unchanged for another chunk than request ${message.id} knew`);
    this.requests.take(message.id);
    this.backoff.reset();
    request.unchanged!();
    this.sending.now();
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
    this.sending.now();
  }

  private handlePong({ nonce }: Message<'pong'>): void {
    const took = this.pings.answered(nonce, performance.now());
    if (took === null) throw broken('a Pong that no Ping asked for');
    this.stats.latencyMs = took;
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
    // A departing server accepts nothing more: whatever it refused goes to the next.
    const waits = message.code === 'overloaded' && (comesBack || this.leaving !== null);
    switch (message.about) {
      case 'request':
        if (message.requestId >= EDIT_ID_BIT) {
          this.edits.editRefused(message, error, waits);
          return this.sending.now();
        }
        if (this.requests.find(message.requestId) === undefined) {
          throw broken(`an Error about request ${message.requestId}, which is not in flight`);
        }
        if (waits) this.requests.putBack(message.requestId);
        else this.requests.take(message.requestId)!.reject(error);
        this.sending.now();
        return;
      case 'view':
        this.sentShape = null; // the server's View is unknown
        if (message.viewNumber !== this.viewNumber) return;
        if (comesBack) this.sending.viewWaits = true;
        else this.emit('error', error);
        this.sending.now();
        return;
      case 'attach':
        this.edits.attachRefused(error, waits);
        return this.sending.now();
      case 'view_chunk':
        if (message.chunk !== null && this.tracker.shape?.covers(message.chunk)) this.contents.refetch(message.chunk);
        return;
      case 'ping':
        this.pings.refuseOldest(error);
        return;
      case 'connection':
        this.leaving = error; // the close that follows reports it
        return;
      default:
        this.emit('error', error);
    }
  }

  // ---- the application's requests

  protected viewApplied(): void {
    this.contents.viewApplied();
    this.sending.viewWaits = true;
    this.viewNumber = (this.viewNumber % 0xffffffff) + 1;
    this.base.viewApplied();
    this.sending.now();
  }

  private sendView(): void {
    const { view, shape } = this.tracker;
    const before = this.sentShape;
    this.sentShape = view === null ? null : shape;
    if (view === null) {
      const nowhere = { centre: { x: NOWHERE, y: 0, z: 0 }, horizontalRadius: 0, verticalRadius: 0 };
      this.send(viewFrame(nowhere, this.viewNumber, []));
      return;
    }
    const room = (this.world!.limits.frameBytes - 2 * REST_BYTES) / KNOWN_CHUNK_BYTES;
    const known = this.kept.known(Math.min(room, MAX_KNOWN), shape!, before);
    this.send(viewFrame(view, this.viewNumber, known, this.base.isOn));
  }

  getChunk(key: ChunkKey): Promise<Chunk> {
    return new Promise((resolve, reject) => {
      checkKey(key);
      this.ask({ kind: 'chunk', key: { ...key }, known: null, resolve, reject });
    });
  }

  /** Resolves with null if the server's chunk has the hash `known`, else with the chunk. */
  private compare(key: ChunkKey, known: string): Promise<Chunk | null> {
    ++this.stats.proofs;
    return new Promise((resolve, reject) => this.ask({ kind: 'chunk', key, known, resolve, unchanged: () => resolve(null), reject }));
  }

  getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    wanted: { readonly looks?: boolean; readonly fields?: readonly string[] } = {},
  ): Promise<Places> {
    return new Promise((resolve, reject) => {
      checkColumns(columns);
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
    // Deferred, so that requests made together are sent together.
    if (this.connected) this.sending.later(0);
  }

  ping(): Promise<number> {
    return new Promise((resolve, reject) => {
      if (!this.connected) throw new TalusError('disconnected', 'ping: the client is not connected');
      this.pace.take();
      this.send(pingFrame(this.pings.add(performance.now(), resolve, reject)));
    });
  }
}
