// Draws docs/pictures of the worlds anew, all or those whose names are given:
//
//     node docs/pictures/make.mjs BUILD [NAME...]      # BUILD: build/release; NAME: alpine.png
//
// Needs talus-gen, talusd and talus-client in BUILD, `npm ci` in client_sample/web/viewer, and chromium, which also lays
// pictures side by side. Each takes half a minute, the viewer's, drawn without a graphics card, longer. A busy machine may not have all chunks
// of a view in time: look at what was drawn. Sheets were reduced to 256 colours after that.
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = resolve(here, '../..');
const viewer = join(root, 'client_sample/web/viewer');
const { chromium } = createRequire(join(viewer, 'package.json'))('playwright-core');
const [build, ...names] = process.argv.slice(2);
if (!build) {
  console.error('usage: node docs/pictures/make.mjs BUILD [NAME...]');
  process.exit(2);
}
const program = (path) => resolve(build, path);
const world = (name) => join(root, `core/worlds/${name}.toml`);
const scratch = mkdtempSync(join(tmpdir(), 'talus-pictures-'));
const run = (path, ...args) => execFileSync(program(path), args, { stdio: ['ignore', 'ignore', 'inherit'] });
const generate = (...args) => run('core/tools/talus-gen', ...args);

let browser;
async function page(width, height) {
  browser ??= await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
  });
  return browser.newPage({ viewport: { width, height } });
}

/** The pictures in a row, each `width` wide and 12 pixels apart. */
async function row(files, width, height, path) {
  const sheet = await page(files.length * (width + 12) - 12, height);
  await sheet.setContent('<body style="margin:0;display:flex;gap:12px;background:white">');
  const sources = files.map((file) => `data:image/png;base64,${readFileSync(file, 'base64')}`);
  await sheet.evaluate(
    async ([all, w, h]) => {
      for (const src of all) {
        const image = Object.assign(new Image(), { src });
        await image.decode();
        const canvas = Object.assign(document.createElement('canvas'), { width: w, height: h });
        const drawing = canvas.getContext('2d');
        drawing.imageSmoothingQuality = 'high'; // an <img> is made smaller more roughly
        drawing.drawImage(image, 0, 0, w, h);
        document.body.append(canvas);
      }
    },
    [sources, width, height],
  );
  await sheet.screenshot({ path });
  await sheet.close();
}

/** A talusd of a world: { game, http, stop }. */
async function serve(name) {
  const args = ['--world', world(name), '--listen', '127.0.0.1:0', '--http', '127.0.0.1:0', '--web', join(viewer, 'dist')];
  const child = spawn(program('server/talusd'), args, { stdio: ['ignore', 'pipe', 'pipe'] });
  const found = await new Promise((done, fail) => {
    let said = '';
    const read = (bytes) => {
      said += bytes;
      const game = /^listening on (\S+)/m.exec(said);
      const http = /HTTP and WebSocket on http:\/\/([\d.:]+)/.exec(said);
      if (game && http) done({ game: game[1], http: http[1] });
    };
    child.stdout.on('data', read);
    child.stderr.on('data', read);
    child.once('exit', () => fail(new Error(`talusd did not start: ${said}`)));
  });
  return { ...found, stop: () => child.kill() };
}

/** What a client sees after a flight of 240 voxels; `from` empty: from where players arrive. */
function look(server, [from, heading, height], path) {
  const place = from ? ['--from', ...from.split(',')] : [];
  const way = heading === undefined ? [] : ['--heading', `${heading}`];
  run('client_sample/cli/talus-client', '--connect', server.game, 'fly', '--seconds', '20', '--speed', '12', '--far', '96',
    '--height', `${height}`, ...place, ...way, '--view', path);
}

/** Three views of a world. */
const views = (name, places) => async (path) => {
  const server = await serve(name);
  const files = places.map((place, i) => {
    const file = join(scratch, `${name}-${i}.png`);
    look(server, place, file);
    return file;
  });
  server.stop();
  await row(files, 556, 313, path);
};
const map = (name, center, size, every) => (path) =>
  generate('map', '--world', world(name), '--center', center, '--size', size, '--every', `${every}`, '-o', path);
const sheet = (name) => async (path) => {
  const whole = join(scratch, 'sheet.png');
  generate('preview', '--world', world(name), '-o', whole);
  const bytes = readFileSync(whole);
  await row([whole], Math.round(bytes.readUInt32BE(16) * 0.55), Math.round(bytes.readUInt32BE(20) * 0.55), path);
};

/** The viewer, when all that it asked for is there. */
const inBrowser = (where, width, height, ready) => async (path) => {
  const server = await serve('default');
  const shown = await page(width, height);
  shown.setDefaultTimeout(600_000);
  await shown.goto(`http://${server.http}/${where}`);
  await shown.waitForFunction(ready);
  await shown.screenshot({ path });
  await shown.close();
  server.stop();
};
const viewFilled = () => {
  const stats = window.talus?.engine?.stats();
  return stats?.state === 'complete' && stats.pendingMeshes === 0 && stats.current && stats.triangles > 0;
};

const pictures = {
  'far.png': map('default', '0,0', '1024,1024', 64),
  'default.png': map('default', '0,0', '480,480', 16),
  'archipelago.png': map('archipelago', '0,0', '480,480', 16),
  'mesas.png': map('mesas', '0,0', '480,480', 16),
  'alpine.png': map('alpine', '0,0', '480,480', 16),
  'sheet-default.png': sheet('default'),
  'sheet-archipelago.png': sheet('archipelago'),
  'sheet-mesas.png': sheet('mesas'),
  'sheet-alpine.png': sheet('alpine'),
  'views-default.png': views('default', [['', undefined, 40], ['-2743,-2198', 300, 40], ['-2600,-5000', 60, 40]]),
  'views-archipelago.png': views('archipelago', [['', undefined, 40], ['-1696,-212', undefined, 40], ['900,1800', undefined, 40]]),
  'views-mesas.png': views('mesas', [['', undefined, 40], ['-760,-1495', undefined, 40], ['2400,-300', undefined, 40]]),
  'views-alpine.png': views('alpine', [['-900,-100', 265, 40], ['1500,1000', 140, 30], ['-2200,-1700', 205, 40]]),
  'viewer.png': inBrowser('#at=-2743,190,-2198&look=300,-8&time=8.5&mode=fly&radius=8&horizon=2048', 1280, 640, viewFilled),
  'viewer-map.png': inBrowser('map.html', 1280, 720, () => window.talusMap?.missing === 0),
};

try {
  for (const name of names.length > 0 ? names : Object.keys(pictures)) {
    if (!pictures[name]) throw new Error(`no picture is called ${name}; there are ${Object.keys(pictures).join(', ')}`);
    await pictures[name](join(here, name));
    console.log(name);
  }
} finally {
  await browser?.close();
  rmSync(scratch, { recursive: true, force: true });
}
