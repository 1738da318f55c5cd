// Unanswered requests: in flight, by id, or waiting for room in the server's limits.
import type { TalusError } from '../errors.js';
import type { Chunk, ChunkKey, Places } from '../types.js';

export interface PendingChunk {
  readonly kind: 'chunk';
  readonly key: ChunkKey;
  /** Hash of the chunk that is compared with the server's; null: the chunk is wanted. */
  readonly known: string | null;
  resolve(chunk: Chunk): void;
  /** The server has a chunk of the hash `known`. */
  unchanged?(): void;
  reject(error: TalusError): void;
}

export interface PendingPlaces {
  readonly kind: 'places';
  readonly columns: readonly { readonly x: number; readonly z: number }[];
  readonly looks: boolean;
  readonly fields: readonly string[];
  resolve(places: Places): void;
  reject(error: TalusError): void;
}

export type PendingRequest = PendingChunk | PendingPlaces;

export class Requests {
  private readonly inFlight = new Map<number, PendingRequest>();
  private waiting: PendingRequest[] = [];
  private lastId = 0;

  add(request: PendingRequest): void {
    this.waiting.push(request);
  }

  get inFlightCount(): number {
    return this.inFlight.size;
  }

  /** Moves the next request to in-flight; its id is below 2^31, unlike ids of edits. */
  next(): { id: number; request: PendingRequest } | null {
    const request = this.waiting.shift();
    if (request === undefined) return null;
    do this.lastId = (this.lastId % 0x7fffffff) + 1;
    while (this.inFlight.has(this.lastId));
    this.inFlight.set(this.lastId, request);
    return { id: this.lastId, request };
  }

  peek(): PendingRequest | undefined {
    return this.waiting[0];
  }

  find(id: number): PendingRequest | undefined {
    return this.inFlight.get(id);
  }

  take(id: number): PendingRequest | undefined {
    const request = this.inFlight.get(id);
    this.inFlight.delete(id);
    return request;
  }

  /** The server refused it temporarily. */
  putBack(id: number): void {
    const request = this.take(id);
    if (request !== undefined) this.waiting.unshift(request);
  }

  /** The connection ended: requests in flight must be sent again. */
  putAllBack(): void {
    this.waiting = [...this.inFlight.values(), ...this.waiting];
    this.inFlight.clear();
  }

  failAll(error: TalusError): void {
    this.putAllBack();
    const all = this.waiting;
    this.waiting = [];
    for (const request of all) request.reject(error);
  }
}
