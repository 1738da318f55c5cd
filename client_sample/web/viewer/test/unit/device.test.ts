import { expect, test } from 'vitest';
import { capOf, capped } from '../../src/place/device';
import { defaults, fromLink, mend } from '../../src/place/settings';

const desk = { memory: 8, isCoarse: false, shortSide: 1080 };
const phone = { memory: 8, isCoarse: true, shortSide: 390 };

test('a desk has no cap', () => {
  expect(capOf(desk)).toBeNull();
  expect(capOf({ ...desk, memory: null })).toBeNull();
});

test('a phone has one, whatever memory it tells', () => {
  for (const memory of [8, 4, null]) expect(capOf({ ...phone, memory })).toEqual({ radius: 10, horizon: 4096 });
});

test('so has a tablet that tells of little memory or of none, and not one with much', () => {
  const tablet = { ...phone, shortSide: 820 };
  expect(capOf({ ...tablet, memory: null })).not.toBeNull();
  expect(capOf({ ...tablet, memory: 4 })).not.toBeNull();
  expect(capOf({ ...tablet, memory: 8 })).toBeNull();
});

test('little memory caps more, by whatever one points', () => {
  expect(capOf({ ...desk, memory: 2 })).toEqual({ radius: 6, horizon: 2048 });
  expect(capOf({ ...phone, memory: 1 })).toEqual({ radius: 6, horizon: 2048 });
});

test('settings of a link stay within the cap, and what is less stays as it is', () => {
  const cap = capOf(phone);
  const far = mend(defaults(true), fromLink('#radius=24&horizon=16384'));
  expect(capped(far, cap)).toEqual({ ...far, radius: 10, horizon: 4096 });
  expect(capped(far, null)).toEqual(far);
  const near = mend(defaults(true), fromLink('#radius=3&horizon=0'));
  expect(capped(near, cap)).toEqual(near);
  expect(capped({ quality: 'low' }, cap)).toEqual({ quality: 'low' });
});

test('the defaults of a phone are within its cap', () => {
  expect(capped(defaults(true), capOf(phone))).toEqual(defaults(true));
  expect(capped(defaults(true), capOf({ ...phone, memory: 2 }))).toEqual(defaults(true));
});
