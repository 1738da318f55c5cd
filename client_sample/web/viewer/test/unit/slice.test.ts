// Where a cut begins.
import { expect, test } from 'vitest';
import { firstDistance, planeBefore } from '../../src/ui/slice_panel';

test('a cut goes through what one looks at, within the reach of its slider', () => {
  expect(firstDistance(75.4)).toBe(75);
  expect(firstDistance(0.3)).toBe(4);
  expect(firstDistance(1000)).toBe(256);
  // The sky: far enough to be seen.
  expect(firstDistance(null)).toBe(96);
});

test('a plane stands across the direction, and the land before it is taken away', () => {
  const plane = planeBefore({ x: 10, z: 20, yaw: 90 }, 30);
  expect(plane.x).toBeCloseTo(40);
  expect(plane.z).toBeCloseTo(20);
  expect(Math.sin(plane.yaw)).toBeCloseTo(-1);
});
