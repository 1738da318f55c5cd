import { expect, test } from 'vitest';
import { planeBefore } from '../../src/ui/slice_panel';
import { bytes } from '../../src/ui/traffic_panel';
import { FIELD_OF_VIEW, rayThrough } from '../../src/ui/voxel_card';

const near = (a: { x: number; y: number; z: number }, [x, y, z]: [number, number, number]) => {
  expect(a.x).toBeCloseTo(x, 9);
  expect(a.y).toBeCloseTo(y, 9);
  expect(a.z).toBeCloseTo(z, 9);
};

test('the middle of the screen is where one looks', () => {
  near(rayThrough(0, 0, 0, 0), [0, 0, -1]);
  near(rayThrough(90, 0, 0, 0), [1, 0, 0]);
  near(rayThrough(180, -30, 0, 0), [0, -0.5, Math.cos(Math.PI / 6)]);
});

test('the top of the screen is half a field of view higher, the right is to the right', () => {
  const half = ((FIELD_OF_VIEW / 2) * Math.PI) / 180;
  near(rayThrough(0, 0, 0, 1), [0, Math.sin(half), -Math.cos(half)]);
  near(rayThrough(0, 0, 1, 0), [Math.sin(half), 0, -Math.cos(half)]);
  near(rayThrough(90, 0, 1, 0), [Math.cos(half), 0, Math.sin(half)]);
});

test('a slice stands across where one looks, and takes away what lies before it', () => {
  const { x, z, yaw } = planeBefore({ x: 10, z: 20, yaw: 90 }, 5);
  expect(x).toBeCloseTo(15, 9);
  expect(z).toBeCloseTo(20, 9);
  // The normal, (sin yaw, -cos yaw), points back to the player.
  expect(Math.sin(yaw)).toBeCloseTo(-1, 9);
});

test('bytes', () => {
  expect([0, 999, 1000, 12345, 1.5e6, 9.9e11].map(bytes)).toEqual(['0 B', '999 B', '1.00 kB', '12.3 kB', '1.50 MB', '990 GB']);
});
