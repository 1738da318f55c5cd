import { expect, test } from 'vitest';
import { bestHeading, clearHeading, outlookRequest } from '../../src/place/outlook';

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

test('one turns from what stands near in the middle of the view', () => {
  const crown = (x: number, z: number) => Math.hypot(x, z + 20) < 3;
  const look = (yaw: number, at: (x: number, y: number, z: number) => number | undefined) =>
    clearHeading([0.5, 10.5, 0.5], yaw, -8, at, (material) => material === 1);
  expect(look(0, () => 0)).toBe(0);
  expect(look(0, (x, _, z) => (crown(x, z) ? 1 : 0))).toBe(15);
  expect(look(10, (x, _, z) => (x > 2 || crown(x, z) ? 1 : 0))).toBe(340);
  // Beyond the near, and below the ray.
  expect(look(0, (_x, y, z) => (z < -66 || y < 1 ? 1 : 0))).toBe(0);
  expect(look(0, (_x, _y, z) => (z < -30 ? undefined : 0))).toBeUndefined();
  // Walls all around.
  expect(look(30, (x, _, z) => (Math.hypot(x, z) > 10 ? 1 : 0))).toBe(30);
});
