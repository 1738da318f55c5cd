import { expect, test } from 'vitest';
import { defaults, fromLink, load, mend, save } from '../../src/place/settings';

const base = defaults(false);

function memory(): Storage {
  const kept = new Map<string, string>();
  return { getItem: (k: string) => kept.get(k) ?? null, setItem: (k: string, v: string) => void kept.set(k, v) } as Storage;
}

test('what was saved is loaded', () => {
  const storage = memory();
  save({ ...base, radius: 5 }, () => storage);
  expect(load(base, () => storage).radius).toBe(5);
});

test('a browser without storage has the defaults', () => {
  const refuses = () => {
    throw new DOMException('denied', 'SecurityError');
  };
  save(base, refuses);
  expect(load(base, refuses)).toEqual(base);
});

test('settings that do not fit are as they were', () => {
  expect(mend(base, { radius: 1e9, quality: 'ultra', timeRuns: 'yes', __proto__: null, other: 1 })).toEqual(base);
  expect(mend(base, 'nonsense')).toEqual(base);
});

test('settings of a link', () => {
  expect(mend(base, fromLink('#radius=4&horizon=0&transport=http&timeRuns=true&at=1,2,3'))).toEqual({
    ...base,
    radius: 4,
    horizon: 0,
    transport: 'http',
    timeRuns: true,
  });
});
