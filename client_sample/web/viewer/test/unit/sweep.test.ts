import { expect, test } from 'vitest';
import { overlaps, sweep, type Box, type Vector } from '../../src/controls/sweep';

const floorAndWall = (x: number, y: number) => y < 0 || x >= 3;
const box = (x: number, y: number): Box => ({ low: [x, y, 0.2], high: [x + 0.6, y + 1.8, 0.8] });

test('a box stops at the face of what is in its way', () => {
  expect(sweep(box(1, 0), 0, 5, floorAndWall)).toBeCloseTo(1.4, 9);
  expect(sweep(box(1, 0.25), 1, -3, floorAndWall)).toBeCloseTo(-0.25, 9);
  expect(sweep(box(1, 0), 0, -5, floorAndWall)).toBe(-5);
});

test('no speed jumps over a wall of one voxel', () => {
  const wall = (x: number) => x === 700;
  expect(sweep(box(1, 0), 0, 5000, wall)).toBeCloseTo(698.4, 6);
});

test('touching is not overlapping, far from the origin too', () => {
  const far = 2 ** 35;
  const ground = (_x: number, y: number) => y < 0;
  const at: Box = { low: [far, 0, far], high: [far + 0.6, 1.8, far + 0.6] };
  expect(overlaps(at, ground)).toBe(false);
  expect(sweep(at, 1, -1, ground)).toBe(0);
});

test('a box moved at random among random voxels is never inside one', () => {
  const seed = Date.now() >>> 0;
  let state = seed;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  const solid = (x: number, y: number, z: number) => (Math.imul(x * 73 + y * 179 + z * 283, 2654435761) >>> 28) < 3;
  let at: Vector = [0, 0, 0];
  const around = (): Box => ({ low: at, high: [at[0] + 0.6, at[1] + 1.8, at[2] + 0.6] });
  while (overlaps(around(), solid)) at = [random() * 50, random() * 50, random() * 50];
  for (let i = 0; i < 3000; ++i) {
    const axis = Math.floor(random() * 3) as 0 | 1 | 2;
    at[axis] += sweep(around(), axis, (random() - 0.5) * 9, solid);
    expect(overlaps(around(), solid), `seed ${seed}, move ${i}`).toBe(false);
  }
});
