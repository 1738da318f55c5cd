// Voxels near the player, for the page itself: decoded on first use; a few chunks are cached.
import { voxelIndex } from '../mesh/volume.js';
import { decodeChunk } from './decode.js';
import { chunkKey } from './keys.js';
import type { Chunk } from './column.js';

const KEPT = 128; // chunks: 8 MiB

/** null: the payload does not decode, or does not match its hash. */
type DecodedVoxels = number | Uint16Array | null;

export class Voxels {
  private readonly decoded = new Map<string, { payload: Uint8Array; voxels: DecodedVoxels }>();

  /** `chunkAt`: the land's chunk of level 0. */
  constructor(private readonly chunkAt: (x: number, y: number, z: number) => Chunk | undefined) {}

  get bytes(): number {
    return this.decoded.size * 65536;
  }

  /** Material of a base voxel; undefined: unknown. From `airFrom` up the generated world is air, unless edited. */
  atBlock(x: number, y: number, z: number, airFrom: number): number | undefined {
    const chunk = this.chunkAt(Math.floor(x / 32), Math.floor(y / 32), Math.floor(z / 32));
    if (chunk === undefined || chunk.left) return y >= airFrom ? 0 : undefined;
    const within = (v: number) => ((v % 32) + 32) % 32;
    return this.at(chunk, within(x), within(y), within(z));
  }

  /** (x, y, z) of the chunk, 0 to 31. */
  private at(chunk: Chunk, x: number, y: number, z: number): number | undefined {
    if (chunk.material !== null) return chunk.material;
    if (chunk.payload === null) return undefined;
    const key = chunkKey(chunk.lod, chunk.x, chunk.y, chunk.z);
    let held = this.decoded.get(key);
    if (held === undefined || held.payload !== chunk.payload) {
      held = { payload: chunk.payload, voxels: decodedOrNull(chunk.payload, chunk.hash) };
      this.decoded.set(key, held);
      if (this.decoded.size > KEPT) this.decoded.delete(this.decoded.keys().next().value!);
    }
    if (held.voxels === null) return undefined;
    return typeof held.voxels === 'number' ? held.voxels : held.voxels[voxelIndex(x, y, z)];
  }

  clear(): void {
    this.decoded.clear();
  }
}

/** The workers, which receive every chunk too, report payloads that do not decode. */
function decodedOrNull(payload: Uint8Array, hash: string | null): DecodedVoxels {
  try {
    return decodeChunk(payload, hash);
  } catch {
    return null;
  }
}
