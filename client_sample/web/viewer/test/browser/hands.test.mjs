// By keyboard alone, and by fingers alone.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems, place, SMALL } from './browser.mjs';
import { startSite } from './talusd.mjs';

const focused = (page) => page.evaluate(() => document.activeElement?.id || document.activeElement?.tagName);

test('keyboard alone suffices', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  assert.equal(await focused(page), 'stage');

  await t.test('moving and looking', async () => {
    const before = await place(page);
    const until = async (key, isDone) => {
      await page.keyboard.down(key);
      await page.waitForFunction(isDone, before);
      await page.keyboard.up(key);
    };
    await until('ArrowRight', (was) => Math.abs(window.talus.player.body.yaw - was.yaw) > 20);
    await until('PageDown', (was) => window.talus.player.body.pitch < was.pitch - 10);
    await until('KeyW', (was) => Math.hypot(window.talus.player.body.position[0] - was.x, window.talus.player.body.position[2] - was.z) > 5);
    await until('Space', (was) => window.talus.player.body.position[1] > was.y + 2);
    await page.keyboard.press('Home');
    await page.waitForFunction(() => window.talus.player.body.pitch === 0);
    await page.keyboard.press('KeyF');
    assert.equal((await place(page)).mode, 'walk');
    await page.keyboard.press('KeyF');
  });

  await t.test('going to a coordinate', async () => {
    await page.keyboard.press('KeyG');
    assert.equal(await focused(page), 'goto-text');
    await page.keyboard.type('nowhere');
    await page.keyboard.press('Enter');
    assert.match(await page.locator('#goto-wrong').textContent(), /numbers/);
    await page.keyboard.press('Control+A');
    await page.keyboard.type('1200 300 -340');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.talus.player.body.position[0] === 1200);
    assert.equal(await focused(page), 'stage');
    await filled(page);
  });

  await t.test('panels, help and their focus', async () => {
    for (const key of ['KeyT', 'KeyO', 'KeyK']) {
      await page.keyboard.press(key);
      assert.equal(await page.locator('.panel:visible').count(), 1, key);
      await page.keyboard.press('Escape');
      assert.equal(await page.locator('.panel:visible').count(), 0, key);
      assert.equal(await focused(page), 'stage');
    }
    await page.keyboard.press('KeyH');
    assert.ok(await page.locator('#help').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#help').isHidden());
    // A slider that has the focus keeps the arrows for itself.
    await page.keyboard.press('KeyT');
    const { yaw } = await place(page);
    await page.keyboard.press('ArrowRight');
    assert.equal((await place(page)).yaw, yaw);
    await page.keyboard.press('Escape');
  });

  await t.test('slice, borders, time', async () => {
    const { pitch: pitchBefore } = await place(page);
    const seen = await page.evaluate(() => {
      const { engine, player } = window.talus;
      player.body.pitch = -60; // at the ground
      const [x, y, z] = player.body.eye;
      const [yaw, pitch] = [player.body.yaw, player.body.pitch].map((degrees) => (degrees * Math.PI) / 180);
      const ahead = { x: Math.sin(yaw) * Math.cos(pitch), y: Math.sin(pitch), z: -Math.cos(yaw) * Math.cos(pitch) };
      return engine.raycast({ x, y, z }, ahead, 256, true).distance * Math.cos(pitch);
    });
    await page.keyboard.press('KeyX');
    assert.ok(await page.locator('#slice-on').isChecked());
    const distance = Number(await page.locator('#slice-distance').inputValue());
    assert.ok(Math.abs(distance - Math.max(seen, 4)) <= 1, `the cut is ${distance} blocks ahead, what one looks at ${seen}`);
    await page.evaluate((pitch) => (window.talus.player.body.pitch = pitch), pitchBefore);
    assert.match(await page.locator('#slice-said').innerText(), /before the cut is hidden.*\[.*\].*X ends it/s);
    await page.keyboard.press('BracketRight');
    assert.equal(await page.locator('#slice-distance').inputValue(), String(distance + 1));
    await page.keyboard.press('KeyX');
    assert.ok(!(await page.locator('#slice-on').isChecked()));
    assert.ok(await page.locator('#slice-said').isHidden());
    await page.keyboard.press('KeyB');
    assert.ok(await page.locator('#borders').isChecked());
    await page.keyboard.press('KeyB');
    const hours = async () => Number(await page.locator('#time').inputValue());
    const before = await hours();
    await page.keyboard.press('Period');
    assert.ok(Math.abs((await hours()) - before - 0.25) < 0.03);
  });

  await t.test('tabbing reaches every tool, in order, with a focus that one sees', async () => {
    const reached = [];
    const tools = await page.locator('.tools button').evaluateAll((all) => all.map((b) => b.getAttribute('aria-label')));
    await page.focus('#stage');
    for (let i = 0; i < tools.length; ++i) {
      await page.keyboard.press('Tab');
      reached.push(await page.evaluate(() => document.activeElement.getAttribute('aria-label')));
      const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
      assert.equal(outline, 'solid', reached.at(-1));
    }
    assert.deepEqual(reached, tools);
  });

  await t.test('the map', async () => {
    await page.focus('#stage');
    await page.keyboard.press('KeyM');
    await page.locator('#map canvas').waitFor();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    const before = await place(page);
    await page.keyboard.press('Enter');
    await page.locator('#map').waitFor({ state: 'hidden' });
    const after = await place(page);
    assert.ok(after.x > before.x + 100, `from ${before.x} to ${after.x}`);
    assert.equal(await focused(page), 'stage');
    await page.keyboard.press('KeyM');
    await page.locator('#map canvas').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('#map').waitFor({ state: 'hidden' });
  });

  noProblems(page, [/\/map\/.* 404|404 \(Not Found\)/]);
});

