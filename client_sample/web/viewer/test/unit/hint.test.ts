import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Hint } from '../../src/ui/hint';

let box: { hidden: boolean; isHeld: boolean; matches: () => boolean };
let close: () => void;

beforeEach(() => {
  box = { hidden: true, isHeld: false, matches: () => box.isHeld };
  const button = { addEventListener: (_: string, then: () => void) => (close = then) };
  vi.stubGlobal('document', { getElementById: (id: string) => (id === 'hint' ? box : button) });
});
afterEach(() => vi.unstubAllGlobals());

const hint = () => new Hint(() => {});

test('it shows while the land comes, and goes a while after', () => {
  const shown = hint();
  for (const now of [0, 50_000, 100_000]) shown.tick(now, false, false);
  expect(box.hidden).toBe(false);
  shown.tick(100_000, true, false);
  shown.tick(111_000, true, false);
  expect(box.hidden).toBe(false);
  shown.tick(113_000, true, false);
  expect(box.hidden).toBe(true);
  shown.tick(114_000, false, false);
  expect(box.hidden).toBe(true);
});

test('it goes at once when one moves, or closes it, and stays away', () => {
  const moved = hint();
  moved.tick(0, false, true);
  expect(box.hidden).toBe(true);
  const closed = hint();
  closed.tick(0, false, false);
  expect(box.hidden).toBe(false);
  close();
  closed.tick(1, false, false);
  expect(box.hidden).toBe(true);
});

test('it stays with who points at it', () => {
  const held = hint();
  held.tick(0, true, false);
  box.isHeld = true;
  held.tick(11_000, true, false);
  held.tick(60_000, true, false);
  box.isHeld = false;
  held.tick(61_000, true, false);
  held.tick(72_000, true, false);
  expect(box.hidden).toBe(false);
  held.tick(74_000, true, false);
  expect(box.hidden).toBe(true);
});
