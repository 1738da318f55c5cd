// Collects the View's chunks, in whichever messages, until they are complete.
import type { Tracker } from '../client/tracker.js';
import type { TalusError } from '../errors.js';
import { keyName } from '../keys.js';
import type { Chunk, ChunkKey, World } from '../types.js';
import { materialOf, uniformPayload } from '../uniform.js';
import type { ServerMessage } from '../wire/messages.js';
import { broken } from '../wire/table.js';
import type { KeptChunks } from './kept_chunks.js';

type Message<K extends ServerMessage['kind']> = Extract<ServerMessage, { kind: K }>;

export interface Receiver {
  /** The world of the server joined; null: not joined. */
  world(): World | null;
  isClosed(): boolean;
  /** The server did something useful: reset the back-off. */
  served(): void;
  /** Returns true if the chunk was delivered to the application. */
  deliver(chunk: Chunk): boolean;
  /** Credits a chunk that was not delivered. */
  settle(chunk: Chunk, given: boolean): void;
  getChunk(key: ChunkKey): Promise<Chunk>;
  failed(error: TalusError): void;
  countUnchanged(): void;
  tellComplete(): void;
}

export class ViewContents {
  private completeToTell = false;
  /** True if the chunk changed again while it is in flight. */
  private readonly refetching = new Map<string, boolean>();
  private readonly uniform = new Map<number, Uint8Array<ArrayBuffer>>();

  constructor(
    private readonly tracker: Tracker,
    private readonly kept: KeptChunks,
    private readonly receiver: Receiver,
  ) {}

  /** The View was reported complete. */
  isToldWhole = false;

  keep(chunk: Chunk): void {
    this.kept.keep(chunk);
  }

  /** The connection ended. */
  stop(): void {
    this.refetching.clear();
    this.completeToTell = false;
  }

  /** Another View: completion of the previous one is not reported any more. */
  viewApplied(): void {
    this.completeToTell = this.isToldWhole = false;
  }

  /** Returns true if the chunk was delivered to the application. */
  chunk(chunk: Chunk): boolean {
    if (!this.tracker.shape?.covers(chunk.key)) return false;
    this.receiver.served();
    this.kept.keep(chunk);
    return this.receiver.deliver(chunk);
  }

  unchanged({ id, key, revision, hash }: Message<'unchanged'>): void {
    if (id !== 0) throw broken(`Unchanged as the answer to request ${id}, which knew of no chunk`);
    if (!this.tracker.shape?.covers(key)) return;
    this.receiver.served();
    this.receiver.countUnchanged();
    const held = this.tracker.find(key);
    if (held !== undefined && revision < held.revision) return; // crossed by an edit
    if (held?.hash === hash) return this.tracker.confirm(held, revision);
    const kept = this.kept.find(key, hash);
    if (kept === undefined) this.refetch(key);
    else this.receiver.deliver({ key, revision, hash, payload: kept.payload.slice(), material: null });
  }

  /** The revision shows whether the broadcast is new, and whether it applies to the held chunk. If it does not apply,
   *  or the chunk was not kept, the chunk is requested: that is always correct. */
  editBroadcast(message: Message<'edit_broadcast'>): void {
    const { key, revision } = message;
    const held = this.tracker.find(key);
    if (held === undefined || revision <= held.revision) return;
    const chunk = this.kept.edited(held, message);
    if (chunk === null) {
      this.refetch(key);
      return;
    }
    this.kept.keep(chunk);
    this.receiver.deliver(chunk);
  }

  uniformColumn({ x, z, lod, revision, runs }: Message<'uniform_column'>): void {
    for (const run of runs) {
      const payload = this.uniformPayload(run.material);
      const shape = this.tracker.shape;
      if (shape === null) return;
      // A run may cover 2^32 rows: only the View's rows count.
      const rows = shape.rows(lod, x, z);
      const last = Math.min(rows.last, run.lastY);
      for (let y = Math.max(rows.first, run.firstY); y <= last; ++y) {
        this.receiver.served();
        this.receiver.deliver({ key: { lod, x, y, z }, revision, hash: null, payload: payload.slice(), material: run.material });
        if (this.receiver.world() === null) return; // a handler closed the client
      }
    }
  }

  private uniformPayload(material: number): Uint8Array<ArrayBuffer> {
    let payload = this.uniform.get(material);
    if (payload === undefined) {
      if (!this.receiver.world()!.materials.some(({ id }) => id === material)) {
        throw broken(`a UniformColumn of material ${material}, which is not in Welcome`);
      }
      payload = uniformPayload(material);
      this.uniform.set(material, payload);
    }
    return payload;
  }

  /** The server sent everything. */
  viewComplete(): void {
    this.completeToTell = true;
    // Sent while a View, refused later, did not cover it.
    for (const key of this.tracker.missing()) {
      if (!this.refetching.has(keyName(key))) this.refetch(key);
    }
    this.tellCompleteIfWhole();
  }

  private tellCompleteIfWhole(): void {
    if (!this.completeToTell || this.refetching.size > 0 || this.receiver.world() === null) return;
    this.completeToTell = false;
    this.isToldWhole = true;
    this.receiver.tellComplete();
  }

  /** Requests a chunk of the View again. */
  refetch(key: ChunkKey): void {
    const name = keyName(key);
    if (this.refetching.has(name)) return void this.refetching.set(name, true);
    this.refetching.set(name, false);
    this.receiver.getChunk(key).then(
      (chunk) => {
        const again = this.refetching.get(name) ?? false;
        this.refetching.delete(name);
        const before = this.tracker.find(key)?.revision ?? -1n;
        if (this.tracker.shape?.covers(key) && chunk.revision >= before) this.kept.keep(chunk);
        this.receiver.settle(chunk, this.receiver.deliver(chunk));
        if (again && this.receiver.world() !== null && this.tracker.has(key)) this.refetch(key);
        this.tellCompleteIfWhole();
      },
      (error: TalusError) => {
        this.refetching.delete(name);
        if (this.receiver.isClosed()) return;
        if (this.tracker.shape?.covers(key)) this.receiver.failed(error);
        this.tellCompleteIfWhole();
      },
    );
  }
}

export function chunkOf({ key, revision, hash, payload }: Message<'chunk'>): Chunk {
  return { key, revision, hash, payload, material: materialOf(payload) };
}
