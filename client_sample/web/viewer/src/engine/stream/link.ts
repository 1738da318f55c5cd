// The connection to the server, recreated on demand. Events of earlier clients are ignored.
import { connect, type Chunk, type ChunkKey, type Client, type TalusError, type World } from 'talus';
import type { EngineOptions } from '../api.js';

export interface LinkEvents {
  connected(world: World, sameWorld: boolean): void;
  chunk(chunk: Chunk): void;
  left(key: ChunkKey): void;
  viewComplete(): void;
  /** It reconnects by itself, unless `refused`. */
  lost(text: string, refused: boolean): void;
  error(text: string): void;
}

export class Link {
  client!: Client;
  /** The client gave up: only a new client connects. */
  private hasEnded = false;
  private isClosed = false;
  private readonly untaken: Chunk[] = [];

  /** `isFull`: no more chunks are wanted for now, so no chunks are credited to the server. */
  constructor(
    private readonly options: Pick<EngineOptions, 'url' | 'transport' | 'source'>,
    private readonly events: LinkEvents,
    private readonly isFull: () => boolean,
  ) {}

  /** Resolves when the server has described its world; a later end is reported only by events. */
  open(token: string | undefined): Promise<World> {
    const client = this.options.source?.() ?? this.connected(token);
    this.client = client;
    this.hasEnded = false;
    const { events } = this;
    const current = () => client === this.client && !this.isClosed;
    client.on('connected', (world, sameWorld) => current() && events.connected(world, sameWorld));
    client.on('chunk', (chunk) => {
      if (!current()) return;
      events.chunk(chunk);
      if (this.isFull()) this.untaken.push(chunk);
      else client.taken(chunk);
    });
    client.on('chunkLeft', (key) => current() && events.left(key));
    client.on('viewComplete', () => current() && events.viewComplete());
    client.on('disconnected', (error, retryInMs) => {
      if (current() && retryInMs !== null) events.lost(error.message, false);
    });
    client.on('error', (error) => current() && events.error(error.message));
    client.on('closed', (error: TalusError | null) => {
      if (!current()) return;
      this.hasEnded = true;
      if (error !== null) events.lost(error.message, error.kind === 'refused');
    });
    const joined = client.ready();
    joined.catch(() => {}); // `closed` reports it too
    return joined;
  }

  private connected(token: string | undefined): Client {
    const url = new URL(this.options.url);
    if (this.options.transport === 'websocket') url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    return connect({ url: url.href, token, clientName: 'talus-viewer', manualCredit: true, generate: 'auto' });
  }

  /** Makes the next attempt at once; false: there is nothing to try. */
  hurry(): boolean {
    if (!this.hasEnded) this.client.retry();
    return !this.hasEnded;
  }

  takeBacklog(): void {
    while (this.untaken.length > 0 && !this.isFull()) this.client.taken(this.untaken.shift()!);
  }

  close(): void {
    this.isClosed = true;
    this.client.close();
  }

  /** Closes this client for good. */
  drop(): void {
    this.client.close();
  }
}
