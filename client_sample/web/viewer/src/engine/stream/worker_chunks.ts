// A worker's chunks: payloads as received, the shells of decoded chunks, and a bounded number of decoded chunks not
// meshed yet. Decoding is lazy.
import { shellOf, type Shell } from '../mesh/volume.js';
import { chunkKey } from './keys.js';
import type { ChunkData } from './messages.js';

interface HeldChunk {
  readonly payload: Uint8Array | null;
  material: number | null;
  hash: string | null; // null: checked, or not known
  shell: Uint16Array | null;
}

const VOXEL_BYTES = 65536;
const CACHED = 160; // chunks: 10 MiB

/** Throws if the payload is invalid or does not match the hash. */
export type Decode = (payload: Uint8Array, hash: string | null) => number | Uint16Array;

export class WorkerChunks {
  private readonly held = new Map<string, HeldChunk>();
  private readonly voxels = new Map<string, Uint16Array>();
  private payloadBytes = 0;
  private shells = 0;

  constructor(private readonly decode: Decode) {}

  get bytes(): number {
    return this.payloadBytes + this.shells * 12288 + this.voxels.size * VOXEL_BYTES;
  }

  add(chunk: ChunkData): void {
    this.drop(chunk);
    this.held.set(chunkKey(chunk.lod, chunk.x, chunk.y, chunk.z), {
      payload: chunk.payload,
      material: chunk.material,
      hash: chunk.hash,
      shell: null,
    });
    this.payloadBytes += chunk.payload?.length ?? 0;
  }

  drop({ lod, x, y, z }: { lod: number; x: number; y: number; z: number }): void {
    const key = chunkKey(lod, x, y, z);
    const held = this.held.get(key);
    if (held === undefined) return;
    this.payloadBytes -= held.payload?.length ?? 0;
    if (held.shell !== null) this.shells--;
    this.held.delete(key);
    this.voxels.delete(key);
  }

  /** All voxels, or the uniform material; undefined: not held. */
  centre(lod: number, x: number, y: number, z: number): number | Uint16Array | undefined {
    const key = chunkKey(lod, x, y, z);
    const held = this.held.get(key);
    if (held === undefined) return undefined;
    if (held.material !== null) return held.material;
    const cached = this.voxels.get(key);
    if (cached !== undefined) {
      this.voxels.delete(key); // meshed now: not needed again soon
      return cached;
    }
    return this.decoded(held);
  }

  shell(lod: number, x: number, y: number, z: number): Shell | undefined {
    const key = chunkKey(lod, x, y, z);
    const held = this.held.get(key);
    if (held === undefined) return undefined;
    if (held.material !== null) return held.material;
    if (held.shell === null) {
      const voxels = this.decoded(held);
      if (typeof voxels === 'number') return voxels;
      this.voxels.set(key, voxels);
      if (this.voxels.size > CACHED) this.voxels.delete(this.voxels.keys().next().value!);
    }
    return held.shell!;
  }

  private decoded(held: HeldChunk): number | Uint16Array {
    const voxels = this.decode(held.payload!, held.hash);
    held.hash = null; // checking once is enough
    if (typeof voxels === 'number') {
      held.material = voxels;
    } else if (held.shell === null) {
      held.shell = shellOf(voxels);
      this.shells++;
    }
    return voxels;
  }
}
