// What a view costs: time to the first terrain and to all of it, triangles, draw calls; and memory that stays flat.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { filled, launch, newPage, noProblems, SMALL, stats } from './browser.mjs';
import { startSite } from './talusd.mjs';

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
  const best = (name) => Math.min(...times.map((marks) => marks[name]));
  // A machine that is busy with other things says nothing: the best of three counts.
  assert.ok(best('talus:first') <= 1000, 'first terrain within 1 s');
  assert.ok(best('talus:complete') <= 3000, 'radius 8 within 3 s');
});

/** Processor time of the page's own thread in so many frames, in milliseconds, while one turns around: what a trace says. */
async function frameTimes(page, count) {
  const browser = page.context().browser();
  const turn = (count) =>
    page.evaluate(async (count) => {
      const { settings, player } = window.talus;
      settings.frameRate = 0;
      for (let i = 0; i < count; ++i) {
        player.body.yaw += 9;
        await new Promise(requestAnimationFrame);
      }
      settings.frameRate = 0.02;
    }, count);
  await turn(12); // frames before that are drawn by code that was not compiled yet
  await browser.startTracing(page, { categories: ['devtools.timeline'] });
  await turn(count);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  return traceEvents.filter(({ name, tdur }) => name === 'FireAnimationFrame' && tdur > 0).map(({ tdur }) => tdur / 1000);
}

for (const name of ['default', 'classic'])
  test(`radius 12 and a horizon of 4 km: world ${name}`, async (t) => {
    const site = await startSite(t, ['--world', world(name)]);
    const page = await newPage(await launch(t));
    // Software takes a second and more for such a picture: one of all of it is enough.
    await page.goto(`${site.url}#radius=12&horizon=4096&quality=high&frameRate=0.02`);
    await filled(page);
    await page.evaluate(() => window.talus.engine.frame(performance.now()));
    const { triangles, drawCalls, gpuBytes, heapBytes } = await stats(page);
    t.diagnostic(`${name}: ${triangles} triangles, ${drawCalls} draw calls, ${gpuBytes} bytes of meshes, ${heapBytes} bytes held`);
    assert.ok(triangles <= 3_000_000, `${triangles} triangles`);
    assert.ok(drawCalls <= 400, `${drawCalls} draw calls`);
    assert.ok(gpuBytes + heapBytes <= 1e9, `${gpuBytes + heapBytes} bytes`);
    const frames = await frameTimes(page, 24);
    const p95 = frames.sort((a, b) => a - b)[Math.floor(frames.length * 0.95)];
    t.diagnostic(`${name}: p95 of the page's processor time a frame ${p95.toFixed(1)} ms, of ${frames.length} frames`);
    assert.ok(p95 <= 6, `${p95} ms of processor time a frame`);
    noProblems(page);
  });

/** Bytes of the heaps of a page's workers after a forced collection. */
async function heapOfWorkers(session) {
  const workers = [];
  const waiting = new Map();
  session.on('Target.attachedToTarget', ({ sessionId }) => workers.push(sessionId));
  session.on('Target.receivedMessageFromTarget', ({ message }) => {
    const { id, result } = JSON.parse(message);
    waiting.get(id)?.(result);
  });
  await session.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
  let calls = 0;
  const call = (sessionId, method) =>
    new Promise((resolve) => {
      const id = ++calls;
      waiting.set(id, resolve);
      void session.send('Target.sendMessageToTarget', { sessionId, message: JSON.stringify({ id, method }) });
    });
  let bytes = 0;
  for (const worker of workers) {
    await call(worker, 'HeapProfiler.enable');
    await call(worker, 'HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize = 0 } = await call(worker, 'Runtime.getHeapUsage');
    bytes += usedSize + backingStorageSize;
  }
  assert.ok(workers.length >= 2 && bytes > 1e6, `${workers.length} workers hold ${bytes} bytes`);
  return bytes;
}

/** Bytes after a forced collection: of the page, of its workers, and of the renderer's process as the kernel counts it. */
async function memory(browser, page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.enable');
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage');
  const workers = await heapOfWorkers(session);
  await session.detach();
  const system = await browser.newBrowserCDPSession();
  const { processInfo } = await system.send('SystemInfo.getProcessInfo');
  await system.detach();
  let renderer = 0;
  for (const { type, id } of processInfo)
    if (type === 'renderer') renderer = Math.max(renderer, 1024 * Number(/RssAnon:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))[1]));
  const { gpuBytes, heapBytes } = await stats(page);
  // Kept up to a bound, which so few laps do not reach.
  const voxels = await page.evaluate(() => window.talus.engine.voxels.bytes);
  return { page: usedSize + backingStorageSize - voxels, workers, renderer, meshes: gpuBytes, held: heapBytes };
}

test('memory stays flat while flying', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  const page = await newPage(browser);
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  const lap = () =>
    page.evaluate(async () => {
      const { body } = window.talus.player;
      const [cx, y, cz] = [body.position[0] - 320, body.position[1], body.position[2]];
      for (let i = 1; i <= 48; ++i) {
        const angle = (i / 48) * 2 * Math.PI;
        body.place(cx + 320 * Math.cos(angle), y, cz + 320 * Math.sin(angle));
        await new Promise(requestAnimationFrame);
        await new Promise(requestAnimationFrame);
      }
    });
  // What is held differs a little from lap to lap, and an allocator gives back late: the least of three laps counts.
  const fly = async (laps) => {
    let least = null;
    for (let i = 1; i <= laps; ++i) {
      await lap();
      await filled(page);
      if (i <= laps - 3) continue;
      const now = await memory(browser, page);
      least = Object.fromEntries(Object.entries(now).map(([name, bytes]) => [name, Math.min(bytes, least?.[name] ?? Infinity)]));
    }
    return least;
  };
  const early = await fly(8);
  const late = await fly(16);
  for (const [name, bytes] of Object.entries(early)) {
    t.diagnostic(`${name}: ${bytes} bytes after 8 laps, ${late[name]} after 24`);
    const slack = name === 'renderer' ? 8e6 : 1e6;
    assert.ok(late[name] <= bytes * 1.05 + slack, `${name} grew from ${bytes} to ${late[name]} bytes`);
  }
  noProblems(page);
});
