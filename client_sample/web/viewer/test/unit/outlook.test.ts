import { expect, test } from 'vitest';
import { bestHeading, outlookRequest } from '../../src/place/outlook';

const SIDE = 19;

function heights(of: (x: number, z: number) => number): number[] {
  const all: number[] = [];
  for (let z = -9; z <= 9; ++z) for (let x = -9; x <= 9; ++x) all.push(of(x, z));
  return all;
}

test('one looks over open ground to high land, not at a wall', () => {
  expect(bestHeading(heights((x, z) => (x > 6 && Math.abs(z) < 2 ? 200 : 0)))).toBe(90);
  expect(bestHeading(heights((x, z) => (x < -6 && Math.abs(z) < 2 ? 200 : 0)))).toBe(270);
  // Mountains all around, nearer in the north.
  expect(bestHeading(heights((x, z) => (Math.hypot(x, z) > 6 || z < -3 ? 200 : 0)))).not.toBe(0);
  expect(bestHeading(heights(() => 7))).toBe(0);
});

test('the request is a square around the column, in whole blocks', () => {
  expect(outlookRequest(10.7, -3.2)).toBe('v1/heights?x=-890&z=-904&w=19&h=19&step=100');
  expect(heights(() => 0)).toHaveLength(SIDE * SIDE);
});
