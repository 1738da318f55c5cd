// Compares chunks that were made here with the server's: some at first, then one in a thousand.
import { decodeChunk } from '../decode.js';
import { hashVoxels } from '../hash.js';
import type { Chunk, ChunkKey } from '../types.js';

const AT_FIRST = 16;
const INTERVAL = 1_000;

export class Proofs {
  private left = 0;
  private since = 0;

  constructor(
    private readonly compare: (key: ChunkKey, hash: string) => Promise<Chunk | null>,
    private readonly differs: (key: ChunkKey) => void,
  ) {}

  /** A server joined: it is another one, perhaps. */
  begin(): void {
    this.left = AT_FIRST;
    this.since = 0;
  }

  /** A mixed chunk as generated. Its payload is read, not kept. */
  made(key: ChunkKey, payload: Uint8Array): void {
    if (++this.since >= INTERVAL) {
      this.since = 0;
      ++this.left;
    }
    // The first ones lie close together: each other one is left out.
    if (this.left === 0 || (this.since & 1) === 0) return;
    --this.left;
    const hash = hashVoxels(decodeChunk(payload));
    this.compare(key, hash).then(
      (chunk) => {
        if (chunk === null || chunk.hash === hash) return;
        if (chunk.revision === 0n) this.differs(key);
        else ++this.left; // edited meanwhile: another one is compared
      },
      () => ++this.left, // refused, or the connection ended
    );
  }
}
