// What a view costs: time to the first terrain and to all of it, triangles, draw calls, processor time a frame. Times are
// judged by ./dev bench alone, on a machine without other work.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { filled, launch, newPage, noProblems, stats } from './browser.mjs';
import { startSite } from './talusd.mjs';

const judgesTimes = Boolean(process.env.TALUS_BENCH);
const world = (name) => fileURLToPath(new URL(`../../../../../core/worlds/${name}.toml`, import.meta.url));

test('from the address to the first terrain, and to all of it', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  // Software draws on the cores that everything else needs: one picture a second is drawn while the view fills.
  const times = [];
  for (let i = 0; i < 3; ++i) {
    const page = await newPage(browser);
    await page.goto(`${site.url}#radius=8&horizon=0&quality=low&frameRate=1`);
    await filled(page);
    await page.waitForFunction(() => performance.getEntriesByName('talus:complete').length > 0);
    times.push(await page.evaluate(() => Object.fromEntries(performance.getEntriesByType('mark').map((m) => [m.name, m.startTime]))));
    noProblems(page);
    await page.context().close();
  }
  for (const { 'talus:first': first, 'talus:complete': complete } of times)
    t.diagnostic(`first terrain submitted after ${Math.round(first)} ms, all of radius 8 after ${Math.round(complete)} ms`);
  if (!judgesTimes) return;
  const best = (name) => Math.min(...times.map((marks) => marks[name]));
  // A machine that is busy with other things says nothing: the best of three counts.
  assert.ok(best('talus:first') <= 1000, 'first terrain within 1 s');
  assert.ok(best('talus:complete') <= 3000, 'radius 8 within 3 s');
});

/** What is drawn is handed over whole, with all its ranges, but of no quads. Software takes seconds for such a picture,
 *  by the cores and the caches that the page runs on: no page that a card draws has that beside it. */
const leaveOutCard = (page) =>
  page.evaluate(() => {
    const multiDraw = document.getElementById('view').getContext('webgl2').getExtension('WEBGL_multi_draw');
    const { multiDrawElementsWEBGL } = multiDraw;
    let none = new Int32Array(1024);
    window.draws = window.ranges = 0;
    multiDraw.multiDrawElementsWEBGL = (mode, counts, at, type, starts, startsAt, ranges) => {
      if (none.length < counts.length) none = new Int32Array(counts.length);
      ++window.draws;
      window.ranges += ranges;
      multiDrawElementsWEBGL.call(multiDraw, mode, none, at, type, starts, startsAt, ranges);
    };
  });

/** So many frames of the page's own loop, as fast as the display asks for them. One turns by `yaw` degrees in each, and
 *  flies `ahead` blocks. */
const frames = (page, count, yaw, ahead) =>
  page.evaluate(
    async ([count, yaw, ahead]) => {
      const { settings, player } = window.talus;
      const { body } = player;
      const [x, y, z] = body.position;
      const angle = (body.yaw * Math.PI) / 180;
      settings.frameRate = 0;
      await new Promise((done) => {
        let taken = 0;
        const read = () => {
          if (taken > count) return;
          body.yaw += yaw;
          const flown = ahead * taken;
          if (ahead > 0) body.place(x + flown * Math.sin(angle), y, z - flown * Math.cos(angle));
          if (++taken > count) done();
        };
        player.add({ read, release() {} });
      });
      settings.frameRate = 0.02;
    },
    [count, yaw, ahead],
  );

/** Processor time of the page's own thread, in milliseconds: in each frame's turn, and in all it does until the next. */
async function frameTimes(page, ...of) {
  const browser = page.context().browser();
  await browser.startTracing(page, { categories: ['devtools.timeline', 'toplevel'] });
  await frames(page, ...of);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const turns = traceEvents.filter(({ name }) => name === 'FireAnimationFrame').sort((a, b) => a.ts - b.ts);
  const tasks = traceEvents.filter((e) => e.name.endsWith('RunTask') && e.tdur > 0 && e.pid === turns[0].pid && e.tid === turns[0].tid);
  const whole = turns.slice(1).map(({ ts }, i) =>
    tasks.filter((task) => task.ts + task.dur > turns[i].ts && task.ts + task.dur <= ts).reduce((sum, { tdur }) => sum + tdur / 1000, 0),
  );
  return { turns: turns.map(({ tdur }) => tdur / 1000), whole };
}

function spread(times) {
  const sorted = [...times].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))];
  return { p95: at(0.95), text: `p50 ${at(0.5).toFixed(1)}, p95 ${at(0.95).toFixed(1)}, p99 ${at(0.99).toFixed(1)}, most ${at(1).toFixed(1)} ms` };
}

const FRAMES = 300;
const WAYS = [
  { name: 'turning', yaw: 3, ahead: 0 },
  { name: 'flying 24 blocks a second', yaw: 0, ahead: 0.4 },
];

for (const name of ['default', 'classic'])
  test(`radius 12 and a horizon of 4 km: world ${name}`, async (t) => {
    const site = await startSite(t, ['--world', world(name)]);
    const page = await newPage(await launch(t));
    // Software takes a second and more for such a picture: one of all of it is enough.
    await page.goto(`${site.url}#radius=12&horizon=4096&quality=high&frameRate=0.02`);
    await filled(page);
    await page.evaluate(() => window.talus.engine.frame(performance.now()));
    const times = [];
    const { triangles, drawCalls, gpuBytes, heapBytes } = await stats(page);
    t.diagnostic(`${name}: ${triangles} triangles, ${drawCalls} draw calls, ${gpuBytes} bytes of meshes, ${heapBytes} bytes held`);
    assert.ok(triangles <= 3_000_000, `${triangles} triangles`);
    assert.ok(drawCalls <= 400, `${drawCalls} draw calls`);
    assert.ok(gpuBytes + heapBytes <= 1e9, `${gpuBytes + heapBytes} bytes`);
    await leaveOutCard(page);
    for (const { name: way, yaw, ahead } of WAYS) {
      await frames(page, FRAMES, yaw, ahead); // until V8 has compiled what runs in each
      await page.evaluate(() => (window.draws = window.ranges = 0));
      const { turns, whole } = await frameTimes(page, FRAMES, yaw, ahead);
      const drawn = await page.evaluate(() => window.draws);
      assert.ok(turns.length >= FRAMES && drawn >= turns.length, `${turns.length} frames and ${drawn} draws of ${FRAMES}`);
      const ranges = await page.evaluate(() => Math.round(window.ranges / window.draws));
      t.diagnostic(`${name}, ${way}: of ${turns.length} frames the turns ${spread(turns).text}; all between two frames ${spread(whole).text}; ${ranges} ranges a draw`);
      // All that is done until the next frame counts, land that comes among it.
      times.push([way, spread(whole).p95]);
    }
    for (const [way, p95] of times) assert.ok(!judgesTimes || p95 <= 6, `${way}: p95 ${p95.toFixed(1)} ms of processor time a frame, all between two frames`);
    noProblems(page);
  });
