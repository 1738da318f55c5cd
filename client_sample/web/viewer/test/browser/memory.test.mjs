// Memory: of a wide view, and of a flight of ten minutes, in which it stays flat.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { memory } from './memory.mjs';
import { startSite } from './talusd.mjs';

const megabytes = (sizes) => Object.entries(sizes).map(([name, bytes]) => `${name} ${(bytes / 1e6).toFixed(1)}`).join(', ');

test('radius 12 and a horizon of 4 km within 1 GB', async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#radius=12&horizon=4096&quality=high&frameRate=0.02`);
  await filled(page);
  const now = await memory(page);
  t.diagnostic(`MB: ${megabytes(now)}`);
  // Where a card draws, meshes are in its memory, and the process that speaks to it holds little.
  assert.ok(now.renderer + now.meshes <= 1e9, `the page's process and its meshes: ${now.renderer + now.meshes} bytes`);
  noProblems(page);
});

/** TALUS_FLIGHT_MINUTES: fewer, at least 5, for somebody who waits for it. */
const MINUTES = Number(process.env.TALUS_FLIGHT_MINUTES ?? 10);
const SPEED = 24; // blocks a second

/** Once around a circle that takes a minute: nothing of the view is in the view from its other side. */
const minute = (page) =>
  page.evaluate(async (round) => {
    const { body } = window.talus.player;
    const [x, y, z] = body.position;
    const away = round / (2 * Math.PI);
    let flown = 0;
    for (let then = performance.now(); flown < 60_000; ) {
      const now = await new Promise(requestAnimationFrame);
      // A page that was kept from its turn flies no faster for it.
      flown += Math.min(100, Math.max(0, now - then));
      then = now;
      const angle = (flown / 60_000) * 2 * Math.PI;
      body.place(x - away + away * Math.cos(angle), y, z + away * Math.sin(angle));
    }
    body.place(x, y, z);
  }, SPEED * 60);

test(`memory stays flat from minute 2 to minute ${MINUTES} of flying`, async (t) => {
  assert.ok(MINUTES >= 5, `TALUS_FLIGHT_MINUTES is ${process.env.TALUS_FLIGHT_MINUTES}: a number, at least 5`);
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#radius=3&horizon=256&quality=low&frameRate=1`);
  await filled(page);
  const samples = [];
  for (let flown = 1; flown <= MINUTES; ++flown) {
    await minute(page);
    await filled(page);
    if (flown < 2) continue;
    samples.push(await memory(page));
    t.diagnostic(`minute ${flown}, MB: ${megabytes(samples.at(-1))}`);
  }
  // An allocator gives back late: of the first two and of the last two the least counts.
  const least = (some, name) => Math.min(...some.map((sample) => sample[name]));
  for (const name of ['page', 'workers', 'renderer', 'meshes', 'held']) {
    const [early, late] = [least(samples.slice(0, 2), name), least(samples.slice(-2), name)];
    assert.ok(late <= early * 1.05, `${name} grew from ${early} to ${late} bytes`);
  }
  noProblems(page);
});
