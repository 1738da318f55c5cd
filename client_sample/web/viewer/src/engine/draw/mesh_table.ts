// Data of each mesh needed in every frame, a row of 64 bytes per slot: objects are scattered in memory, and reading
// thousands of them would take longer than the work itself.
import type { ChunkMesh } from '../mesh/mesher.js';
import { SLOTS } from '../mesh/quad.js';
import type { Place } from './pages.js';

const WIDTH = 16;
/** Offsets in a row: place of its quads, count of each group, and its lowest and highest ends in blocks. */
export const PAGE = 0;
export const FIRST_QUAD = 1;
export const COUNTS = 2; // 11 of them
export const BOTTOM = 13;
export const TOP = 14;

export class MeshTable {
  readonly values = new Int32Array(SLOTS * WIDTH);

  at(slot: number): number {
    return slot * WIDTH;
  }

  set(slot: number, { page, firstQuad }: Place, { counts }: ChunkMesh, bottom: number, top: number): void {
    const at = this.at(slot);
    this.values[at + PAGE] = page;
    this.values[at + FIRST_QUAD] = firstQuad;
    this.values.set(counts, at + COUNTS);
    this.values[at + BOTTOM] = bottom;
    this.values[at + TOP] = top;
  }
}
