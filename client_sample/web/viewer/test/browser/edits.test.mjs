// Two browsers in one world: one digs and builds, the other sees it; it outlives talusd. And who may not is told so.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import test from 'node:test';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { scratch, startSite } from './talusd.mjs';

const AWAY = [/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|WebSocket connection|502/];
/** Small, plain and seldom drawn, as in the other tests; and no more land than is worked on. */
const NEAR = 'radius=2&horizon=0&quality=low&frameRate=1';
const WINDOW = { viewport: { width: 400, height: 300 } };

/** Arguments of a talusd whose players without a token have these rights. */
function withRights(t, rights, ...more) {
  const folder = scratch(t);
  writeFileSync(`${folder}/talusd.toml`, `[access]\nwithout_token = "${rights}"\n`);
  return ['--config', `${folder}/talusd.toml`, ...more];
}

async function open(t, site, options = WINDOW, browser = null) {
  const page = await newPage(browser ?? (await launch(t)), options);
  await page.goto(`${site.url}#${NEAR}`);
  await filled(page);
  return page;
}

/** Hovers before the ground near the spawn, `dx` blocks east of it, and looks down at it. Gives what is under the crosshair. */
async function hover(page, dx = 0) {
  await page.evaluate((dx) => {
    const { engine, player } = window.talus;
    const { x, z } = engine.world.spawn;
    const { body } = player;
    body.mode = 'fly';
    let y = engine.world.spawn.y + 40;
    while (!engine.isSolid(engine.voxelAt(x + dx, y, z - 4) ?? 0)) --y;
    body.place(x + dx + 0.5, y + 5, z + 0.5);
    body.velocity.fill(0);
    [body.yaw, body.pitch] = [0, -55];
  }, dx);
  return ahead(page);
}

/** Of the first solid voxel under the crosshair: itself, its material, the voxel before its face. */
const ahead = (page) =>
  page.evaluate(() => {
    const { engine, player } = window.talus;
    const [x, y, z] = player.body.eye;
    const pitch = (player.body.pitch * Math.PI) / 180;
    const yaw = (player.body.yaw * Math.PI) / 180;
    const direction = { x: Math.sin(yaw) * Math.cos(pitch), y: Math.sin(pitch), z: -Math.cos(yaw) * Math.cos(pitch) };
    const hit = engine.raycast({ x, y, z }, direction, 40);
    const voxel = [hit.x, hit.y, hit.z];
    return { voxel, material: hit.material, before: [hit.x + hit.normal.x, hit.y + hit.normal.y, hit.z + hit.normal.z] };
  });

const at = (page, voxel) => page.evaluate((v) => window.talus.engine.voxelAt(...v), voxel);
const becomes = (page, voxel, material) =>
  page.waitForFunction(([v, m]) => window.talus.engine?.voxelAt(...v) === m, [voxel, material]);
/** All that this player did is answered, and shown as the server has it. */
const answered = (page) => page.waitForFunction(() => window.talus.builder.waiting === 0 && window.talus.engine.predictions.size === 0);
const said = (page, words) => page.waitForFunction((text) => document.getElementById('edit-said').textContent.includes(text), words);
async function beginBuilding(page) {
  await page.focus('#stage');
  await page.keyboard.press('KeyV');
  await page.locator('#edit-bar').waitFor();
}
async function choose(page, index) {
  await page.keyboard.press(`Digit${index + 1}`);
  return page.evaluate(() => window.talus.builder.material);
}
const tool = (page, name) => page.evaluate((to) => window.talus.builder.choose(to), name);

