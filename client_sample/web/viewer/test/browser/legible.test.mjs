// Text that everybody can read, whatever land lies behind it.
import assert from 'node:assert/strict';
import test from 'node:test';
import { launch, newPage, noProblems } from './browser.mjs';
import { startSite } from './talusd.mjs';

/** Of each text in sight its contrast as WCAG 2 counts it, the least of what white and what black land behind the page's own
 *  boxes leave: [{ text, contrast, needed }]. Land of any colour between leaves more. */
const texts = (page) =>
  page.evaluate(async () => {
    await Promise.all(document.getAnimations().filter((a) => a.effect.getTiming().iterations !== Infinity).map((a) => a.finished));
    const colour = (text) => {
      const found = /^rgba?\((\d+), (\d+), (\d+)(?:, ([\d.]+))?\)$/.exec(text);
      if (found === null) throw new Error(`no colour that this test reads: ${text}`);
      return { rgb: found.slice(1, 4).map((v) => v / 255), alpha: Number(found[4] ?? 1) };
    };
    const mix = (under, over, share) => under.map((v, i) => v + (over[i] - v) * share);
    const over = (under, text) => {
      const { rgb, alpha } = colour(text);
      return mix(under, rgb, alpha);
    };
    /** `styles`: of the boxes from the body's child to the text's own, each upon the one before. */
    const paint = ([style, ...inner], under, ink) => {
      const ground = over(under, style.backgroundColor);
      const both = inner.length > 0 ? paint(inner, ground, ink) : { ground, letters: over(ground, ink) };
      const share = Number(style.opacity);
      return { ground: mix(under, both.ground, share), letters: mix(under, both.letters, share) };
    };
    const luminance = (rgb) =>
      rgb.map((v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
    const contrast = (a, b) => {
      const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
      return (high + 0.05) / (low + 0.05);
    };
    const seen = [];
    const look = (text, element, ...pseudo) => {
      const styles = [];
      for (let at = element; at !== document.body; at = at.parentElement) styles.unshift(getComputedStyle(at));
      styles.push(...pseudo);
      if (styles.some((style) => Number(style.opacity) === 0)) return;
      const own = styles.at(-1);
      const size = parseFloat(own.fontSize);
      const isLarge = size >= 24 || (size >= 18.66 && Number(own.fontWeight) >= 700);
      const left = [[1, 1, 1], [0, 0, 0]].map((land) => {
        const { ground, letters } = paint(styles, land, own.color);
        return contrast(ground, letters);
      });
      seen.push({ text: text.trim().slice(0, 60), contrast: Math.min(...left), needed: isLarge ? 3 : 4.5 });
    };
    for (const element of document.body.querySelectorAll('*')) {
      if (['SCRIPT', 'NOSCRIPT', 'OPTION'].includes(element.tagName) || element.closest('noscript')) continue;
      // What is disabled need not be read (WCAG 2, 1.4.3).
      if (element.closest(':disabled, [aria-disabled=true]')) continue;
      if (!element.checkVisibility({ visibilityProperty: true }) || element.getClientRects().length === 0) continue;
      const text = element instanceof HTMLSelectElement ? (element.selectedOptions[0]?.text ?? '') : [...element.childNodes].filter((n) => n.nodeType === Node.TEXT_NODE).map((n) => n.data).join('');
      if (text.trim() !== '') look(text, element);
      if (element instanceof HTMLInputElement && ['text', 'password'].includes(element.type)) {
        if (element.value !== '') look(element.value, element);
        else if (element.placeholder !== '') look(element.placeholder, element, { ...pick(getComputedStyle(element, '::placeholder')), backgroundColor: 'rgba(0, 0, 0, 0)' });
      }
      for (const name of ['::before', '::after']) {
        const style = getComputedStyle(element, name);
        if (/^".*\w.*"$/.test(style.content)) look(style.content, element, style);
      }
    }
    function pick({ color, opacity, fontSize, fontWeight }) {
      return { color, opacity, fontSize, fontWeight };
    }
    return seen;
  });

async function legible(page, where, shown) {
  const seen = await texts(page);
  for (const text of shown) assert.ok(seen.some((s) => s.text.includes(text)), `${where}: '${text}' is not among ${JSON.stringify(seen.map((s) => s.text))}`);
  const weak = seen.filter((s) => !(s.contrast >= s.needed)).map((s) => `'${s.text}': ${s.contrast.toFixed(2)}, not ${s.needed}`);
  assert.deepEqual(weak, [], where);
  return seen.reduce((least, s) => (s.contrast < least.contrast ? { ...s, where } : least), { contrast: Infinity });
}

for (const [screen, options] of [
  ['a desk', { viewport: { width: 1100, height: 760 } }],
  ['a phone', { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true }],
])
  test(`all text on ${screen} has a contrast of 4.5, before snow and before night`, async (t) => {
    const site = await startSite(t);
    const page = await newPage(await launch(t), { ...options, reducedMotion: 'reduce' });
    let least = { contrast: Infinity };
    const check = async (where, ...shown) => {
      const weakest = await legible(page, where, shown);
      if (weakest.contrast < least.contrast) least = weakest;
    };

    // Before the land comes.
    let open;
    const opened = new Promise((resolve) => (open = resolve));
    await page.routeWebSocket(/v1\/stream/, async (socket) => {
      await opened;
      const server = socket.connectToServer();
      socket.onMessage((message) => server.send(message));
      server.onMessage((message) => socket.send(message));
    });
    // One picture: text lies before it, and software takes long for one of this size.
    await page.goto(`${site.url}#radius=2&horizon=0&quality=low&frameRate=0.02`);
    await page.locator('#opening').waitFor();
    await check('opening', 'Connecting');
    open();
    await page.waitForFunction(() => window.talus.engine?.stats().hasPicture);
    await page.locator('#hint').waitFor();
    await check('the hint', screen === 'a desk' ? 'all keys' : 'Left thumb');
    await page.locator('#hint-close').dispatchEvent('click');

    const panel = async (key, ...shown) => {
      await page.focus('#stage');
      await page.keyboard.press(key);
      await check(key, ...shown);
    };
    await panel('KeyG', 'Go to', 'x z, or x y z', 'To the spawn');
    await page.keyboard.type('nowhere');
    await page.keyboard.press('Enter');
    await check('a wrong coordinate', 'nowhere', 'Two or three numbers');
    await page.keyboard.press('Escape');
    await panel('KeyT', 'Let time run');
    await page.keyboard.press('Escape');
    await page.locator('[data-panel=slice]').click();
    await check('slice', 'Strata', ...(screen === 'a desk' ? ['['] : []));
    await page.locator('[data-panel=slice]').click();
    await panel('KeyP', 'Chunks by level');
    await page.keyboard.press('Escape');
    await panel('KeyK', 'always leads to this very view', 'Save a picture');
    await page.keyboard.press('Escape');
    await panel('KeyO', 'As the system says', 'Looking speed');
    await page.locator('#token-change').click();
    await check('token', 'Connect', 'Keep it on this device');
    await page.locator('#token-cancel').click();
    await page.keyboard.press('Escape');
    if (screen === 'a desk') {
      await page.locator('#open-map').hover();
      await check('a tool under the pointer', 'Map  M');
    }
    await page.focus('#stage');
    await page.keyboard.press('KeyV');
    await page.locator('#edit-said').waitFor();
    await check('building', (await page.locator('#edit-said').textContent()).slice(0, 20));
    await page.keyboard.press('KeyH');
    await check('help', 'walk or fly', screen === 'a desk' ? 'Page up' : 'put the thumb down');
    await page.keyboard.press('Escape');
    await page.keyboard.press('KeyM');
    await page.locator('#map canvas').waitFor();
    await page.waitForFunction(() => document.querySelector('.map-at').textContent !== '');
    await check('the map');
    await page.keyboard.press('Escape');
    await site.talusd.kill();
    await page.locator('#notice[data-kind=away]').waitFor();
    await check('a notice', 'The server is away');
    t.diagnostic(`the least contrast on ${screen} is ${least.contrast.toFixed(2)}: ${least.where}, '${least.text}'`);
    noProblems(page, [/\/map\/.* 404|404 \(Not Found\)/, /ERR_CONNECTION|WebSocket connection|502/]);
  });
