// Conversions between base voxels, screen pixels and tiles. North (-z) is up. At zoom 12 a block is a pixel.

export const TILE_PIXELS = 256;
export const DEEPEST_TILES = 12;
export const ZOOM = { least: 1, most: 16 };

export interface Camera {
  /** Base voxels at the centre of the screen. */
  readonly x: number;
  readonly z: number;
  readonly zoom: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface TileKey {
  readonly zoom: number;
  readonly x: number;
  readonly z: number;
}

export const nameOf = (tile: TileKey) => `${tile.zoom}/${tile.x}/${tile.z}`;
export const pixelsPerBlock = (zoom: number) => 2 ** (zoom - DEEPEST_TILES);
export const blocksPerTile = (zoom: number) => TILE_PIXELS * 2 ** (DEEPEST_TILES - zoom);

export function toScreen(camera: Camera, size: Size, x: number, z: number): [number, number] {
  const scale = pixelsPerBlock(camera.zoom);
  return [size.width / 2 + (x - camera.x) * scale, size.height / 2 + (z - camera.z) * scale];
}

export function toBlocks(camera: Camera, size: Size, px: number, py: number): { x: number; z: number } {
  const scale = pixelsPerBlock(camera.zoom);
  return { x: camera.x + (px - size.width / 2) / scale, z: camera.z + (py - size.height / 2) / scale };
}

/** Zooms and keeps the point at (px, py) fixed. */
export function zoomAbout(camera: Camera, size: Size, px: number, py: number, by: number): Camera {
  const zoom = Math.min(ZOOM.most, Math.max(ZOOM.least, camera.zoom + by));
  const held = toBlocks(camera, size, px, py);
  const scale = pixelsPerBlock(zoom);
  return { x: held.x - (px - size.width / 2) / scale, z: held.z - (py - size.height / 2) / scale, zoom };
}

/** Tiles that show the screen sharply, central ones first. */
export function visibleTiles(camera: Camera, size: Size, devicePixels: number): TileKey[] {
  const wanted = Math.round(camera.zoom + Math.log2(devicePixels));
  const zoom = Math.min(DEEPEST_TILES, Math.max(0, wanted));
  const span = blocksPerTile(zoom);
  const low = toBlocks(camera, size, 0, 0);
  const high = toBlocks(camera, size, size.width, size.height);
  const tiles: TileKey[] = [];
  for (let z = Math.floor(low.z / span); z * span < high.z; ++z)
    for (let x = Math.floor(low.x / span); x * span < high.x; ++x) tiles.push({ zoom, x, z });
  const away = (tile: TileKey) => Math.hypot((tile.x + 0.5) * span - camera.x, (tile.z + 0.5) * span - camera.z);
  return tiles.sort((a, b) => away(a) - away(b));
}

/** The tile of the next coarser zoom that covers this one. */
export const parentOf = ({ zoom, x, z }: TileKey): TileKey => ({ zoom: zoom - 1, x: x >> 1, z: z >> 1 });

/** A round length for the scale bar, at most `pixels` long. */
export function scaleBar(zoom: number, pixels: number): { blocks: number; pixels: number } {
  const most = pixels / pixelsPerBlock(zoom);
  const power = 10 ** Math.floor(Math.log10(most));
  const blocks = [5, 2, 1].map((n) => n * power).find((n) => n <= most) ?? power;
  return { blocks, pixels: blocks * pixelsPerBlock(zoom) };
}
