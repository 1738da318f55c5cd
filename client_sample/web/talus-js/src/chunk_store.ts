// The decoded chunks that an application holds. Gives a mesher one chunk with a rim of its neighbours' voxels.
//
//   const store = new ChunkStore(256 << 20);
//   client.on('chunk', (chunk) => store.put(chunk.key, decodeChunk(chunk.payload)));
//   client.on('chunkLeft', (key) => store.erase(key));
//   ...
//   const voxels = new Uint16Array(apronVolume(1));
//   if (store.apron(key, 1, 0, voxels) === 0) mesh(voxels);
import { TalusError } from './errors.js';
import { keyName } from './keys.js';
import type { ChunkKey, Voxels } from './types.js';

export const MAX_APRON = 2; // voxels
const SIZE = 32;
const VOLUME = SIZE * SIZE * SIZE;
const BOOKKEEPING_BYTES = 256;

/** Number of voxels of a chunk extended by `width` on every side. */
export function apronVolume(width: number): number {
  return (SIZE + 2 * width) ** 3;
}

/** The bit in apron()'s result for dx, dy, dz from -1 to 1; (0, 0, 0) is the chunk itself. */
export function neighbourBit(dx: number, dy: number, dz: number): number {
  return 1 << (((dy + 1) * 3 + dz + 1) * 3 + dx + 1);
}

interface HeldChunk {
  readonly key: ChunkKey;
  readonly chunk: Voxels;
}

function bytesOf(chunk: Voxels): number {
  return BOOKKEEPING_BYTES + (chunk.voxels === null ? 0 : 2 * VOLUME);
}

export class ChunkStore {
  private readonly held = new Map<string, HeldChunk>(); // least recently used first
  private usedBytes = 0;

  /** Holds about `maxBytes` of voxels; evicts the least recently used chunks, but never the one put last. */
  constructor(private readonly maxBytes: number) {}

  /** Replaces the chunk of this key. The voxels are kept, not copied. */
  put(key: ChunkKey, chunk: Voxels): void {
    if (chunk.voxels !== null && chunk.voxels.length !== VOLUME) {
      throw new TalusError('out_of_range', `ChunkStore.put: a chunk has ${VOLUME} voxels, not ${chunk.voxels.length}`);
    }
    const name = keyName(key);
    this.eraseName(name);
    this.held.set(name, { key, chunk });
    this.usedBytes += bytesOf(chunk);
    for (const oldest of this.held.keys()) {
      if (this.usedBytes <= this.maxBytes || oldest === name) break;
      this.eraseName(oldest);
    }
  }

  erase(key: ChunkKey): void {
    this.eraseName(keyName(key));
  }

  private eraseName(name: string): void {
    const held = this.held.get(name);
    if (held === undefined) return;
    this.held.delete(name);
    this.usedBytes -= bytesOf(held.chunk);
  }

  clear(): void {
    this.held.clear();
    this.usedBytes = 0;
  }

  /** Counts as a use. */
  find(key: ChunkKey): Voxels | undefined {
    return this.use(keyName(key));
  }

  private use(name: string): Voxels | undefined {
    const held = this.held.get(name);
    if (held === undefined) return undefined;
    this.held.delete(name);
    this.held.set(name, held);
    return held.chunk;
  }

  /** Does not count as a use. */
  has(key: ChunkKey): boolean {
    return this.held.has(keyName(key));
  }

  get size(): number {
    return this.held.size;
  }

  get bytes(): number {
    return this.usedBytes;
  }

  /** The material at a voxel of level `lod`, in its coordinates; undefined if its chunk is not held. */
  at(lod: number, x: number, y: number, z: number): number | undefined {
    const chunkOf = (at: number) => Math.floor(at / SIZE);
    const held = this.held.get(keyName({ lod, x: chunkOf(x), y: chunkOf(y), z: chunkOf(z) }));
    if (held === undefined) return undefined;
    const { chunk } = held;
    return chunk.voxels === null ? chunk.uniform : chunk.voxels[((y & 31) * SIZE + (z & 31)) * SIZE + (x & 31)];
  }

  forEach(visit: (key: ChunkKey, chunk: Voxels) => void): void {
    for (const { key, chunk } of this.held.values()) visit(key, chunk);
  }

  /** Writes (32 + 2 width)^3 voxels, starting `width` below the chunk's lowest corner, y slowest, then z, then x, into
   *  `out` of apronVolume(width). Width is 0 to MAX_APRON. Neighbours are of the same level. Chunks that are not held
   *  are filled with `filler` and reported by their neighbourBit() in the result, which is 0 if all are held. The
   *  store's bound must allow 27 chunks. */
  apron(key: ChunkKey, width: number, filler: number, out: Uint16Array): number {
    if (!Number.isInteger(width) || width < 0 || width > MAX_APRON || out.length !== apronVolume(width)) {
      throw new TalusError(
        'out_of_range',
        `ChunkStore.apron: width ${width} and ${out.length} voxels; widths are 0 to ${MAX_APRON}, voxels apronVolume(width)`,
      );
    }
    const reach = width > 0 ? 1 : 0;
    let gaps = 0;
    for (let dy = -reach; dy <= reach; ++dy) {
      for (let dz = -reach; dz <= reach; ++dz) {
        for (let dx = -reach; dx <= reach; ++dx) {
          const { lod, x, y, z } = key;
          const chunk = this.use(keyName({ lod, x: x + dx, y: y + dy, z: z + dz }));
          if (chunk === undefined) gaps |= neighbourBit(dx, dy, dz);
          copyPart(chunk ?? { uniform: filler, voxels: null }, dx, dy, dz, width, out);
        }
      }
    }
    return gaps;
  }
}

/** Along one axis: the neighbour's voxels on `side`, and their offset in the result. */
function part(side: number, width: number): { from: number; to: number; offset: number } {
  if (side < 0) return { from: SIZE - width, to: SIZE, offset: width - SIZE };
  if (side > 0) return { from: 0, to: width, offset: width + SIZE };
  return { from: 0, to: SIZE, offset: width };
}

function copyPart(chunk: Voxels, dx: number, dy: number, dz: number, width: number, out: Uint16Array): void {
  const edge = SIZE + 2 * width;
  const x = part(dx, width);
  const y = part(dy, width);
  const z = part(dz, width);
  for (let atY = y.from; atY < y.to; ++atY) {
    for (let atZ = z.from; atZ < z.to; ++atZ) {
      const to = ((atY + y.offset) * edge + atZ + z.offset) * edge + x.from + x.offset;
      if (chunk.voxels === null) {
        out.fill(chunk.uniform, to, to + x.to - x.from);
      } else {
        const from = (atY * SIZE + atZ) * SIZE + x.from;
        const count = x.to - x.from;
        for (let i = 0; i < count; ++i) out[to + i] = chunk.voxels[from + i]!;
      }
    }
  }
}
