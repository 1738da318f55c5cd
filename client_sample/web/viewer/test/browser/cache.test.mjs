// Chunks by HTTP through Varnish: land that was seen before is there though talusd is away.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import test from 'node:test';
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

async function startVarnish(t, backend) {
  const folder = scratch(t);
  // Varnish reads as a user of its own.
  chmodSync(folder, 0o755);
  const [host, port] = backend.split(':');
  writeFileSync(`${folder}/talus.vcl`, `vcl 4.1;\nbackend default { .host = "${host}"; .port = "${port}"; }\nsub vcl_backend_response { set beresp.grace = 10m; }\n`);
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
  const page = await newPage(await launch(t));
  await page.goto(`${site.url}#${SMALL}&transport=http`);
  await filled(page);
  const flight = async () => {
    for (let i = 0; i < 6; ++i) {
      await page.evaluate((step) => {
        const { body } = window.talus.player;
        body.place(body.position[0] + step, body.position[1], body.position[2]);
      }, i < 3 ? 96 : -96);
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
      await filled(page);
    }
  };
  await flight();
  await talusd.kill();
  // A page that is opened anew has nothing of its own but what Varnish holds; /v1/world is in its grace.
  const { chunks } = await stats(page);
  await flight();
  assert.equal((await stats(page)).chunks, chunks);
});
