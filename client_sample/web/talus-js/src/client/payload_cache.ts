// Payloads of chunks that a client may need again, so that only their hashes are sent.
import type { ChunkKey } from '../types.js';

export interface KeptPayload {
  readonly key: ChunkKey;
  readonly revision: bigint;
  readonly hash: string;
  readonly payload: Uint8Array<ArrayBuffer>;
}

/** Approximate overhead of an entry. */
const BOOKKEEPING_BYTES = 200;

/** Holds about `maxBytes`; evicts the least recently used. */
export class PayloadCache {
  private readonly kept = new Map<string, KeptPayload>();
  private bytes = 0;

  constructor(private readonly maxBytes: number) {}

  get size(): number {
    return this.kept.size;
  }

  /** Keeps a copy. */
  put(name: string, chunk: KeptPayload): void {
    this.erase(name);
    this.kept.set(name, { ...chunk, payload: chunk.payload.slice() });
    this.bytes += chunk.payload.length + BOOKKEEPING_BYTES;
    for (const oldest of this.kept.keys()) {
      if (this.bytes <= this.maxBytes) break;
      this.erase(oldest);
    }
  }

  find(name: string): KeptPayload | undefined {
    return this.kept.get(name);
  }

  erase(name: string): void {
    const chunk = this.kept.get(name);
    if (chunk === undefined) return;
    this.kept.delete(name);
    this.bytes -= chunk.payload.length + BOOKKEEPING_BYTES;
  }

  clear(): void {
    this.kept.clear();
    this.bytes = 0;
  }

  entries(): Iterable<[string, KeptPayload]> {
    return this.kept;
  }
}