test('one digs and builds, the other sees it, and it outlives talusd', async (t) => {
  const site = await startSite(t, withRights(t, 'read,edit', '--data', scratch(t)));
  const [one, two] = await Promise.all([open(t, site), open(t, site)]);
  await beginBuilding(one);

  const hole = (await hover(one)).voxel;
  await t.test('digging', async () => {
    await one.keyboard.press('Enter');
    assert.equal(await at(one, hole), 0, 'shown before the server has answered');
    const began = performance.now();
    await becomes(two, hole, 0);
    t.diagnostic(`seen by the other after ${Math.round(performance.now() - began)} ms`);
    await answered(one);
  });

  let wall;
  await t.test('building, by the material of a key', async () => {
    const { before } = await hover(one, 6);
    wall = { voxel: before, material: await choose(one, 2) };
    assert.notEqual(wall.material, 0);
    assert.equal(await one.evaluate(() => window.talus.builder.tool), 'build');
    await one.keyboard.press('Enter');
    await becomes(two, wall.voxel, wall.material);
    await answered(one);
  });

  await t.test('by mouse: the click that takes the pointer does nothing else; the right button does the opposite', async () => {
    const { voxel, material } = await hover(one, 10);
    await tool(one, 'build');
    await one.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    await one.mouse.click(200, 150);
    await one.waitForFunction(() => document.pointerLockElement !== null);
    assert.equal(await at(one, voxel), material);
    await one.mouse.click(200, 150, { button: 'right' });
    await becomes(two, voxel, 0);
    await one.keyboard.press('Backspace');
    await answered(one);
    await one.evaluate(() => document.exitPointerLock());
  });

  await t.test('a fill between two corners, and its undoing, but for what the other changed since', async () => {
    const from = (await hover(one, 16)).before;
    await tool(one, 'fill');
    const material = await choose(one, 3);
    await one.keyboard.press('Enter');
    await said(one, 'other corner');
    const to = (await hover(one, 19)).before;
    const box = [0, 1, 2].map((axis) => [Math.min(from[axis], to[axis]), Math.max(from[axis], to[axis])]);
    const materials = (page) =>
      page.evaluate(([[x0, x1], [y0, y1], [z0, z1]]) => {
        const all = [];
        for (let y = y0; y <= y1; ++y) for (let z = z0; z <= z1; ++z) for (let x = x0; x <= x1; ++x) all.push(window.talus.engine.voxelAt(x, y, z));
        return all;
      }, box);
    const before = await materials(one);
    await one.keyboard.press('Enter');
    await becomes(two, from, material);
    await becomes(two, to, material);
    assert.deepEqual(new Set(await materials(two)), new Set([material]));
    await answered(one);
    // The other digs a corner of it.
    await beginBuilding(two);
    await hover(two, 16);
    const corner = (await ahead(two)).voxel;
    assert.deepEqual(corner, from);
    await tool(two, 'dig');
    await two.keyboard.press('Enter');
    await becomes(one, corner, 0);
    await one.keyboard.press('KeyZ');
    await said(one, 'but for 1 voxel');
    await answered(one);
    const place = box.map(([low], axis) => corner[axis] - low);
    const width = box.map(([low, high]) => high - low + 1);
    const index = (place[1] * width[2] + place[2]) * width[0] + place[0];
    const after = before.map((each, i) => (i === index ? 0 : each));
    assert.deepEqual(await materials(one), after);
    await two.waitForFunction(
      ([[[x0, x1], [y0, y1], [z0, z1]], wanted]) => {
        const all = [];
        for (let y = y0; y <= y1; ++y) for (let z = z0; z <= z1; ++z) for (let x = x0; x <= x1; ++x) all.push(window.talus.engine.voxelAt(x, y, z));
        return all.join() === wanted.join();
      },
      [box, after],
    );
  });

  await t.test('nobody builds into himself', async () => {
    const { voxel } = await hover(one, 22);
    await tool(one, 'build');
    await one.evaluate(([x, y, z]) => {
      const { body } = window.talus.player;
      body.place(x + 0.5, y + 1, z + 0.5);
      [body.yaw, body.pitch] = [0, -89];
    }, voxel);
    const target = (await ahead(one)).before;
    const was = await at(one, target);
    await one.keyboard.press('Enter');
    await said(one, 'You stand there');
    assert.equal(await at(one, target), was);
  });

  let late;
  await t.test('talusd is killed; what is dug meanwhile waits, and is done by the next', async () => {
    await site.talusd.kill();
    await one.locator('#notice[data-kind=away]').waitFor();
    late = await hover(one, 26);
    await tool(one, 'dig');
    await one.keyboard.press('Enter');
    assert.equal(await at(one, late.voxel), 0);
    await one.locator('#edit-waiting').waitFor();
    assert.equal(await at(two, late.voxel), late.material);
    await site.restart();
    for (const page of [one, two]) await page.locator('#notice').waitFor({ state: 'hidden' });
    await becomes(two, late.voxel, 0);
    await answered(one);
  });

  await t.test('all of it is still there, for who comes now too', async () => {
    const three = await open(t, site, WINDOW, two.context().browser());
    for (const page of [one, two, three]) {
      await filled(page);
      assert.equal(await at(page, hole), 0);
      assert.equal(await at(page, wall.voxel), wall.material);
      assert.equal(await at(page, late.voxel), 0);
    }
    noProblems(three);
  });

  noProblems(one, AWAY);
  noProblems(two, AWAY);
});

