// The map's page: tiles, panning, zooming, going there.
import assert from 'node:assert/strict';
import test from 'node:test';
import { launch, newPage, noProblems, place } from './browser.mjs';
import { startSite } from './talusd.mjs';

const settled = (page) => page.waitForFunction(() => window.talusMap.missing === 0);
const camera = (page) => page.evaluate(() => window.talusMap.view.camera);

/** Whether the server of this test draws maps at all. */
async function drawsMaps(site) {
  const { fingerprint } = await (await fetch(`${site.url}v1/world`)).json();
  const answer = await fetch(`${site.url}v1/${fingerprint}/map/9/0/0.png`);
  return answer.status !== 404;
}

test('the map page', async (t) => {
  const site = await startSite(t);
  const hasTiles = await drawsMaps(site);
  if (!hasTiles) t.diagnostic('this talusd draws no map: the page says so');
  const browser = await launch(t);
  const page = await newPage(browser, { viewport: { width: 800, height: 600 } });
  await page.goto(`${site.url}map.html`);
  await settled(page);

  await t.test('opens at the spawn, and shows land there', async () => {
    const { spawn } = await (await fetch(`${site.url}v1/world`)).json();
    const { x, z } = await camera(page);
    assert.deepEqual([x, z], [spawn[0], spawn[2]]);
    await page.waitForFunction((text) => document.querySelector('.map-at').textContent.startsWith(text), `${x}, ${z}`);
    if (!hasTiles) return assert.match(await page.locator('.map-weather').textContent(), /draws no map/);
    const colours = await page.evaluate(() => {
      const canvas = document.querySelector('#map canvas');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      const seen = new Set();
      for (let i = 0; i < data.length; i += 4 * 101) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      return seen.size;
    });
    assert.ok(colours > 50, `${colours} colours`);
  });

  await t.test('the coordinate under the pointer', async () => {
    await page.mouse.move(500, 250);
    const { x, z, zoom } = await camera(page);
    const blocks = 2 ** (12 - zoom);
    const expected = `${Math.floor(x + 100 * blocks)}, ${Math.floor(z - 50 * blocks)}`;
    await page.waitForFunction((text) => document.querySelector('.map-at').textContent.startsWith(text), expected);
    await page.waitForFunction(() => /ground at -?\d+/.test(document.querySelector('.map-at').textContent));
  });

  await t.test('dragging takes the land along', async () => {
    const before = await camera(page);
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(300, 350, { steps: 4 });
    await page.mouse.up();
    const after = await camera(page);
    const blocks = 2 ** (12 - before.zoom);
    assert.ok(Math.abs(after.x - before.x - 100 * blocks) < 1e-6);
    assert.ok(Math.abs(after.z - before.z + 50 * blocks) < 1e-6);
    assert.match(page.url(), /map\.html/, 'a drag is no click');
    await settled(page);
  });

  await t.test('wheel, keys and buttons zoom', async () => {
    const { zoom } = await camera(page);
    await page.mouse.wheel(0, -240);
    await page.waitForFunction((was) => window.talusMap.view.camera.zoom > was, zoom);
    await page.focus('#map canvas');
    await page.keyboard.press('-');
    await page.keyboard.press('-');
    await page.waitForFunction((was) => window.talusMap.view.camera.zoom <= was, zoom);
    await page.getByRole('button', { name: 'Zoom in' }).click();
    await settled(page);
  });

  await t.test('two fingers zoom', async () => {
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const { zoom } = await camera(page);
    await touch('touchStart', [350, 300], [450, 300]);
    await touch('touchMove', [300, 300], [500, 300]);
    await touch('touchMove', [250, 300], [550, 300]);
    await touch('touchEnd');
    await page.waitForFunction((was) => window.talusMap.view.camera.zoom > was + 0.5, zoom);
    assert.match(page.url(), /map\.html/, 'a pinch is no click');
  });

  await t.test('a click goes there', async () => {
    const { x, z, zoom } = await camera(page);
    const blocks = 2 ** (12 - zoom);
    await page.mouse.click(430, 280);
    await page.waitForURL(/\/#.*at=/);
    await page.waitForFunction(() => window.talus?.player.body.position[0] !== 0);
    const there = await place(page);
    assert.equal(Math.floor(there.x), Math.floor(x + 30 * blocks));
    assert.equal(Math.floor(there.z), Math.floor(z - 20 * blocks));
  });

  noProblems(page, hasTiles ? [] : [/404/]);
});
