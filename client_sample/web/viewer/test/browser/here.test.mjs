// The viewer on a plain host of files, without a server of Talus: it makes the world, keeps edits, and opens worlds by link.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import { addressFollows, filled, launch, newPage, noProblems } from './browser.mjs';
import { readNpy } from './npy.mjs';
import { serveFiles } from './static_site.mjs';
import { DIST, scratch, talusGen } from './talusd.mjs';

const NEAR = 'radius=2&horizon=0&quality=low&frameRate=1';
/** The page asks once whether a server is there. */
const NO_SERVER = [/v1\/world/];
const spec = (name) => readFileSync(fileURLToPath(new URL(`../../../../../core/worlds/${name}.toml`, import.meta.url)), 'utf8');
const packed = (text) => deflateRawSync(text).toString('base64url');

let loads = 0;
/** Loads the page anew: a link alone would change the address. */
const load = (page, url, link) => page.goto(`${url}?${++loads}#${NEAR}${link}`);

async function open(page, url, link = '') {
  await load(page, url, link);
  await filled(page);
}

const fingerprint = (page) => page.evaluate(() => window.talus.engine.world.fingerprint);
const at = (page, voxel) => page.evaluate((v) => window.talus.engine.voxelAt(...v), voxel);
const becomes = (page, voxel, material) =>
  page.waitForFunction(([v, m]) => window.talus.engine?.voxelAt(...v) === m, [voxel, material]);
const answered = (page) => page.waitForFunction(() => window.talus.builder.waiting === 0 && window.talus.engine.predictions.size === 0);

/** Hovers over the ground at the spawn, looks down, and digs the voxel in view. */
async function dig(page) {
  const voxel = await page.evaluate(() => {
    const { engine, player } = window.talus;
    const { body } = player;
    const { x, y, z } = engine.world.spawn;
    body.mode = 'fly';
    body.place(x + 0.5, y + 5, z + 0.5);
    body.velocity.fill(0);
    [body.yaw, body.pitch] = [0, -80];
    const [ex, ey, ez] = body.eye;
    const pitch = (body.pitch * Math.PI) / 180;
    const hit = engine.raycast({ x: ex, y: ey, z: ez }, { x: 0, y: Math.sin(pitch), z: -Math.cos(pitch) }, 40);
    return [hit.x, hit.y, hit.z];
  });
  await page.focus('#stage');
  if (await page.locator('#edit-bar').isHidden()) await page.keyboard.press('KeyV');
  await page.locator('#edit-bar').waitFor();
  await page.evaluate(() => window.talus.builder.choose('dig'));
  await page.keyboard.press('Enter');
  await becomes(page, voxel, 0);
  await answered(page);
  return voxel;
}

test('a page without a server', async (t) => {
  const url = await serveFiles(t, DIST);
  const browser = await launch(t);
  const page = await newPage(browser);
  await open(page, url);

  await t.test('its voxels are those of talus-gen export', async (t) => {
    const spawn = await page.evaluate(() => window.talus.engine.world.spawn);
    const origin = { x: spawn.x - 32, z: spawn.z - 32 };
    const folder = scratch(t);
    talusGen('export', '--origin', `${origin.x},${origin.z}`, '--size', '64,64', '-o', folder);
    const { shape, values } = readNpy(`${folder}/voxels.npy`);
    const { y0 } = JSON.parse(readFileSync(`${folder}/export.json`, 'utf8'));
    const [rows, depth, width] = shape;
    const low = Math.max(y0, spawn.y - 24);
    const seen = await page.evaluate(
      ([{ x, z }, low, width, depth]) => {
        const all = [];
        for (let y = low; y < low + 48; ++y)
          for (let dz = 0; dz < depth; ++dz) for (let dx = 0; dx < width; ++dx) all.push(window.talus.engine.voxelAt(x + dx, y, z + dz) ?? -1);
        return all;
      },
      [origin, low, width, depth],
    );
    const expected = seen.map((_, i) => {
      const y = low + Math.floor(i / (width * depth)) - y0;
      return y < rows ? values[y * width * depth + (i % (width * depth))] : 0;
    });
    assert.ok(new Set(seen).size > 3);
    assert.deepEqual(seen, expected);
  });

  let dug;
  await t.test('what is dug is kept, and undone', async () => {
    dug = await dig(page);
    const second = await page.evaluate(() => window.talus.engine.world.spawn);
    await page.reload();
    await filled(page);
    assert.equal(await at(page, dug), 0);
    assert.deepEqual(await page.evaluate(() => window.talus.engine.world.spawn), second);
    const more = await dig(page);
    assert.notDeepEqual(more, dug);
    await page.keyboard.press('KeyZ');
    await page.waitForFunction((v) => window.talus.engine.voxelAt(...v) !== 0, more);
    await answered(page);
  });

  await t.test('another tab has it, and both see what the other digs', async () => {
    const other = await page.context().newPage();
    other.problems = [];
    await open(other, url);
    assert.equal(await at(other, dug), 0);
    const next = await dig(other);
    await becomes(page, next, 0);
    await becomes(other, await dig(page), 0);
    await other.close();
  });

  await t.test('the map is drawn, and leads elsewhere', async () => {
    await page.keyboard.press('KeyM');
    await page.locator('#map canvas').waitFor();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => / · ground at \d+/.test(document.querySelector('.map-at').textContent));
    const before = await page.evaluate(() => window.talus.player.body.position[0]);
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.getElementById('map').hidden);
    await page.waitForFunction((x) => window.talus.player.body.position[0] !== x, before);
  });

  await t.test('the map stands alone, too', async () => {
    const map = await newPage(browser);
    await map.goto(`${url}map.html#world=hills`);
    await map.waitForFunction(() => window.talusMap?.missing === 0);
    noProblems(map, NO_SERVER);
  });
  noProblems(page, NO_SERVER);
});

