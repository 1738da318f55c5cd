// Text that can be read whatever lies behind it, and pictures that stand still where the system asks for that.
import assert from 'node:assert/strict';
import test from 'node:test';
import { filled, launch, newPage, noProblems, SMALL } from './browser.mjs';
import { startSite } from './talusd.mjs';

const ENOUGH = 4.5; // WCAG 2, level AA

/** Of all text that one sees: how many elements have some, and those with less contrast than WCAG asks for. What lies under a
 *  translucent panel is the picture, any colour: that of the worse of black and white counts. */
const readText = (page) =>
  page.evaluate((enough) => {
    const parse = (text) => {
      const [r, g, b, a = 1] = text.match(/[\d.]+/g).map(Number);
      return { rgb: [r, g, b], a };
    };
    const over = (top, under) => under.map((c, i) => top.rgb[i] * top.a + c * (1 - top.a));
    const luminance = (rgb) => {
      const [r, g, b] = rgb.map((c) => c / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (a, b) => {
      const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
      return (high + 0.05) / (low + 0.05);
    };
    /** The colours of an element's text and of what is behind it, over a picture of one colour. */
    const coloursOver = (element, picture) => {
      const chain = [];
      for (let at = element; at !== null && at !== document.body; at = at.parentElement) chain.unshift(at);
      let behind = picture;
      let opacity = 1;
      for (const at of chain) {
        const style = getComputedStyle(at);
        opacity *= Number(style.opacity);
        const colour = parse(style.backgroundColor);
        behind = over({ ...colour, a: colour.a * opacity }, behind);
      }
      const ink = parse(getComputedStyle(element).color);
      return [over({ ...ink, a: ink.a * opacity }, behind), behind];
    };
    let seen = 0;
    const faint = [];
    for (const element of document.body.querySelectorAll('*')) {
      const hasText = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim() !== '') || element.matches('input[type=text], select');
      const { width, height } = element.getBoundingClientRect();
      if (!hasText || width < 2 || height < 2 || element.matches(':disabled') || !element.checkVisibility({ checkOpacity: true, checkVisibilityCSS: true })) continue;
      ++seen;
      const least = Math.min(...[[0, 0, 0], [255, 255, 255]].map((picture) => contrast(...coloursOver(element, picture))));
      if (least < enough) faint.push(`${element.tagName}#${element.id || element.closest('[id]')?.id} "${(element.textContent || element.value).trim().slice(0, 30)}": ${least.toFixed(2)}`);
    }
    return { seen, faint };
  }, ENOUGH);

test('all text has contrast enough', async (t) => {
  const site = await startSite(t);
  // What comes up softly is not read half way.
  const page = await newPage(await launch(t), { viewport: { width: 640, height: 480 }, reducedMotion: 'reduce' });
  await page.goto(`${site.url}#${SMALL}`);
  const look = async (where, least) => {
    const { seen, faint } = await readText(page);
    assert.ok(seen >= least, `${where}: ${seen} texts`);
    assert.deepEqual(faint, [], where);
  };
  await page.locator('#opening.gone').waitFor({ state: 'attached' });
  await look('the page', 5);
  for (const [key, panel] of [['KeyG', 'goto'], ['KeyT', 'time'], ['KeyO', 'settings'], ['KeyK', 'share'], ['KeyP', 'traffic']]) {
    await page.keyboard.press(key);
    await page.locator(`#panel-${panel}`).waitFor();
    await look(panel, 5);
    await page.keyboard.press('Escape');
    if (await page.locator(`#panel-${panel}`).isVisible()) await page.keyboard.press(key);
  }
  await page.keyboard.press('KeyX');
  await look('the slice', 5);
  await page.keyboard.press('KeyX');
  await page.keyboard.press('Escape');
  await page.keyboard.press('KeyH');
  await look('help', 20);
  await page.keyboard.press('Escape');
  await site.talusd.kill();
  await page.locator('#notice[data-kind=away]').waitFor();
  await look('a notice', 5);
  noProblems(page, [/ERR_CONNECTION|WebSocket|502/]);
});

/** A number for the picture that the engine draws at a moment of its own clock, in milliseconds. */
const pictureAt = (page, ms) =>
  page.evaluate(async (ms) => {
    const { engine } = window.talus;
    const shot = engine.screenshot();
    engine.frame(ms);
    const digest = await crypto.subtle.digest('SHA-256', await (await shot).arrayBuffer());
    return [...new Uint8Array(digest)].map((b) => b.toString(16).padStart(2, '0')).join('');
  }, ms);

for (const [reducedMotion, is] of [['reduce', 'stands still'], ['no-preference', 'moves']])
  test(`with prefers-reduced-motion: ${reducedMotion} what moves by itself ${is}`, async (t) => {
    const site = await startSite(t);
    const page = await newPage(await launch(t), { reducedMotion });
    // Toward the sky, with its clouds, and seldom drawn but by the test.
    await page.goto(`${site.url}#radius=3&horizon=0&quality=low&look=0,35&mode=fly`);
    await filled(page);
    await page.evaluate(() => {
      window.talus.settings.frameRate = 0.02;
    });
    await page.keyboard.press('KeyO');
    await page.locator('#panel-settings').waitFor();
    const stands = reducedMotion === 'reduce';
    assert.equal(await page.evaluate(() => matchMedia('(prefers-reduced-motion: reduce)').matches), stands);
    const transitions = await page.evaluate(() =>
      [...document.querySelectorAll('*')].filter((e) => {
        const { transitionDuration, animationName } = getComputedStyle(e);
        return animationName !== 'none' || transitionDuration.split(',').some((d) => parseFloat(d) > 0);
      }).map((e) => e.id || e.className || e.tagName),
    );
    if (stands) assert.deepEqual(transitions, []);
    else assert.ok(transitions.length > 0);
    const pictures = [];
    for (const ms of [1_000_000, 1_000_000, 1_060_000]) pictures.push(await pictureAt(page, ms));
    assert.equal(pictures[0], pictures[1], 'one moment has one picture');
    assert.equal(pictures[0] === pictures[2], stands);
    noProblems(page);
  });
