// Draws docs/pictures of the worlds anew, all or those whose names are given:
//
//     node docs/pictures/make.mjs BUILD [NAME...]      # BUILD: build/release; NAME: alpine.png
//
// Needs talus-gen, talus-thesis, talusd and talus-client in BUILD, `npm ci` in client_sample/web/viewer, chromium,
// which also lays pictures side by side, and pngquant, which makes each a quarter as large by 256 colours. Each view
// takes half a minute, the viewer's, drawn without a graphics card, longer. A busy machine may not have all chunks of a
// view in time: look at what was drawn.
import { execFileSync, spawn } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
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
/** The file of a world: a name in core/worlds, or a file. */
const world = (name) => (name.endsWith('.toml') ? name : join(root, `core/worlds/${name}.toml`));
const scratch = mkdtempSync(join(tmpdir(), 'talus-pictures-'));
const run = (path, ...args) => execFileSync(program(path), args, { stdio: ['ignore', 'ignore', 'inherit'] });
const generate = (...args) => run('core/tools/talus-gen', ...args);
const thesis = (...args) => run('core/thesis/talus-thesis', ...args);

let browser;
async function page(width, height) {
  browser ??= await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
  });
  return browser.newPage({ viewport: { width, height } });
}

/** The default world with other words in its file: pairs of what stands there and what shall. */
function changed(name, ...changes) {
  let text = readFileSync(world('default'), 'utf8');
  for (const [from, to] of changes) {
    if (!text.includes(from)) throw new Error(`default.toml has no ${from}`);
    text = text.replaceAll(from, to);
  }
  const file = join(scratch, `${name}.toml`);
  writeFileSync(file, text);
  copyFileSync(join(root, 'core/worlds/watchtower.vox'), join(scratch, 'watchtower.vox'));
  return file;
}

/** The pictures in a row, each `width` wide and 12 pixels apart: scaled, or as they are and cut off below. */
async function row(files, width, height, path, scaled = true) {
  const sheet = await page(files.length * (width + 12) - 12, height);
  await sheet.setContent('<body style="margin:0;display:flex;gap:12px;background:white">');
  const sources = files.map((file) => `data:image/png;base64,${readFileSync(file, 'base64')}`);
  await sheet.evaluate(
    async ([all, w, h, fitted]) => {
      for (const src of all) {
        const image = Object.assign(new Image(), { src });
        await image.decode();
        const canvas = Object.assign(document.createElement('canvas'), { width: w, height: h });
        const drawing = canvas.getContext('2d');
        drawing.imageSmoothingQuality = 'high'; // an <img> is made smaller more roughly
        if (fitted) drawing.drawImage(image, 0, 0, w, h);
        else drawing.drawImage(image, 0, 0);
        document.body.append(canvas);
      }
    },
    [sources, width, height, scaled],
  );
  await sheet.screenshot({ path });
  await sheet.close();
}

