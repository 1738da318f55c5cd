import { expect, test } from 'vitest';
import { blocksPerTile, parentOf, scaleBar, toBlocks, toScreen, visibleTiles, zoomAbout } from '../../src/map/projection';

const size = { width: 800, height: 600 };

test('zoom z spans 256 * 2^(12-z) blocks a tile', () => {
  expect([12, 11, 0].map(blocksPerTile)).toEqual([256, 512, 1048576]);
});

test('blocks to pixels and back', () => {
  const camera = { x: -2496, z: 70000, zoom: 9.3 };
  const [px, py] = toScreen(camera, size, -2000, 70100);
  const at = toBlocks(camera, size, px, py);
  expect(at.x).toBeCloseTo(-2000, 6);
  expect(at.z).toBeCloseTo(70100, 6);
});

test('zooming keeps what is under the pointer', () => {
  const camera = { x: 10, z: 20, zoom: 8 };
  const before = toBlocks(camera, size, 700, 100);
  const after = toBlocks(zoomAbout(camera, size, 700, 100, 1.7), size, 700, 100);
  expect(after.x).toBeCloseTo(before.x, 6);
  expect(after.z).toBeCloseTo(before.z, 6);
});

test('visible tiles cover the screen once, with signed indices', () => {
  const tiles = visibleTiles({ x: 0, z: 0, zoom: 12 }, size, 1);
  expect(tiles).toHaveLength(16);
  expect(tiles.every(({ zoom }) => zoom === 12)).toBe(true);
  expect(tiles.map(({ x }) => x).sort((a, b) => a - b)[0]).toBe(-2);
  expect(visibleTiles({ x: 0, z: 0, zoom: 15 }, size, 2).every(({ zoom }) => zoom === 12)).toBe(true);
  expect(visibleTiles({ x: 0, z: 0, zoom: 10 }, size, 2)[0]!.zoom).toBe(11);
});

test('parents of tiles round down', () => {
  expect(parentOf({ zoom: 5, x: -1, z: 3 })).toEqual({ zoom: 4, x: -1, z: 1 });
});

test('the scale bar is round and fits', () => {
  for (let zoom = 1; zoom <= 16; zoom += 0.37) {
    const bar = scaleBar(zoom, 130);
    expect(bar.pixels).toBeLessThanOrEqual(130);
    expect(bar.pixels).toBeGreaterThan(40);
  }
});
