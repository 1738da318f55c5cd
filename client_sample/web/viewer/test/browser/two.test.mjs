// Two browsers at once in the world of one talusd that speaks TLS: one by https and wss, one through a front without TLS.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems, SMALL, stats } from './browser.mjs';
import { serve } from './site.mjs';
import { DIST, startTalusd, tlsFlags } from './talusd.mjs';

/** Materials of the base voxels around the spawn. */
const landOf = (page) =>
  page.evaluate(() => {
    const { engine } = window.talus;
    const { x, y, z } = engine.world.spawn;
    const all = [];
    for (let dy = -20; dy < 12; ++dy) for (let dz = -40; dz < 40; ++dz) for (let dx = -40; dx < 40; ++dx) all.push(engine.voxelAt(x + dx, y + dy, z + dz) ?? -1);
    return all;
  });

/** What the card says of the voxels under some pixels. */
async function picked(page) {
  await page.evaluate(() => {
    const { body } = window.talus.player;
    [body.yaw, body.pitch] = [30, -55];
  });
  const cards = [];
  for (const [x, y] of [[160, 120], [90, 150], [230, 170], [160, 200], [110, 100]]) {
    await page.evaluate(([x, y]) => window.talus.pick(x, y), [x, y]);
    const isHidden = await page.locator('#voxel').isHidden();
    cards.push(isHidden ? null : `${await page.locator('#voxel-at').textContent()}: ${await page.locator('#voxel-name').textContent()}`);
  }
  return cards;
}

test('two browsers, one of them by TLS', async (t) => {
  const talusd = await startTalusd({ args: tlsFlags(t) });
  t.after(() => talusd.stop());
  const front = await serve(DIST, () => talusd.http, { tls: true });
  t.after(() => front.close());
  const sockets = [];
  const open = async (url, args, transport) => {
    const page = await newPage(await launch(t, args));
    page.on('websocket', (socket) => sockets.push(new URL(socket.url()).protocol));
    await page.goto(`${url}#${SMALL}&transport=${transport}`);
    return page;
  };
  const secure = `https://${talusd.http}/`;
  const pages = await Promise.all([
    open(front.url, [], 'websocket'),
    open(secure, ['--ignore-certificate-errors'], 'websocket'),
    open(secure, ['--ignore-certificate-errors'], 'http'),
  ]);
  await Promise.all(pages.map(filled));
  assert.deepEqual(sockets.sort(), ['ws:', 'wss:']);

  const [plain, ...others] = await Promise.all(pages.map(landOf));
  assert.ok(new Set(plain).size >= 3 && !plain.includes(-1), 'several materials, and all of it is here');
  for (const land of others) assert.ok(land.every((material, i) => material === plain[i]), 'the same land');
  const chunks = await Promise.all(pages.map(async (page) => (await stats(page)).chunks));
  assert.deepEqual(chunks, chunks.map(() => chunks[0]));

  const [first, ...more] = await Promise.all(pages.map(picked));
  assert.ok(first.filter(Boolean).length >= 3, `picked ${first}`);
  for (const cards of more) assert.deepEqual(cards, first);
  for (const page of pages) noProblems(page);
});
