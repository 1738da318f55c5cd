// Nothing lies over what one needs, nothing is cut off without a sign, and nobody is told of keys that he does not have.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { startSite } from './talusd.mjs';

const PLAIN = 'radius=2&horizon=0&quality=low&frameRate=0.1';

/** Pairs of these boxes, by their ids, that are in sight and lie over each other. */
const overlaps = (page, ids) =>
  page.evaluate((ids) => {
    const boxes = ids
      .map((id) => document.getElementById(id))
      .filter((element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true }))
      .map((element) => ({ id: element.id, box: element.getBoundingClientRect() }));
    const found = [];
    for (const [i, a] of boxes.entries())
      for (const b of boxes.slice(i + 1))
        if (a.box.left < b.box.right && b.box.left < a.box.right && a.box.top < b.box.bottom && b.box.top < a.box.bottom) found.push(`${a.id} and ${b.id}`);
    return found;
  }, ids);
const ALWAYS = ['opening', 'hint', 'where', 'voxel', 'edit-open', 'thumbs', 'status', 'slice-said'];

/** Frames of the page, in which it looks at its sizes. */
const frames = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

for (const [screen, width, height, isTouch] of [
  ['a desk', 1440, 900, false],
  ['a window', 800, 500, false],
  ['a small window', 640, 400, false],
  ['a phone', 390, 844, true],
  ['a phone on its side', 844, 390, true],
  ['a small phone', 320, 400, true],
])
  test(`on ${screen} nothing lies over anything else`, async (t) => {
    const site = await startSite(t);
    const page = await newPage(await launch(t), { viewport: { width, height }, hasTouch: isTouch, isMobile: isTouch });
    let open;
    const opened = new Promise((resolve) => (open = resolve));
    await page.routeWebSocket(/v1\/stream/, (socket) => {
      const server = socket.connectToServer();
      socket.onMessage((message) => server.send(message));
      // The world itself comes: what stands on the page then, while there is no land.
      let isFirst = true;
      server.onMessage(async (message) => {
        if (!isFirst) await opened;
        isFirst = false;
        socket.send(message);
      });
    });
    await page.goto(`${site.url}#${PLAIN}&look=0,-60`);
    await page.waitForFunction(() => document.querySelector('#opening-text').textContent === 'The land is on its way');
    await frames(page);
    assert.deepEqual(await overlaps(page, ALWAYS), [], 'while the land comes');
    open();
    await filled(page);
    await page.waitForFunction(() => !document.getElementById('voxel').hidden);
    await page.waitForFunction(() => document.getAnimations().length === 0);
    assert.deepEqual(await overlaps(page, ALWAYS), [], 'with the land');
    await page.evaluate(() => document.getElementById('slice-on').click());
    assert.deepEqual(await overlaps(page, ALWAYS), [], 'with the land cut open');
    await page.evaluate(() => document.getElementById('slice-on').click());
    noProblems(page);
  });

test('a panel that is too tall scrolls, and shows that it does', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t), { viewport: { width: 800, height: 500 }, reducedMotion: 'reduce' });
  await page.goto(`${site.url}#${PLAIN}`);
  await filled(page);
  const hasSign = (id) => page.evaluate((id) => getComputedStyle(document.getElementById(id), '::after').content !== 'none', id);
  for (const [key, id] of [['KeyO', 'panel-settings'], ['KeyH', 'help']]) {
    await page.focus('#stage');
    await page.keyboard.press(key);
    await frames(page);
    const box = await page.locator(`#${id}`).boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= 500, `${id} is on the screen`);
    assert.ok(await hasSign(id), `${id} shows that there is more`);
    await page.evaluate((id) => document.getElementById(id).scrollTo(0, 1e6), id);
    await frames(page);
    assert.ok(!(await hasSign(id)), `${id} is at its end`);
    await page.keyboard.press('Escape');
  }
  await page.setViewportSize({ width: 800, height: 900 });
  await page.focus('#stage');
  await page.keyboard.press('KeyO');
  await frames(page);
  assert.ok(!(await hasSign('panel-settings')), 'all of it is there');
  noProblems(page);
});

test('no text is read through a panel', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(site.url);
  await page.waitForFunction(() => window.talus !== undefined);
  const grounds = await page.evaluate(() =>
    [...document.querySelectorAll('.panel, dialog, #notice, #opening')].map((box) => [box.id, getComputedStyle(box).backgroundColor]),
  );
  assert.ok(grounds.length >= 8);
  assert.deepEqual(grounds.filter(([, colour]) => !/^rgb\(/.test(colour)), []);
});

test('who asks for less motion sees no bar that does not move', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t), { reducedMotion: 'reduce' });
  await page.routeWebSocket(/v1\/stream/, () => {});
  await page.goto(`${site.url}#${PLAIN}`);
  await page.waitForFunction(() => window.talus !== undefined);
  assert.ok(await page.locator('#opening-text').isVisible());
  assert.ok(await page.locator('#opening-progress').isHidden());
});

test('the help of a phone speaks of fingers, that of a desk of keys', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  for (const [options, has, hasNot] of [
    [{ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, /thumb/, /Page up|Shift|\bEsc\b/],
    [{ viewport: { width: 1100, height: 760 } }, /Page up/, /thumb/],
  ]) {
    const page = await newPage(browser, options);
    await page.goto(`${site.url}#${PLAIN}`);
    await filled(page);
    await page.locator('#open-help').click();
    const text = await page.locator('#help').innerText();
    assert.match(text, has);
    assert.doesNotMatch(text, hasNot);
    noProblems(page);
    await page.context().close();
  }
});
