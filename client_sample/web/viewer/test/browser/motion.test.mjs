// Nothing moves by itself where the system or the player asks for less motion: no bar, no panel, no cloud, no wave.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { startSite } from './talusd.mjs';

/** Whether the picture of a minute later is another one. */
const picturesDiffer = (page) =>
  page.evaluate(async () => {
    const { engine } = window.talus;
    const pixels = async (now) => {
      const shot = engine.screenshot();
      engine.frame(now);
      const image = await createImageBitmap(await shot);
      const drawing = new OffscreenCanvas(image.width, image.height).getContext('2d');
      drawing.drawImage(image, 0, 0);
      return drawing.getImageData(0, 0, image.width, image.height).data;
    };
    const now = performance.now();
    const [one, other] = [await pixels(now), await pixels(now + 60_000)];
    return one.some((value, i) => value !== other[i]);
  });

const animations = (page) => page.evaluate(() => document.getAnimations().map((a) => a.animationName ?? a.transitionProperty));

for (const [system, setting, moves] of [
  ['reduce', null, false],
  ['no-preference', null, true],
  ['no-preference', true, false],
  ['reduce', false, true],
])
  test(`the system says ${system}, the player ${setting === null ? 'nothing' : setting ? 'less' : 'full'}`, async (t) => {
    const site = await startSite(t);
    const page = await newPage(await launch(t), { reducedMotion: system });
    let open;
    const opened = new Promise((resolve) => (open = resolve));
    await page.routeWebSocket(/v1\/stream/, async (socket) => {
      await opened;
      const server = socket.connectToServer();
      socket.onMessage((message) => server.send(message));
      server.onMessage((message) => socket.send(message));
    });
    // Toward the sky, and some land below it.
    await page.goto(`${site.url}#radius=2&horizon=0&quality=low&frameRate=1&look=0,20${setting === null ? '' : `&reducedMotion=${setting}`}`);
    await page.waitForFunction(() => window.talus !== undefined);
    assert.deepEqual(await animations(page), moves ? ['slide'] : [], 'while it opens');
    open();
    await filled(page);
    assert.equal(await picturesDiffer(page), moves, 'the picture of a minute later');
    const panel = await page.evaluate(() => {
      document.querySelector('[data-panel=time]').click();
      return document.getAnimations().some((a) => a.animationName === 'come');
    });
    assert.equal(panel, moves, 'a panel comes');
    noProblems(page);
  });