test('worlds by link', async (t) => {
  const url = await serveFiles(t, DIST);
  const browser = await launch(t);
  const page = await newPage(browser);
  await open(page, url, '&world=hills');
  const hills = await fingerprint(page);
  await addressFollows(page);
  assert.match(await page.evaluate(() => location.hash), /world=hills/);
  noProblems(page); // a link's world is nobody else's, so no server is asked

  await t.test('packed', async () => {
    await open(page, url, `&world=${packed(spec('hills'))}`);
    assert.equal(await fingerprint(page), hills);
    await open(page, url, `&world=${packed(spec('hills').replace(/seed = \d+/, 'seed = 4711'))}`);
    assert.notEqual(await fingerprint(page), hills);
  });

  await t.test('with the models that it names', async () => {
    await open(page, url, `&world=${packed(spec('features'))}`);
    noProblems(page);
  });

  await t.test('those that open none say why', async () => {
    for (const [link, words] of [
      ['mes+as%20', /neither a known name nor base64url: character 4 is ' '/],
      ['', /#world= is empty/],
      ['aGVsbG8', /neither a known name nor a packed world file/],
      [packed(spec('hills')).slice(0, 400), /cut off or changed/],
      [packed(Buffer.alloc((1 << 20) + 1, 0x23)), /larger than 1048576 bytes/],
      [packed(Buffer.alloc(1 << 28, 0x23)), /larger than 1048576 bytes/],
      [packed('seed = 1\nresolution = = 2\n'), /wrong, line 2, column \d+: resolution/],
      [packed('resolution = 1\nseed   = "seven"\n'), /line 2, column 10: seed: 'seven' is a string; an integer is needed/],
      [packed('a = "\u{1f4a5}'.repeat(10)), /line 1/],
    ]) {
      await load(page, url, `&world=${link}`);
      await page.locator('#notice[data-kind=no-world]').waitFor();
      assert.match(await page.locator('#notice-text').textContent(), words);
    }
    await page.locator('#notice-actions button').click();
    await filled(page);
    noProblems(page, NO_SERVER);
  });

  await t.test('another link in the bar opens its world', async () => {
    await page.evaluate((near) => void (location.hash = `#${near}&world=hills`), NEAR);
    await page.waitForFunction((f) => window.talus?.engine?.world.fingerprint === f, hills);
  });
});

test('where the browser keeps nothing, it says so, and one plays on', async (t) => {
  const url = await serveFiles(t, DIST);
  const page = await newPage(await launch(t));
  await page.addInitScript(() => {
    indexedDB.open = () => {
      throw new DOMException('The user denied permission', 'SecurityError');
    };
  });
  await open(page, url, '&world=hills');
  await page.locator('#notice[data-kind=not-kept]').waitFor();
  assert.match(await page.locator('#notice-text').textContent(), /until the page is closed: The user denied permission/);
  await page.locator('#notice-actions button').click();
  assert.equal(await at(page, await dig(page)), 0);
  noProblems(page);
});

test('where its storage is full, it says so, and one plays on', async (t) => {
  const url = await serveFiles(t, DIST);
  const page = await newPage(await launch(t));
  await page.addInitScript(() => {
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = function (...row) {
      if (this.name === 'chunks') throw new DOMException('The quota is exceeded', 'QuotaExceededError');
      return put.apply(this, row);
    };
  });
  await open(page, url, '&world=hills');
  assert.equal(await at(page, await dig(page)), 0);
  await page.locator('#notice[data-kind=not-kept]').waitFor();
  assert.match(await page.locator('#notice-text').textContent(), /until the page is closed: The quota is exceeded/);
  const later = await dig(page);
  assert.equal(await at(page, later), 0);
  noProblems(page);
});
