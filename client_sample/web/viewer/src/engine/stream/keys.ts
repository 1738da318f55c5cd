// Keys of columns and chunks for Maps: exact, as everything held lies within 2^20 chunks along each axis.
const BITS = 0xfffff;

export const columnKey = (lod: number, x: number, z: number): number =>
  ((x & BITS) * 0x100000 + (z & BITS)) * 8 + lod;

/** Key of a chunk: rows are within 2^9 of each other. */
export const chunkKey = (lod: number, x: number, y: number, z: number): string => `${columnKey(lod, x, z)}/${y}`;
