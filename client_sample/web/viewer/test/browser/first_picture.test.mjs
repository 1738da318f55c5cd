// The first picture: it waits for land, and no longer than that helps.
import assert from 'node:assert/strict';
import test from 'node:test';
import { firstLoad } from '../first_load.mjs';
import { launch, newPage, noProblems } from './browser.mjs';
import { DIST, startSite } from './talusd.mjs';

test('a picture that is asked for before the land came is no empty one', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  // Asked for before the page draws its first frame with this engine.
  await page.addInitScript(() => {
    window.picture = new Promise((resolve, reject) => {
      const look = () => {
        const engine = window.talus?.engine;
        if (engine) engine.screenshot().then(resolve, reject);
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    });
  });
  await page.goto(`${site.url}#radius=3&horizon=0&quality=low&frameRate=0`);
  const colours = await page.evaluate(async () => {
    const image = await createImageBitmap(await window.picture);
    const drawing = new OffscreenCanvas(image.width, image.height).getContext('2d');
    drawing.drawImage(image, 0, 0);
    return new Set(new Uint32Array(drawing.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  });
  assert.ok(colours > 100, `${colours} colours`);
  noProblems(page);
});

test('who looks at the sky while the server goes away sees the sky', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  // More land than comes before the server is gone.
  await page.goto(`${site.url}#radius=24&horizon=16384&quality=low&look=0,90&mode=fly`);
  await page.waitForFunction(() => window.talus?.engine);
  await site.talusd.kill();
  await page.locator('#notice[data-kind=away]').waitFor();
  await page.locator('#opening.gone').waitFor({ state: 'attached' });
  const { state, hasPicture } = await page.evaluate(() => window.talus.engine.stats());
  assert.equal(state, 'lost', 'not all was there');
  assert.ok(hasPicture);
  assert.ok(await page.locator('#crosshair').isVisible());
  noProblems(page, [/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|WebSocket connection|502/]);
});

test('until the first picture the page asks for the files that first_load.mjs weighs, and for no others', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  const asked = new Set();
  page.on('request', (request) => {
    const { pathname } = new URL(request.url());
    if (!pathname.startsWith('/v1/')) asked.add(pathname === '/' ? 'index.html' : pathname.slice(1));
  });
  await page.goto(`${site.url}#radius=3&horizon=0&quality=high&frameRate=1`);
  await page.waitForFunction(() => window.talus?.engine?.stats().hasPicture);
  assert.deepEqual([...asked].sort(), firstLoad(DIST).sort());
  noProblems(page);
});
