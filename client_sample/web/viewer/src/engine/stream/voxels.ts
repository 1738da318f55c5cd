// Voxels near the player, for the page itself: decoded when they are first looked at, a few chunks kept.
import { voxelIndex } from '../mesh/volume.js';
import { decodeChunk } from './decode.js';
import { chunkKey } from './keys.js';
import type { Chunk } from './column.js';

const KEPT = 128; // chunks: 8 MiB

export class Voxels {
  private readonly decoded = new Map<string, { payload: Uint8Array; voxels: number | Uint16Array }>();

  get bytes(): number {
    return this.decoded.size * 65536;
  }

  /** (x, y, z) of the chunk, 0 to 31. */
  at(chunk: Chunk, x: number, y: number, z: number): number | undefined {
    if (chunk.material !== null) return chunk.material;
    if (chunk.payload === null) return undefined;
    const key = chunkKey(chunk.lod, chunk.x, chunk.y, chunk.z);
    let held = this.decoded.get(key);
    if (held === undefined || held.payload !== chunk.payload) {
      held = { payload: chunk.payload, voxels: decodeChunk(chunk.payload) };
      this.decoded.set(key, held);
      if (this.decoded.size > KEPT) this.decoded.delete(this.decoded.keys().next().value!);
    }
    return typeof held.voxels === 'number' ? held.voxels : held.voxels[voxelIndex(x, y, z)];
  }

  clear(): void {
    this.decoded.clear();
  }
}
