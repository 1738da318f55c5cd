import { checking, TalusError } from './errors.js';
import type { ChunkKey } from './types.js';

/** Identifies a chunk in maps and messages. */
export function keyName(key: ChunkKey): string {
  return `${key.lod}/${key.x}/${key.y}/${key.z}`;
}

export function sameKey(a: ChunkKey, b: ChunkKey): boolean {
  return a.x === b.x && a.y === b.y && a.z === b.z && a.lod === b.lod;
}

/** Throws a TalusError if the chunk lies outside every world. */
export function checkKey(key: ChunkKey): void {
  const { lod, x, y, z } = checking('chunk', () => ({ ...key, lod: key.lod }));
  const limit = 2 ** (31 - lod);
  const inside = (at: number) => Number.isInteger(at) && -limit <= at && at < limit;
  const hasLevel = Number.isInteger(lod) && lod >= 0 && lod <= 6;
  if (hasLevel && inside(x) && inside(y) && inside(z)) return;
  throw new TalusError(
    'out_of_range',
    `chunk ${keyName(key)} (level/x/y/z) lies in no world: levels are 0 to 6, coordinates whole and within 2^31 >> level`,
  );
}

/** Throws a TalusError if they are not columns. */
export function checkColumns(columns: readonly { readonly x: number; readonly z: number }[]): void {
  checking('columns', () => {
    for (const { x, z } of columns) {
      if (Number.isSafeInteger(x) && Number.isSafeInteger(z)) continue;
      throw new TalusError('out_of_range', `column ${x}, ${z}: its coordinates must be whole numbers`);
    }
  });
}
