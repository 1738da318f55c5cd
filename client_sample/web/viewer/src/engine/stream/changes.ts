// Changes of a worker's chunks, packed: sending thousands of small objects costs the page more than creating them.
import type { ChunkData } from './messages.js';

/** In order: a chunk may be added, dropped and added again. */
export interface Changes {
  /** For each: level, x, y, z, material or a constant below, bytes of its payload. */
  readonly table: Int32Array;
  readonly payloads: Uint8Array;
  /** For each payload. */
  readonly hashes: readonly (string | null)[];
}

const WIDTH = 6;
const PAYLOAD = -1;
const DROP = -2;

export class ChangeList {
  private readonly rows: number[] = [];
  private readonly payloads: Uint8Array[] = [];
  private hashes: (string | null)[] = [];
  private bytes = 0;

  get isEmpty(): boolean {
    return this.rows.length === 0;
  }

  add({ lod, x, y, z, payload, material, hash }: ChunkData): void {
    const bytes = material === null ? payload! : null;
    this.rows.push(lod, x, y, z, material ?? PAYLOAD, bytes?.length ?? 0);
    if (bytes === null) return;
    this.payloads.push(bytes);
    this.hashes.push(hash);
    this.bytes += bytes.length;
  }

  drop({ lod, x, y, z }: Pick<ChunkData, 'lod' | 'x' | 'y' | 'z'>): void {
    this.rows.push(lod, x, y, z, DROP, 0);
  }

  /** All changes since the last call; the buffers may be transferred. */
  take(): Changes {
    const payloads = new Uint8Array(this.bytes);
    let at = 0;
    for (const payload of this.payloads) {
      payloads.set(payload, at);
      at += payload.length;
    }
    const table = Int32Array.from(this.rows);
    const { hashes } = this;
    this.hashes = [];
    this.rows.length = this.payloads.length = this.bytes = 0;
    return { table, payloads, hashes };
  }
}

export function apply({ table, payloads, hashes }: Changes, to: { add(chunk: ChunkData): void; drop(chunk: Pick<ChunkData, 'lod' | 'x' | 'y' | 'z'>): void }): void {
  let end = 0;
  let taken = 0;
  for (let row = 0; row < table.length; row += WIDTH) {
    const [lod, x, y, z, material, bytes] = table.subarray(row, row + WIDTH) as unknown as [number, number, number, number, number, number];
    const start = end;
    end += bytes;
    if (material === DROP) to.drop({ lod, x, y, z });
    // A copy, so that a chunk does not keep others received with it.
    else if (material === PAYLOAD) to.add({ lod, x, y, z, payload: payloads.slice(start, end), material: null, hash: hashes[taken++] ?? null });
    else to.add({ lod, x, y, z, payload: null, material, hash: null });
  }
}
