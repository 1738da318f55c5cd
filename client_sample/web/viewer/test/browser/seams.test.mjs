// Where levels of detail meet: no crack that one sees through, and no pop when a finer level takes a coarser one's place.
// Where a world has trees, one sees sky between their leaves, and the skyline may move by a tree where it is thinned out.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { landSeen } from './land_seen.mjs';
import { startSite } from './talusd.mjs';

const world = (name) => fileURLToPath(new URL(`../../../../../core/worlds/${name}.toml`, import.meta.url));
const SIZE = { width: 320, height: 240 };
const FOV = 70; // degrees, from top to bottom
/** Pixels that a coarse voxel is high where its level begins, which is the same for all levels: where level l ends, l + 1 begins
 *  and goes on twice as far. `radius`: of level 0. */
const voxelPixels = (radius) => ((SIZE.height / 2 / Math.tan((FOV / 2) * (Math.PI / 180))) * 2) / (radius * 32);
/** Software draws no more than these in a bearable time. */
const MOST_TRIANGLES = 300_000;

/** Level eyes, so that every column of pixels is a vertical plane. The next picture is from there, whether the page has stepped or not. */
function lookFrom(page, place, rise, yaw) {
  return page.evaluate(
    ([{ x, y, z }, rise, yaw]) => {
      const { player, engine } = window.talus;
      player.body.place(x, y + rise, z);
      [player.body.yaw, player.body.pitch] = [yaw, 0];
      player.look(engine);
    },
    [place, rise, yaw],
  );
}

/** All is drawn of a View of this radius from where the camera is: that it was asked for is not enough, it is sent with the page's next step. */
async function drawAround(page, radius, horizon) {
  await page.evaluate(([radius, horizon]) => window.talus.engine.setRadius(radius, horizon), [radius, horizon]);
  await page.waitForFunction((radius) => {
    const { engine } = window.talus;
    const { land, eye } = engine;
    const { x0, x1, z0, z1 } = land.shape[0];
    const isAround = (first, last, at) => Math.abs(last - first - 2 * radius) <= 1 && Math.abs(first + last + 1 - at / 16) <= 4;
    return isAround(x0, x1, eye.x) && isAround(z0, z1, eye.z) && engine.stats().state === 'complete' && land.settled;
  }, radius);
}

const HILLSIDES = [[3, 20], [12, 110], [30, 200], [70, 290]];

/** `radii`: of the coarser picture and the finer, of at most MOST_TRIANGLES. `places`: from the spawn, and from how high and where to one
 *  looks there. `most`: coarse voxels that the skyline may move at a column of pixels; `usual`: at all columns but 3 of 100. `gaps`:
 *  pixels of sky inside of the land. */
for (const { name, radii, horizon, places, most, usual, gaps } of [
  { name: 'hills', radii: [2, 4], horizon: 768, places: [[0, 0, HILLSIDES], [1500, -900, HILLSIDES]], most: 3, usual: 3, gaps: 0 },
  { name: 'default', radii: [4, 7], horizon: 1536, places: [[0, 0, HILLSIDES.slice(1)]], most: 8, usual: 3, gaps: 6 },
  { name: 'mesas', radii: [4, 7], horizon: 1536, places: [[0, 0, HILLSIDES.slice(1)], [-1500, 400, [[30, 290], [70, 340]]]], most: 3, usual: 3, gaps: 6 },
])
  test(`levels of detail meet without cracks, and take turns without pops: ${name}, radius ${radii.join(' and ')}`, async (t) => {
    const site = await startSite(t, ['--world', world(name)]);
    const page = await newPage(await launch(t), { viewport: SIZE });
    await page.goto(`${site.url}#radius=${radii[0]}&horizon=${horizon}&quality=low&frameRate=0.02`);
    await filled(page);
    const spawn = await page.evaluate(() => window.talus.engine.world.spawn);
    const moves = [];
    let drawn = 0;
    for (const [dx, dz, looks] of places) {
      const y = await page.evaluate(async ([x, z]) => (await (await fetch(`/v1/heights?columns=${x},${z}`)).json()).heights[0] / 256, [spawn.x + dx, spawn.z + dz]);
      const place = { x: spawn.x + dx + 0.5, y, z: spawn.z + dz + 0.5 };
      for (const [rise, yaw] of looks) {
        await lookFrom(page, place, rise, yaw);
        const skylines = [];
        for (const radius of radii) {
          await drawAround(page, radius, horizon);
          const { skyline, holes, triangles } = await landSeen(page, SIZE);
          const where = `${JSON.stringify(place)}, ${rise} up, toward ${yaw}, radius ${radius}`;
          assert.ok(holes.length <= gaps, `${where}: one looks through the land at ${holes.length} pixels, ${JSON.stringify(holes.slice(0, 5))} among them`);
          assert.ok(triangles <= MOST_TRIANGLES, `${where}: ${triangles} triangles`);
          drawn = Math.max(drawn, triangles);
          skylines.push(skyline);
        }
        const [coarse, fine] = skylines;
        coarse.forEach((row, x) => {
          const voxels = Math.abs(row - fine[x]) / voxelPixels(radii[0]);
          assert.ok(voxels <= most, `from ${JSON.stringify(place)}, ${rise} up, toward ${yaw}: the skyline at pixel ${x} moves by ${voxels.toFixed(1)} coarse voxels`);
          moves.push(voxels);
        });
      }
    }
    moves.sort((a, b) => a - b);
    const mean = moves.reduce((sum, voxels) => sum + voxels, 0) / moves.length;
    const all = moves[Math.floor(moves.length * 0.97)];
    t.diagnostic(`of ${moves.length} columns of pixels the skyline moves by ${mean.toFixed(2)} coarse voxels in the mean, ${all.toFixed(1)} in 97 of 100, ${moves.at(-1).toFixed(1)} at most; at most ${drawn} triangles`);
    assert.ok(mean <= 0.5);
    assert.ok(all <= usual);
    noProblems(page);
  });
