// Where levels of detail meet: no crack that one sees through, and no pop when a finer level takes a coarser one's place.
// The world has no trees, arches or caves in sight, so that under land there is never sky.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { startSite } from './talusd.mjs';

const HILLS = fileURLToPath(new URL('../../../../../core/worlds/hills.toml', import.meta.url));
const SIZE = { width: 320, height: 240 };
const FOV = 70; // degrees, from top to bottom
const RADIUS = 2; // of level 0; level l + 1 begins where twice as far a level l ends
const HORIZON = 768;
/** Pixels that a coarse voxel is high where its level begins, which is the same for all levels. */
const VOXEL = ((SIZE.height / 2 / Math.tan((FOV / 2) * (Math.PI / 180))) * 2) / (RADIUS * 32);

/** A picture of the solid land alone, before nothing: its skyline, the topmost row of each column of pixels that shows land, and
 *  the pixels inside of the land that show none. */
function landSeen(page) {
  return page.evaluate(async ({ width, height }) => {
    const { engine } = window.talus;
    const { frames } = engine;
    frames.sky.visible = frames.terrain.liquid.visible = false;
    frames.renderer.setClearColor(0xff00ff, 1);
    const shot = engine.screenshot();
    engine.frame(performance.now()); // the only picture, as software takes long for one
    const picture = await createImageBitmap(await shot);
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const isLand = (x, y) => data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3).join() !== '255,0,255';
    const skyline = Array.from({ length: width }, (_, x) => {
      let y = 0;
      while (y < height && !isLand(x, y)) ++y;
      return y;
    });
    // From the top row on, from pixel to pixel: what is not reached lies inside.
    const reached = new Uint8Array(width * height);
    const edge = Array.from({ length: width }, (_, x) => [x, 0]);
    while (edge.length > 0) {
      const [x, y] = edge.pop();
      if (x < 0 || x >= width || y < 0 || y >= height || reached[y * width + x] || isLand(x, y)) continue;
      reached[y * width + x] = 1;
      edge.push([x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]);
    }
    const holes = [];
    for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) if (!isLand(x, y) && !reached[y * width + x]) holes.push([x, y]);
    return { skyline, holes };
  }, SIZE);
}

/** Level eyes, so that every column of pixels is a vertical plane. */
function lookFrom(page, place, rise, yaw) {
  return page.evaluate(
    ([{ x, y, z }, rise, yaw]) => {
      const { body } = window.talus.player;
      body.place(x, y + rise, z);
      [body.yaw, body.pitch] = [yaw, 0];
    },
    [place, rise, yaw],
  );
}

test('levels of detail meet without cracks, and take turns without pops', async (t) => {
  const site = await startSite(t, ['--world', HILLS]);
  const page = await newPage(await launch(t), { viewport: SIZE });
  await page.goto(`${site.url}#radius=${RADIUS}&horizon=${HORIZON}&quality=low&frameRate=0.02`);
  await filled(page);
  const spawn = await page.evaluate(() => window.talus.engine.world.spawn);
  let shifted = 0;
  let most = 0;
  let columns = 0;
  for (const [dx, dz] of [[0, 0], [1500, -900]]) {
    const y = await page.evaluate(async ([x, z]) => (await (await fetch(`/v1/heights?columns=${x},${z}`)).json()).heights[0] / 256, [spawn.x + dx, spawn.z + dz]);
    const place = { x: spawn.x + dx + 0.5, y, z: spawn.z + dz + 0.5 };
    for (const [rise, yaw] of [[3, 20], [12, 110], [30, 200], [70, 290]]) {
      await lookFrom(page, place, rise, yaw);
      const skylines = [];
      for (const radius of [RADIUS, 2 * RADIUS]) {
        await page.evaluate(([radius, horizon]) => window.talus.engine.setRadius(radius, horizon), [radius, HORIZON]);
        await page.waitForFunction((radius) => {
          const stats = window.talus.engine.stats();
          return stats.state === 'complete' && stats.pendingMeshes === 0 && stats.chunksPerLevel[0] >= (2 * radius + 1) ** 2;
        }, radius);
        const { skyline, holes } = await landSeen(page);
        const where = `${JSON.stringify(place)}, ${rise} up, toward ${yaw}, radius ${radius}`;
        assert.deepEqual(holes.slice(0, 5), [], `${where}: one looks through the land at ${holes.length} pixels`);
        skylines.push(skyline);
      }
      const [coarse, fine] = skylines;
      coarse.forEach((row, x) => {
        const voxels = Math.abs(row - fine[x]) / VOXEL;
        assert.ok(voxels <= 3, `from ${JSON.stringify(place)}, ${rise} up, toward ${yaw}: the skyline at pixel ${x} moves by ${voxels.toFixed(1)} coarse voxels`);
        shifted += voxels;
        most = Math.max(most, voxels);
        ++columns;
      });
    }
  }
  t.diagnostic(`of ${columns} columns of pixels the skyline moves by ${(shifted / columns).toFixed(2)} coarse voxels in the mean, ${most.toFixed(1)} at most`);
  assert.ok(shifted / columns <= 0.5);
  noProblems(page);
});
