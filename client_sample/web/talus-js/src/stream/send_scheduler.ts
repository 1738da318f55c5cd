// Order of sending: a View before edits, edits before requests, each when the server's limits and rates allow.
import type { EditSession } from '../edits/session.js';
import { TalusError } from '../errors.js';
import type { World } from '../types.js';
import {
  CHUNK_REQUEST_BYTES,
  type ChunkRequest,
  COLUMN_BYTES,
  getChunksFrame,
  getHeightsFrame,
  REST_BYTES,
} from '../wire/write.js';
import type { Pace } from './pace.js';
import type { PendingPlaces, Requests } from './requests.js';

export interface Sender {
  /** The world of a server that accepts requests now; null: not connected. */
  openWorld(): World | null;
  send(frame: Uint8Array): void;
  sendView(): void;
}

export class SendScheduler {
  viewWaits = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly sender: Sender,
    private readonly pace: Pace,
    private readonly requests: Requests,
    private readonly edits: EditSession,
  ) {}

  /** The connection ended. */
  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.viewWaits = false;
  }

  later(milliseconds: number): void {
    if (this.timer !== undefined) {
      if (milliseconds > 0) return;
      clearTimeout(this.timer);
    }
    this.timer = setTimeout(() => {
      this.timer = undefined;
      this.now();
    }, milliseconds);
  }

  now(): void {
    const world = this.sender.openWorld();
    if (world === null) return;
    const { limits } = world;
    const room = limits.frameBytes - 2 * REST_BYTES;
    let chunks: ChunkRequest[] = [];
    const flush = () => {
      if (chunks.length > 0) this.sender.send(getChunksFrame(chunks));
      chunks = [];
    };
    for (;;) {
      const wait = this.pace.wait(performance.now());
      const hasNext = this.requests.peek() !== undefined && this.requests.inFlightCount < limits.requestsInFlight;
      if (!this.viewWaits && !hasNext && !this.edits.hasNext) break;
      if (wait > 0) {
        this.later(wait);
        break;
      }
      this.pace.take();
      if (this.viewWaits) {
        this.viewWaits = false;
        this.sender.sendView();
        continue;
      }
      if (this.edits.hasNext) {
        const frame = this.edits.next(limits.frameBytes);
        if (frame !== null) this.sender.send(frame);
        continue;
      }
      const { id, request } = this.requests.next()!;
      if (request.kind === 'chunk') {
        chunks.push({ id, key: request.key, known: request.known });
        if (CHUNK_REQUEST_BYTES * (chunks.length + 1) > room) flush();
      } else {
        flush();
        this.askPlaces(world, room, id, request);
      }
    }
    flush();
  }

  private askPlaces({ limits, fields: known }: World, room: number, id: number, request: PendingPlaces): void {
    const reject = (text: string) => this.requests.take(id)!.reject(new TalusError('out_of_range', text));
    const most = Math.min(limits.heightsPerRequest, Math.floor(room / COLUMN_BYTES));
    const fields = request.fields.map((name) => known.indexOf(name));
    if (request.columns.length > most) {
      reject(`${request.columns.length} columns; this server takes ${most}`);
    } else if (fields.includes(-1)) {
      reject(`no field ${request.fields[fields.indexOf(-1)]} here; there are: ${known.join(', ')}`);
    } else {
      this.sender.send(getHeightsFrame(id, request.columns, request.looks, fields));
    }
  }
}
