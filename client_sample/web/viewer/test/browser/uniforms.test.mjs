// What the page asks WebGL for, when: an answer waits for all that the card was given to draw before it.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems, SMALL } from './browser.mjs';
import { startSite } from './talusd.mjs';

test("programs' uniforms are asked before anything is drawn by them", async (t) => {
  const site = await startSite(t);
  const page = await newPage(await launch(t));
  await page.addInitScript(() => {
    window.asked = new Set();
    window.late = [];
    const { prototype } = WebGL2RenderingContext;
    const before = (name, note) => {
      const call = prototype[name];
      prototype[name] = function (...args) {
        note(...args);
        return call.apply(this, args);
      };
    };
    let draws = 0;
    const draw = () => ++draws;
    for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) before(name, draw);
    const { getExtension } = prototype;
    prototype.getExtension = function (name) {
      const extension = getExtension.call(this, name);
      if (name === 'WEBGL_multi_draw' && extension !== null && !extension.isCounted) {
        const { multiDrawElementsWEBGL } = extension;
        extension.multiDrawElementsWEBGL = (...args) => {
          draw();
          multiDrawElementsWEBGL.apply(extension, args);
        };
        extension.isCounted = true;
      }
      return extension;
    };
    for (const name of ['getActiveUniform', 'getUniformLocation', 'getProgramInfoLog'])
      before(name, (program) => {
        window.asked.add(program);
        if (draws > 0) window.late.push(`${name} after ${draws} draws`);
      });
    window.draws = () => draws;
  });
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);
  const { draws, programs, late } = await page.evaluate(() => ({ draws: window.draws(), programs: window.asked.size, late: window.late }));
  t.diagnostic(`${programs} programs asked, ${draws} draws`);
  assert.ok(programs >= 2 && draws > 0, `${programs} programs, ${draws} draws`);
  assert.deepEqual(late.slice(0, 5), [], `${late.length} questions behind what was drawn`);
  noProblems(page);
});