/** A talusd of a world, in which `builds`: anybody may build: { game, http, stop }. */
async function serve(name, builds = false) {
  const store = builds ? ['--data', mkdtempSync(join(scratch, 'store-'))] : [];
  const env = builds ? { ...process.env, TALUS_ACCESS_WITHOUT_TOKEN: 'read,edit' } : process.env;
  const args = [...store, '--world', world(name), '--listen', '127.0.0.1:0', '--http', '127.0.0.1:0', '--web', join(viewer, 'dist')];
  const child = spawn(program('server/talusd'), args, { env, stdio: ['ignore', 'pipe', 'pipe'] });
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

/** What a client sees that has waited for the land; `from` empty: from where players arrive. */
function look(server, [from, heading, height], path) {
  const place = from ? ['--from', ...from.split(',')] : [];
  const way = heading === undefined ? [] : ['--heading', `${heading}`];
  run('client_sample/cli/talus-client', '--connect', server.game, 'fly', '--seconds', '30', '--speed', '1', '--far', '96',
    '--height', `${height}`, ...place, ...way, '--view', path);
}
async function lookIn(name, place, path) {
  const server = await serve(name);
  look(server, place, path);
  server.stop();
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
/** One of each of several worlds. */
const viewsOf = (...places) => async (path) => {
  const files = [];
  for (const [name, ...place] of places) {
    files.push(join(scratch, `view-${files.length}.png`));
    await lookIn(name, place, files.at(-1));
  }
  await row(files, 640, 360, path);
};
/** Cuts or maps of several worlds by talus-gen, in a row. */
const rowOf = (width, height, worlds, command, ...args) => async (path) => {
  const files = worlds.map((name, i) => {
    const file = join(scratch, `${command}-${i}.png`);
    generate(command, '--world', world(name), ...args, '-o', file);
    return file;
  });
  await row(files, width, height, path, command !== 'section');
};
const map = (name, center, size, every) => (path) =>
  generate('map', '--world', world(name), '--center', center, '--size', size, '--every', `${every}`, '-o', path);
const sheet = (name) => async (path) => {
  const whole = join(scratch, 'sheet.png');
  generate('preview', '--world', world(name), '-o', whole);
  const bytes = readFileSync(whole);
  await row([whole], Math.round(bytes.readUInt32BE(16) * 0.55), Math.round(bytes.readUInt32BE(20) * 0.55), path);
};

/** The viewer, when all that it asked for is there. Until then it is so many times smaller: frames would take the time that chunks need. */
const inBrowser = (where, width, height, ready, smaller = 1) => async (path) => {
  const server = await serve('default', true);
  const shown = await page(width / smaller, height / smaller);
  shown.setDefaultTimeout(1_200_000);
  await shown.goto(`http://${server.http}/${where}`);
  await shown.waitForFunction(ready);
  await shown.setViewportSize({ width, height });
  await shown.waitForFunction(ready);
  await shown.evaluate(async () => {
    document.getElementById('hint-close')?.click();
    window.talus?.engine?.frame(performance.now());
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
  });
  await shown.screenshot({ path });
  await shown.close();
  server.stop();
};
const viewFilled = () => {
  const stats = window.talus?.engine?.stats();
  return stats?.state === 'complete' && stats.pendingMeshes === 0 && stats.current && stats.triangles > 0;
};

const moreSea = [
  '[strata]\n',
  `[surface.land]
height = [[-1, -60], [-0.62, -42], [-0.2, -16], [0.1, -4], [0.2, 1.5], [0.3, 6], [0.45, 13], [0.7, 26], [1, 52]]

[strata]
`,
];
const shortContinents = [
  '[surface]\n',
  '[[field]]\nname = "continents"\nwavelength = 2800\noctaves = 5\ngain = 0.5\nwarp = 1\n\n[surface]\n',
];
const magic = ['[surface]\n', '[[field]]\nname = "magic"\nwavelength = 3000\noctaves = 3\ngain = 0.5\n\n[surface]\n'];
const heath = [
  '[[look]]\nname = "snow field"',
  `[[look]]
name = "heather"
of = "soil"
above = { magic = 0.8, moisture = 0, height = 2 }
colour = "#7d6a78"

[[look]]
name = "snow field"`,
];
const tower = [
  '[[object]]\nname = "oak"',
  `[[object]]
name = "watchtower"
model = "watchtower.vox"
spacing = 60
chance = 0.3
where = { slope = [12, 8], height = [20, 30] }
[object.palette]
1 = { name = "masonry", colour = "#8d8a84" }
2 = { name = "shingles", colour = "#6e4436" }

[[object]]
name = "oak"`,
];
const roughness = (value) => ['roughness = 0.2', `roughness = ${value}`];
const mesa = ['--from', '-2340,-3560', '--length', '200'];

const pictures = {
  'regions.png': (path) =>
    generate('map', '--world', world('default'), '--center', '-2600,-5000', '--size', '900,600', '--lod', '3', '-o', path),
  'worlds-sea.png': (path) =>
    rowOf(320, 240, ['default', changed('sea', moreSea), changed('islands', moreSea, shortContinents)], 'map', '--center', '0,0',
      '--size', '480,360', '--every', '64')(path),
  'worlds-look.png': (path) => viewsOf([changed('heath', magic, heath), '-3180,-2950', 75, 30])(path),
  'worlds-where.png': (path) =>
    rowOf(480, 360, ['default', changed('snow', ['temperature = [-0.50, -0.60]', 'temperature = [-0.2, -0.3]'])], 'map', '--center',
      '3300,-1700', '--size', '480,360', '--lod', '3')(path),
  'worlds-provinces.png': (path) =>
    viewsOf(
      [changed('grey', ['name = "desert"\nabove = { mesas = 0.3 }', 'name = "desert"\nabove = { mesas = 1 }']), '-2400,-3880', 110, 40],
      ['default', '-2400,-3880', 110, 40],
    )(path),
  'worlds-strata.png': (path) =>
    rowOf(400, 320, [changed('folded', roughness(0.5), ['strata_wavelength = 600', 'strata_wavelength = 300']), 'default',
      changed('level', roughness(0.05))], 'section', ...mesa, '--scale', '2')(path),
  'worlds-talus.png': (path) =>
    rowOf(600, 340, ['default', changed('no-talus', ['share = 1.0', 'share = 0.01'])], 'section', ...mesa, '--scale', '3')(path),
  'worlds-objects.png': (path) =>
    viewsOf(['default', '-4100,-860', 90, 25], [changed('tower', tower), '-2354,-2040', 35, 22])(path),
  'features-landscape.png': (path) => {
    thesis('gallery', '--world', world('features'), '--only', 'landscape', '-o', scratch);
    copyFileSync(join(scratch, 'gallery-01-landscape.png'), path);
  },
  'default.png': map('default', '-2960,-2384', '480,480', 16),
  'archipelago.png': map('archipelago', '0,0', '480,480', 16),
  'mesas.png': map('mesas', '0,0', '480,480', 16),
  'alpine.png': map('alpine', '0,0', '480,480', 16),
  'sheet-default.png': sheet('default'),
  'sheet-archipelago.png': sheet('archipelago'),
  'sheet-mesas.png': sheet('mesas'),
  'sheet-alpine.png': sheet('alpine'),
  'view.png': (path) => lookIn('default', ['', undefined, 45], path),
  'views-default.png': views('default', [['', 0, 40], ['-2743,-2198', 300, 40], ['-2400,-3880', 110, 40]]),
  'views-archipelago.png': views('archipelago', [['', undefined, 40], ['-2480,-680', 200, 40], ['400,-1040', 10, 40]]),
  'views-mesas.png': views('mesas', [['1460,-2330', 200, 40], ['1280,-1600', 10, 40], ['400,-280', 300, 40]]),
  'views-alpine.png': views('alpine', [['', undefined, 40], ['-800,-680', 285, 45], ['-2500,-600', 115, 50]]),
  'viewer.png': inBrowser('#at=-2743,190,-2198&look=262,-5&time=8.5&mode=fly&radius=8&horizon=2048&frameRate=0.1', 1280, 640, viewFilled, 5),
};

try {
  for (const name of names.length > 0 ? names : Object.keys(pictures)) {
    if (!pictures[name]) throw new Error(`no picture is called ${name}; there are ${Object.keys(pictures).join(', ')}`);
    const path = join(here, name);
    await pictures[name](path);
    execFileSync('pngquant', ['256', '--speed', '1', '--strip', '--force', '--output', path, path]);
    console.log(name);
  }
} finally {
  await browser?.close();
  rmSync(scratch, { recursive: true, force: true });
}
