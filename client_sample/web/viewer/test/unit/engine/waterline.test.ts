import { expect, test } from 'vitest';
import { waterline } from '../../../src/engine/waterline.js';

// Water in voxels up to 9: its top is 10, its surface 9.86.
const lake = (y: number) => Math.floor(y) < 10;

test('an eye between the drawn surface and the top of its voxel is above water', () => {
  expect(waterline(lake, 9.85).under).toBe(true);
  expect(waterline(lake, 9.87).under).toBe(false);
  expect(waterline(lake, 3).under).toBe(true);
});

test('an eye in air below a lake without a bed is not under water', () => {
  const above = (y: number) => Math.floor(y) >= 5;
  expect(waterline(above, 4.9).under).toBe(false);
});

test('close to water is half a block from the drawn surface, over and under', () => {
  expect([9.35, 9.37, 9.86, 10.35, 10.37].map((y) => waterline(lake, y).close)).toEqual([false, true, true, true, false]);
});
