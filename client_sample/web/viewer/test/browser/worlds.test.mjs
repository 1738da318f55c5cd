// Worlds made by WebAssembly in a page: golden voxels, under a strict policy and without isolation from other origins.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, newPage, noProblems } from './browser.mjs';

const POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src data:";
const TYPES = { '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.json': 'application/json' };
const root = new URL('../../../../../', import.meta.url);
const local = (path) => fileURLToPath(new URL(path, root));

async function serve(t) {
  const inputs = execFileSync(local('build/release/tests/golden/talus_golden_inputs'), { maxBuffer: 1 << 26 });
  const served = (path) => {
    if (path === '/inputs.json') return inputs;
    if (path === '/worker.mjs') return readFileSync(new URL('./worlds_worker.mjs', import.meta.url));
    if (path === '/golden_text.mjs') return readFileSync(local('tests/golden/golden_text.mjs'));
    const own = /^\/wasm\/([a-z-]+\.(?:js|wasm))$/.exec(path);
    return own ? readFileSync(local(`client_sample/web/talus-js/wasm/${own[1]}`)) : '<!doctype html><title>worlds</title><link rel="icon" href="data:,">';
  };
  const server = createServer(({ url }, answer) => {
    answer.writeHead(200, { 'Content-Type': TYPES[extname(url)] ?? 'text/html', 'Content-Security-Policy': POLICY });
    answer.end(served(url));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => (server.closeAllConnections(), server.close()));
  return `http://127.0.0.1:${server.address().port}/`;
}

test('golden voxels in a page', async (t) => {
  const url = await serve(t);
  const browser = await launch(t);
  const page = await newPage(browser);
  await page.goto(url);
  assert.equal(await page.evaluate(() => crossOriginIsolated), false);
  const expected = readFileSync(local('tests/golden/golden.txt'), 'utf8');
  for (const simd of [true, false])
    await t.test(simd ? 'by vectors' : 'without', async () => {
      const made = await page.evaluate((simd) => {
        const worker = new Worker('/worker.mjs', { type: 'module' });
        return new Promise((resolve, reject) => {
          worker.onmessage = ({ data }) => resolve(data);
          worker.onerror = ({ message }) => reject(new Error(message));
          worker.postMessage(simd);
        });
      }, simd);
      assert.equal(made.failure, undefined);
      assert.equal(made.set, simd ? 'wasm128' : 'scalar');
      assert.equal(made.text, expected);
    });
  noProblems(page);
});