test('by fingers: a tap digs where it hits', async (t) => {
  const site = await startSite(t, withRights(t, 'read,edit', '--data', scratch(t)));
  const page = await open(t, site, { viewport: { width: 400, height: 640 }, hasTouch: true, isMobile: true });
  const { voxel } = await hover(page);
  await page.locator('#thumb-edit').tap();
  await page.locator('#edit-bar').waitFor();
  const boxes = await page.locator('#edit-bar button, #thumbs button').evaluateAll((all) => all.map((b) => b.getBoundingClientRect()).map(({ width, height }) => [width, height]));
  for (const [width, height] of boxes) assert.ok(width >= 40 && height >= 40, 'a finger hits it');
  // A page that is busy hears late of the finger's lifting, and takes it for a long press: then once more.
  for (let taps = 0; taps < 10 && (await at(page, voxel)) !== 0; ++taps) await page.touchscreen.tap(200, 320);
  await becomes(page, voxel, 0);
  await answered(page);
  await page.locator('#edit-palette button').nth(2).tap();
  assert.equal(await page.evaluate(() => window.talus.builder.tool), 'build');
  await page.locator('#edit-undo').tap();
  await page.waitForFunction((v) => window.talus.engine.voxelAt(...v) !== 0, voxel);
  await page.locator('#edit-close').tap();
  await page.locator('#edit-bar').waitFor({ state: 'hidden' });
  noProblems(page);
});

test('where the server protects the land, who digs is told so, and what was dug is there again', async (t) => {
  const folder = scratch(t);
  writeFileSync(`${folder}/talusd.toml`, '[access]\nwithout_token = "read,edit"\n[edits]\nprotect_spawn = 100\n');
  const site = await startSite(t, ['--config', `${folder}/talusd.toml`, '--data', scratch(t)]);
  const page = await open(t, site);
  const { voxel, material } = await hover(page);
  await beginBuilding(page);
  await page.keyboard.press('Enter');
  await said(page, 'which this server protects');
  await answered(page);
  await becomes(page, voxel, material);
  assert.ok(await page.locator('#edit-bar').isVisible(), 'elsewhere one may dig');
  noProblems(page);
});

for (const [name, args, words] of [
  ['a player without the right', (t) => withRights(t, 'read', '--data', scratch(t)), 'only invited players build'],
  ['a server that stores nothing', (t) => withRights(t, 'read,edit'), 'keeps no edits'],
])
  test(`${name} gets no tools, and is told why`, async (t) => {
    const site = await startSite(t, args(t));
    const page = await open(t, site);
    await page.waitForFunction((words) => document.getElementById('edit-open').title.includes(words), words);
    assert.equal(await page.locator('#edit-open').getAttribute('aria-disabled'), 'true');
    await page.focus('#stage');
    await page.keyboard.press('KeyV');
    await said(page, words);
    assert.ok(await page.locator('#edit-said').isVisible());
    assert.ok(await page.locator('#edit-bar').isHidden());
    noProblems(page);
  });
