// Chromium, and pages that keep a record of everything that went wrong in them.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const executablePath = process.env.CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);

/** How long a view may take to fill on a machine that is busy: no measure, only the end of a test that hangs. */
export const PATIENCE_MS = 120_000;

export async function launch(t, args = []) {
  assert.ok(executablePath, 'there is no chromium: apt-get install chromium fonts-dejavu-core, or set CHROMIUM');
  const browser = await chromium.launch({
    executablePath,
    args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--js-flags=--expose-gc', '--enable-precise-memory-info', ...args],
  });
  t.after(() => browser.close());
  return browser;
}

/** A page of its own context. `page.problems`: console errors, uncaught errors, failed requests, requests to other hosts. */
export async function newPage(browser, options = {}) {
  const context = await browser.newContext({ viewport: { width: 320, height: 240 }, ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  const page = await context.newPage();
  page.problems = [];
  page.on('console', (message) => {
    if (message.type() === 'error') page.problems.push(`console: ${message.text()} (${message.location().url})`);
  });
  page.on('pageerror', (error) => page.problems.push(`error: ${error.stack ?? error}`));
  page.on('crash', () => page.problems.push('the page crashed'));
  page.on('requestfailed', (request) => {
    // A page gives up what it does not want any more.
    if (request.failure()?.errorText !== 'net::ERR_ABORTED') page.problems.push(`request: ${request.url()} ${request.failure()?.errorText}`);
  });
  page.on('response', (response) => {
    // 503: come again.
    if (response.status() >= 400 && response.status() !== 503) page.problems.push(`answer: ${response.url()} ${response.status()}`);
  });
  page.on('request', (request) => {
    const { protocol, host } = new URL(request.url());
    const isOwn = protocol === 'data:' || protocol === 'blob:' || page.url() === 'about:blank' || host === new URL(page.url()).host;
    if (!isOwn) page.problems.push(`request to another host: ${request.url()}`);
  });
  return page;
}

/** Small, plain and seldom drawn: software draws on the cores that everything else needs. */
export const SMALL = 'radius=3&horizon=0&quality=low&frameRate=1';

/** All that the view has is on the screen. */
export async function filled(page) {
  await page.waitForFunction(() => {
    const stats = window.talus?.engine?.stats();
    // Triangles are counted in a frame, which may have been drawn before the last meshes came.
    return stats?.state === 'complete' && stats.pendingMeshes === 0 && stats.current && stats.triangles > 0;
  });
}

export const stats = (page) => page.evaluate(() => window.talus.engine.stats());

export const place = (page) =>
  page.evaluate(() => {
    const { position, yaw, pitch, mode } = window.talus.player.body;
    return { x: position[0], y: position[1], z: position[2], yaw, pitch, mode };
  });

/** The address in the bar leads to where the player is. */
export const addressFollows = (page) =>
  page.waitForFunction(() => {
    const at = /at=(-?[\d.]+),(-?[\d.]+),(-?[\d.]+)/.exec(location.hash);
    return at !== null && window.talus.player.body.position.every((p, i) => Math.abs(p - Number(at[i + 1])) < 0.01);
  });

export function noProblems(page, but = []) {
  assert.deepEqual(page.problems.filter((problem) => !but.some((known) => known.test(problem))), []);
}
