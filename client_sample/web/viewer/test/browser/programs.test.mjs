// The card's programs: what their uniforms are is asked before anything is drawn, as an answer then waits for the picture.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems } from './browser.mjs';
import { startSite } from './talusd.mjs';

/** Keeps count in window.card, in the page, of what waits for the card: `asked` programs, those `made`, and `late`: what was
 *  asked or made since land came. */
function watchCard() {
  const card = { made: new Set(), asked: new Set(), late: [], hasDrawn: false, hasLand: false };
  window.card = card;
  const { prototype } = WebGL2RenderingContext;
  const watch = (name, seen) => {
    const real = prototype[name];
    prototype[name] = function (...all) {
      seen(...all);
      return real.apply(this, all);
    };
  };
  const waits = (name) => card.hasLand && card.late.push(name);
  watch('linkProgram', (program) => {
    card.made.add(program);
    waits('linkProgram');
  });
  for (const name of ['getActiveUniform', 'getUniformLocation', 'getActiveAttrib', 'getAttribLocation', 'getProgramInfoLog', 'getShaderInfoLog', 'getShaderParameter'])
    watch(name, (of) => {
      if (name === 'getActiveUniform') card.asked.add(of);
      waits(name);
    });
  watch('getProgramParameter', (_, what) => waits(`getProgramParameter ${what}`));
  const draws = () => (card.hasDrawn = true);
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) watch(name, draws);
  const getExtension = prototype.getExtension;
  prototype.getExtension = function (name) {
    const extension = getExtension.call(this, name);
    if (name === 'WEBGL_multi_draw' && extension !== null && !Object.hasOwn(extension, 'multiDrawElementsWEBGL')) {
      const { multiDrawElementsWEBGL } = extension;
      extension.multiDrawElementsWEBGL = (...all) => {
        draws();
        multiDrawElementsWEBGL.apply(extension, all);
      };
    }
    return extension;
  };
}

for (const quality of ['low', 'high'])
  test(`no picture of ${quality} quality waits for what a program's uniforms are`, async (t) => {
    const site = await startSite(t);
    const page = await newPage(await launch(t));
    await page.addInitScript(watchCard);
    // On a busy machine land may be here before the programs are made: here it waits for them.
    let ready;
    const isReady = new Promise((resolve) => (ready = resolve));
    await page.routeWebSocket(/v1\/stream/, async (socket) => {
      const server = socket.connectToServer();
      socket.onMessage((message) => server.send(message));
      server.onMessage(async (message) => {
        await isReady;
        socket.send(message);
      });
    });
    await page.goto(`${site.url}#radius=2&horizon=0&quality=${quality}&frameRate=1`);
    await page.waitForFunction(() => window.card.made.size > 0 && [...window.card.made].every((program) => window.card.asked.has(program)));
    const [made, hasDrawn] = await page.evaluate(() => {
      const { card } = window;
      card.hasLand = true;
      return [card.made.size, card.hasDrawn];
    });
    assert.ok(made >= 3, `${made} programs: land, sky, water`);
    assert.equal(hasDrawn, false);
    ready();
    await filled(page);
    const { late, programs } = await page.evaluate(() => ({ late: window.card.late, programs: window.card.made.size }));
    assert.deepEqual(late, [], `${programs - made} of ${programs} programs came late`);
    noProblems(page);
  });
