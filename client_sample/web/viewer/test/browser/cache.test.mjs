// Chunks by HTTP through Varnish: land that was seen before is there though talusd is away.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { DIST, scratch, startTalusd } from './talusd.mjs';
import { filled, launch, newPage, SMALL, stats } from './browser.mjs';
import { serve } from './site.mjs';

const hasVarnish = spawnSync('varnishd', ['-V']).status === 0;

async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/** What ships, but for the port of talusd. */
const shipped = (name) => fileURLToPath(new URL(`../../../../../docker/varnish/${name}`, import.meta.url));

async function startVarnish(t, backend) {
  const folder = scratch(t);
  // Varnish reads as a user of its own.
  chmodSync(folder, 0o755);
  const port = backend.split(':')[1];
  copyFileSync(shipped('rules.vcl'), `${folder}/rules.vcl`);
  writeFileSync(`${folder}/talus.vcl`, readFileSync(shipped('talus.vcl'), 'utf8').replace('"4782"', `"${port}"`));
  const listen = await freePort();
  const child = spawn('varnishd', ['-F', '-n', `${folder}/work`, '-a', `127.0.0.1:${listen}`, '-f', `${folder}/talus.vcl`, '-s', 'malloc,256m'], { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.once('exit', resolve));
  t.after(async () => {
    child.kill('SIGTERM');
    await ended;
  });
  await new Promise((resolve, reject) => {
    let said = '';
    const read = (bytes) => {
      said += bytes;
      if (/Child .* Started|said Child starts/.test(said)) resolve();
    };
    child.stdout.on('data', read);
    child.stderr.on('data', read);
    ended.then(() => reject(new Error(`varnishd did not start: ${said}`)));
  });
  return `127.0.0.1:${listen}`;
}

test('a flight by HTTP through Varnish, with talusd away over land seen before', { skip: hasVarnish ? false : 'varnishd is not installed' }, async (t) => {
  const talusd = await startTalusd();
  t.after(() => talusd.stop());
  const varnish = await startVarnish(t, talusd.http);
  const site = await serve(DIST, () => varnish);
  t.after(() => site.close());
  const browser = await launch(t);
  /** There and back again; how many chunks the page has then. Each page has a cache of its own, empty at first. */
  const flight = async () => {
    const page = await newPage(browser);
    await page.goto(`${site.url}#${SMALL}&transport=http`);
    await filled(page);
    for (let i = 0; i < 6; ++i) {
      await page.evaluate((step) => {
        const { body } = window.talus.player;
        body.place(body.position[0] + step, body.position[1], body.position[2]);
      }, i < 3 ? 96 : -96);
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
      await filled(page);
    }
    const { chunks } = await stats(page);
    const { problems } = page;
    await page.context().close();
    return { chunks, problems };
  };
  const first = await flight();
  assert.deepEqual(first.problems, []);
  await talusd.kill();
  const second = await flight();
  assert.equal(second.chunks, first.chunks);
  // Heights on the way are asked of talusd each time, and it is away.
  assert.deepEqual(second.problems.filter((problem) => !/503.*\/v1\/heights/.test(problem)), []);
});
