// A hundred chunks on foot, and talusd killed and started again under the player.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems, SMALL, stats } from './browser.mjs';
import { startSite } from './talusd.mjs';

/** Walks on, several steps of the body a frame, until so many columns of chunks have been trodden; around what is in the way. */
async function walk(page, columns) {
  await page.focus('#stage');
  for (const key of ['KeyW', 'ShiftLeft', 'Space']) await page.keyboard.down(key);
  const result = await page.evaluate(async (columns) => {
    const { player } = window.talus;
    const { body } = player;
    const visited = new Set();
    const inside = [];
    let last = [...body.position];
    let still = 0;
    for (let frame = 0; visited.size < columns && frame < 20_000; ++frame) {
      await new Promise(requestAnimationFrame);
      const { engine } = window.talus;
      if (engine === null || body.waiting) {
        player.step(1 / 60);
        continue;
      }
      for (let i = 0; i < 24; ++i) player.step(1 / 60);
      const [x, y, z] = body.position;
      visited.add(`${Math.floor(x / 32)} ${Math.floor(z / 32)}`);
      const feet = engine.voxelAt(Math.floor(x), Math.floor(y + 0.01), Math.floor(z));
      if (feet !== undefined && engine.isSolid(feet)) inside.push(`${x} ${y} ${z}`);
      still = Math.hypot(x - last[0], z - last[2]) < 0.5 ? still + 1 : 0;
      if (still > 2) body.yaw = (body.yaw + 67) % 360;
      last = [x, y, z];
    }
    return { columns: visited.size, inside };
  }, columns);
  for (const key of ['KeyW', 'ShiftLeft', 'Space']) await page.keyboard.up(key);
  return result;
}

test('a hundred chunks walked', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}&mode=walk`);
  await filled(page);
  const before = await stats(page);
  const { columns, inside } = await walk(page, 100);
  assert.ok(columns >= 100, `${columns} columns of chunks`);
  assert.deepEqual(inside.slice(0, 3), [], 'the feet were inside of something solid');
  await filled(page);
  assert.ok((await stats(page)).receivedBytes > before.receivedBytes);
  noProblems(page);
});

test('a place without its height is above the ground, and above the water on it', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  const [x, z] = [0, 0]; // in the sea
  const { heights } = await (await fetch(`${site.url}v1/heights?columns=${x},${z}`)).json();
  await page.goto(`${site.url}#${SMALL}&at=${x},,${z}&mode=fly`);
  await filled(page);
  const seen = await page.evaluate(() => {
    const { engine, player } = window.talus;
    const [x, y, z] = player.body.position.map(Math.floor);
    const isLiquid = (row) => engine.isLiquid(engine.voxelAt(x, row, z));
    let depth = 0;
    for (let row = y; row > y - 200 && !isLiquid(row); --row) ++depth;
    return { y, isLiquid: isLiquid(y), depth };
  });
  assert.ok(!seen.isLiquid && seen.depth < 20, `${seen.depth} above the water`);
  assert.ok(seen.y > heights[0] / 256 + 20, 'the ground lies deep below');
  noProblems(page);
});

test('talusd is killed under the player, and started again', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}&mode=walk`);
  await filled(page);
  await site.talusd.kill();
  await page.locator('#notice[data-kind=away]').waitFor();
  assert.equal(await page.locator('#status-text').textContent(), 'Server away');
  // What is here stays, and one can walk in it.
  assert.ok((await stats(page)).triangles > 0);
  await site.restart();
  await page.locator('#notice').waitFor({ state: 'hidden' });
  await walk(page, 12);
  await filled(page);
  noProblems(page, [/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|WebSocket connection|502/]);
});
