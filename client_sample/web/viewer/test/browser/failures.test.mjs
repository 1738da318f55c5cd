// What fails is said, and comes back by itself.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { filled, launch, newPage, noProblems, place, SMALL } from './browser.mjs';
import { scratch, startSite } from './talusd.mjs';

const world = (name) => fileURLToPath(new URL(`../../../../../core/worlds/${name}.toml`, import.meta.url));
const EXPECTED_401 = /\b401\b|WebSocket connection/;

test('a wrong token is refused, a right one is taken and kept', async (t) => {
  const folder = scratch(t);
  writeFileSync(`${folder}/secret`, 'open sesame, by all means');
  writeFileSync(`${folder}/talusd.toml`, `[access]\nsecret_file = "${folder}/secret"\n`);
  const site = await startSite(t, ['--config', `${folder}/talusd.toml`]);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}`);
  const give = async (token) => {
    await page.locator('#token[open]').waitFor();
    await page.fill('#token-text', token);
    await page.keyboard.press('Enter');
  };
  await give('wrong');
  await page.locator('#token:not([open])').waitFor({ state: 'hidden' });
  await give('open sesame, by all means');
  await filled(page);
  assert.ok(await page.locator('#notice').isHidden());
  await page.reload();
  await filled(page);
  noProblems(page, [EXPECTED_401]);
});

test('without WebGL 2 the page says so, and the map works', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t, ['--disable-3d-apis']));
  await page.goto(`${site.url}#${SMALL}&at=100,80,200`);
  await page.locator('#notice[data-kind=no-webgl]').waitFor();
  assert.match(await page.locator('#notice').textContent(), /WebGL 2/);
  await page.getByRole('button', { name: 'Open the map' }).click();
  await page.waitForURL(/map\.html#.*at=100,80,200/);
  await page.waitForFunction(() => window.talusMap?.missing !== null);
  noProblems(page, [/THREE\.WebGLRenderer|WebGL/, / 404/]);
});

test('a lost context comes back, by the browser or by the page', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  const before = await place(page);
  const lose = () =>
    page.evaluate(() => {
      const lost = document.getElementById('view').getContext('webgl2').getExtension('WEBGL_lose_context');
      lost.loseContext();
      window.giveBack = () => lost.restoreContext();
    });
  await lose();
  await page.locator('#notice[data-kind=graphics-lost]').waitFor();
  await page.evaluate(() => window.giveBack());
  await page.locator('#notice').waitFor({ state: 'hidden' });
  await filled(page);
  await lose();
  await page.locator('#notice[data-kind=graphics-lost]').waitFor();
  // Never given back: the page makes a canvas of its own.
  await page.locator('#notice').waitFor({ state: 'hidden' });
  await filled(page);
  assert.deepEqual(await place(page), before);
  noProblems(page, [/[Cc]ontext/]);
});

test('another world under the same address', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  await site.talusd.stop();
  await page.locator('#notice[data-kind=away]').waitFor();
  await site.restart(['--world', world('hills')]);
  await page.locator('#notice[data-kind=world]').waitFor();
  await page.getByRole('button', { name: 'Go to its spawn' }).click();
  await filled(page);
  const [spawn, { x, z }] = [await page.evaluate(() => window.talus.engine.world.spawn), await place(page)];
  assert.deepEqual([Math.floor(x), Math.floor(z)], [spawn.x, spawn.z]);
  noProblems(page, [/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|WebSocket connection|502/]);
});

test('a page that is opened before its server has started', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  const page = await newPage(browser);
  // The page itself comes from the browser's cache or another host: here it is opened first and then asked to start over.
  await page.route('**/v1/**', (route) => route.abort('connectionrefused'));
  await page.routeWebSocket(/v1\/stream/, (socket) => socket.close());
  await page.goto(`${site.url}#${SMALL}`);
  await page.locator('#notice[data-kind=away]').waitFor();
  assert.match(await page.locator('#notice-text').textContent(), /Trying again/);
  noProblems(page, [/ERR_CONNECTION_REFUSED|WebSocket|ERR_FAILED/]);
});

test('a tab that slept for an hour', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  const page = await newPage(browser);
  // The page's clocks, which jump where a lid was shut. Timers do not count that time, here as there.
  await page.addInitScript(() => {
    let ahead = 0;
    const clock = (object, name) => {
      const real = object[name].bind(object);
      object[name] = () => real() + ahead;
    };
    clock(Date, 'now');
    clock(performance, 'now');
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => request((now) => callback(now + ahead));
    window.sleepFor = (ms) => (ahead += ms);
  });
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  const before = await place(page);
  const session = await page.context().newCDPSession(page);
  await session.send('Page.setWebLifecycleState', { state: 'frozen' });
  // While it sleeps, the server is another process: the connection that it had is gone.
  await site.talusd.kill();
  await site.restart();
  await page.evaluate(() => window.sleepFor(3_600_000));
  await session.send('Page.setWebLifecycleState', { state: 'active' });
  await filled(page);
  await page.locator('#notice').waitFor({ state: 'hidden' });
  assert.deepEqual(await place(page), before);
  noProblems(page, [/ERR_CONNECTION|WebSocket|502/]);
});
