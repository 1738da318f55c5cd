// Divides a View into requests: squares of columns, nearest first, larger ones farther out.
import type { View } from '../types.js';
import type { ViewShape } from '../view_shape.js';

/** n x n columns of a level, from (x, z); x and z are multiples of n, and n is 1, 2 or 4. */
export interface Tile {
  readonly lod: number;
  readonly x: number;
  readonly z: number;
  readonly n: number;
}

export function tileName({ lod, x, z, n }: Tile): string {
  return n === 1 ? `${lod}/${x}/${z}` : `${lod}/${x}/${z}/${n}x${n}`;
}

/** Minimum distance of squares by size, in columns of the level: near columns come alone, and so sooner. */
const NEAREST_OF_EDGE: readonly (readonly [n: number, nearest: number])[] = [
  [4, 6],
  [2, 3],
];
const BEHIND = 1.5; // factor on the distance of columns behind the player

export function forEachColumn(tile: Tile, visit: (x: number, z: number) => void): void {
  for (let z = tile.z; z < tile.z + tile.n; ++z) {
    for (let x = tile.x; x < tile.x + tile.n; ++x) visit(x, z);
  }
}

/** The same columns as smaller squares. */
export function quarters(tile: Tile): Tile[] {
  const n = tile.n / 2;
  return [0, 1, 2, 3].map((i) => ({ lod: tile.lod, x: tile.x + n * (i & 1), z: tile.z + n * (i >> 1), n }));
}

/** Tiles with every column of `wanted` that the View contains, in the order of fetching. */
export function tilesOf(
  view: View,
  shape: ViewShape,
  wanted: (lod: number, x: number, z: number) => boolean,
): Tile[] {
  const tiles = new Map<string, Tile>();
  shape.forEachColumn((lod, x, z) => {
    if (!wanted(lod, x, z)) return;
    const tile = tileAround(view, lod, x, z);
    tiles.set(tileName(tile), tile);
  });
  const far = (tile: Tile) => distance(view, tile);
  return [...tiles.values()].map((tile) => ({ tile, at: far(tile) })).sort((a, b) => a.at - b.at).map(({ tile }) => tile);
}

/** The largest aligned square that contains a column and is far enough. */
function tileAround(view: View, lod: number, x: number, z: number): Tile {
  const size = 32 * 2 ** lod;
  for (const [n, nearest] of NEAREST_OF_EDGE) {
    const tile = { lod, x: Math.floor(x / n) * n, z: Math.floor(z / n) * n, n };
    const gapX = Math.max(tile.x - view.centre.x / size, view.centre.x / size - (tile.x + n), 0);
    const gapZ = Math.max(tile.z - view.centre.z / size, view.centre.z / size - (tile.z + n), 0);
    if (Math.max(gapX, gapZ) >= nearest) return tile;
  }
  return { lod, x, z, n: 1 };
}

/** Distance of its centre, in base voxels; greater if it lies behind. */
function distance(view: View, { lod, x, z, n }: Tile): number {
  const size = 32 * 2 ** lod;
  const toX = (x + n / 2) * size - view.centre.x;
  const toZ = (z + n / 2) * size - view.centre.z;
  const far = Math.hypot(toX, toZ);
  const direction = view.direction ?? { x: 0, y: 0, z: 0 };
  const ahead = direction.x * toX + direction.z * toZ;
  return ahead < 0 ? far * BEHIND : far;
}
