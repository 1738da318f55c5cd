// Bytes of chunks with which the application is done, and which the server may send again. PROTOCOL.md, "Flow control".
import type { Chunk } from '../types.js';

interface Debt {
  readonly connection: number;
  readonly bytes: number;
}

export class Credit {
  private readonly debts = new WeakMap<Chunk, Debt>();
  private connection = 0; // connection number: chunks of earlier connections are not credited
  private takenBytes = 0;
  private creditedBytes = 0;

  /** A connection begins. */
  begin(): void {
    ++this.connection;
    this.takenBytes = this.creditedBytes = 0;
  }

  owe(chunk: Chunk, bytes: number): void {
    this.debts.set(chunk, { connection: this.connection, bytes });
  }

  /** The total to send to the server after half a window; null: not yet. */
  taken(chunk: Chunk, windowBytes: number): number | null {
    const debt = this.debts.get(chunk);
    if (debt === undefined) return null;
    this.debts.delete(chunk);
    if (debt.connection !== this.connection) return null;
    this.takenBytes += debt.bytes;
    if (2 * (this.takenBytes - this.creditedBytes) < windowBytes) return null;
    return (this.creditedBytes = this.takenBytes);
  }
}