test('touch alone suffices', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  const page = await newPage(browser, { viewport: { width: 320, height: 400 }, hasTouch: true, isMobile: true });
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y, id = 0]) => ({ x, y, id })) });

  await t.test('a tap picks', async () => {
    await page.locator('#hint-close').dispatchEvent('click');
    await page.evaluate(() => {
      window.talus.player.body.pitch = -70;
    });
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    // A page that is busy hears late of the finger's lifting, and takes it for a long press: then once more.
    for (let taps = 0; taps < 10 && (await page.locator('#voxel-close').isHidden()); ++taps) await page.touchscreen.tap(175, 225);
    await page.locator('#voxel-close').waitFor();
    assert.notEqual(await page.locator('#voxel-name').textContent(), '');
    await page.locator('#voxel-close').tap();
    await page.locator('#voxel-close').waitFor({ state: 'hidden' });
  });

  await t.test('the left thumb moves', async () => {
    const before = await place(page);
    await touch('touchStart', [80, 200]);
    await touch('touchMove', [80, 140]);
    assert.equal(await page.locator('#stick[hidden]').count(), 0);
    await page.waitForFunction((was) => Math.hypot(window.talus.player.body.position[0] - was.x, window.talus.player.body.position[2] - was.z) > 3, before);
    await touch('touchEnd');
    assert.equal(await page.locator('#stick[hidden]').count(), 1);
  });

  await t.test('the right thumb looks, while the left moves', async () => {
    const before = await place(page);
    await touch('touchStart', [80, 200, 0]);
    await touch('touchStart', [80, 200, 0], [220, 160, 1]);
    await touch('touchMove', [80, 160, 0], [250, 145, 1]);
    await page.waitForFunction((was) => Math.abs(window.talus.player.body.yaw - was.yaw) > 3, before);
    await touch('touchEnd');
    const after = await place(page);
    assert.ok(after.pitch > before.pitch, 'up is up');
  });

  await t.test('buttons rise and change between walking and flying', async () => {
    const before = await place(page);
    const { x, y, width, height } = await page.locator('#thumb-up').boundingBox();
    await touch('touchStart', [x + width / 2, y + height / 2]);
    await page.waitForFunction((was) => window.talus.player.body.position[1] > was.y + 1, before);
    await touch('touchEnd');
    await page.locator('#thumb-mode').tap();
    assert.equal((await place(page)).mode, 'walk');
  });

  await t.test('how far one may look is capped, and said where one sets it', async () => {
    assert.equal(await page.locator('#settings-cap[hidden]').count(), 0);
    assert.match(await page.locator('#settings-cap').textContent(), /at most (6|10) chunks/);
    const most = await page.locator('#settings [name=radius]').evaluate((slider) => Number(slider.max));
    assert.ok(most <= 10, `${most} chunks`);
    const other = await newPage(browser, { viewport: { width: 320, height: 400 }, hasTouch: true, isMobile: true });
    await other.goto(`${site.url}#radius=24&horizon=16384&frameRate=1`);
    const { radius, horizon } = await other.evaluate(() => window.talus.settings);
    assert.ok(radius === most && horizon <= 4096, `a link goes beyond it: ${radius}, ${horizon}`);
    await other.context().close();
  });

  await t.test('everything fits on the screen', async () => {
    const { scroll, client } = await page.evaluate(() => ({ scroll: document.documentElement.scrollWidth, client: document.documentElement.clientWidth }));
    assert.ok(scroll <= client, `${scroll} pixels wide on ${client}`);
    const tools = await page.locator('.tools button').evaluateAll((all) => all.map((b) => b.getBoundingClientRect()).map(({ left, right, width, height }) => ({ left, right, width, height })));
    for (const { left, right, width, height } of tools) {
      assert.ok(left >= 0 && right <= 320);
      assert.ok(width >= 36 && height >= 40, 'a finger hits it');
    }
  });

  noProblems(page);
});
