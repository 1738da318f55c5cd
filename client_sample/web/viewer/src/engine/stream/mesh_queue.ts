// Chunks to be meshed, nearest first.
import type { Chunk, Drawable } from './column.js';
import type { SlicePlane } from './messages.js';

const SORT_EVERY_MS = 120;
/** Maximum number of chunks without room that are skipped at a time. */
const MAX_PASSED = 32;

export class MeshQueue<D extends Drawable> {
  private chunks: Chunk<D>[] = []; // the last is next
  private isSorted = false;
  private sortedAt = -Infinity;

  /** `sliceOf`: the slice that cuts a chunk now. */
  constructor(private readonly sliceOf: (chunk: Chunk<D>) => SlicePlane | null) {}

  get length(): number {
    return this.chunks.length;
  }

  add(chunk: Chunk<D>): void {
    chunk.queued = true;
    this.chunks.push(chunk);
    this.isSorted = false;
  }

  clear(): void {
    this.chunks = [];
  }

  /** The camera moved. */
  moved(): void {
    this.isSorted = false;
  }

  /** Removes each chunk from the queue; puts back chunks for which `start` returns false, as there is no room. */
  forEachNext(now: number, camera: { x: number; y: number; z: number }, start: (chunk: Chunk<D>) => boolean): void {
    if (this.chunks.length === 0) return;
    if (!this.isSorted && now - this.sortedAt > SORT_EVERY_MS) this.sort(now, camera);
    const passed: Chunk<D>[] = [];
    while (this.chunks.length > 0 && passed.length < MAX_PASSED) {
      const chunk = this.chunks.pop()!;
      chunk.queued = false;
      if (start(chunk)) continue;
      chunk.queued = true;
      passed.push(chunk);
    }
    for (let i = passed.length - 1; i >= 0; i--) this.chunks.push(passed[i]!);
  }

  private sort(now: number, camera: { x: number; y: number; z: number }): void {
    this.sortedAt = now;
    for (const chunk of this.chunks) chunk.order = this.distance(chunk, camera);
    this.chunks.sort((a, b) => b.order - a.order);
    this.isSorted = true;
  }

  private distance(chunk: Chunk<D>, camera: { x: number; y: number; z: number }): number {
    const size = 32 * 2 ** chunk.lod;
    const dx = (chunk.x + 0.5) * size - camera.x;
    const dy = (chunk.y + 0.5) * size - camera.y;
    const dz = (chunk.z + 0.5) * size - camera.z;
    if (chunk.hurried) return Math.hypot(dx, dz) - 100_000;
    // Chunks that are drawn already can wait, and so can deep ones.
    return Math.hypot(dx, dz) + (dy > 0 ? dy * 0.25 : -dy * 0.5) + (chunk.meshedWith >= 0 && chunk.meshedSlice === this.sliceOf(chunk) ? 200 : 0);
  }
}
