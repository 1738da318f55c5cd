// The viewer of a talusd that publishes its world: after the first View the page makes the land, and talusd sends edits.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems, SMALL } from './browser.mjs';
import { startSite } from './talusd.mjs';

test('the page makes the land of a published world, and says so', async (t) => {
  const site = await startSite(t, ['--publish', 'public']);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  const streamed = await page.evaluate(() => window.talus.engine.stats().receivedChunks);
  await page.keyboard.press('KeyP');
  // Once the world is open, all that comes into view is made here.
  await page.waitForFunction(() => {
    const { body } = window.talus.player;
    body.mode = 'fly';
    if (window.talus.engine.stats().state === 'complete') body.place(body.position[0] + 32, body.position[1], body.position[2]);
    return window.talus.engine.stats().madeChunks > 500;
  }, null, { polling: 300 });
  await filled(page);
  const { receivedChunks, madeChunks } = await page.evaluate(() => window.talus.engine.stats());
  assert.ok(madeChunks > receivedChunks - streamed, `${madeChunks} made, ${receivedChunks - streamed} received`);
  await page.waitForFunction(() => /Made here/.test(document.getElementById('traffic').textContent));
  noProblems(page);
});
