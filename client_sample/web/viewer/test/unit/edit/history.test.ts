// Undoing one's own edits, and what tools aim at.
import { describe, expect, it } from 'vitest';
import { History, pairsThatFit, undoing } from '../../../src/edit/history.js';
import { aim, beforeFace, boxOf, eachVoxel, sidesOf, volumeOf } from '../../../src/edit/target.js';

const made = (x: number, before = 2, after = 0) => ({ voxel: { x, y: 0, z: 0 }, before, after });

describe('undo', () => {
  it('is guarded by what the edit made, and writes what was before', () => {
    expect(undoing([made(1, 5, 7)], 10)[0]!.edit).toEqual({
      guards: [{ voxel: { x: 1, y: 0, z: 0 }, material: 7 }],
      writes: [{ voxel: { x: 1, y: 0, z: 0 }, material: 5 }],
    });
  });
  it('comes in parts that fit a frame and the limits', () => {
    expect(pairsThatFit(65_536, 65_536)).toBe(1_020);
    expect(pairsThatFit(65_536, 100)).toBe(50);
    expect(pairsThatFit(65_536, 0)).toBe(1_020);
    const all = Array.from({ length: 25 }, (_, i) => made(i));
    const parts = undoing(all, 10);
    expect(parts.map((part) => part.made.length)).toEqual([10, 10, 5]);
    expect(parts.flatMap((part) => part.made)).toEqual(all);
  });
  it('begins with the last, and leaves out what never happened', () => {
    const history = new History();
    history.push([made(1)]);
    const second = history.push([made(2)]);
    const third = history.push([made(3)]);
    history.remove(second);
    expect(history.pop()).toBe(third);
    expect(history.pop()!.made).toEqual([made(1)]);
    expect(history.pop()).toBeUndefined();
    expect(history.isEmpty).toBe(true);
  });
  it('forgets the oldest of very many', () => {
    const history = new History();
    for (let i = 0; i < 300; ++i) history.push([made(i)]);
    let steps = 0;
    for (let step = history.pop(); step !== undefined; step = history.pop()) ++steps;
    expect(steps).toBe(200);
  });
});

describe('aiming', () => {
  const hit = { x: 4, y: 5, z: 6, material: 2, distance: 3, normal: { x: 0, y: 1, z: 0 } };
  it('takes away what one looks at, and builds before its face', () => {
    expect(aim(hit, 'dig', 9)).toEqual({ x: 4, y: 5, z: 6 });
    expect(aim(hit, 'build', 9)).toEqual({ x: 4, y: 6, z: 6 });
    expect(aim(hit, 'fill', 9)).toEqual({ x: 4, y: 6, z: 6 });
    expect(aim(hit, 'fill', 0)).toEqual({ x: 4, y: 5, z: 6 });
  });
  it('builds nothing where the eye is inside of something', () => {
    expect(beforeFace({ ...hit, normal: { x: 0, y: 0, z: 0 } })).toBeNull();
  });
  it('has boxes of any two corners', () => {
    const box = boxOf({ x: 3, y: -1, z: 0 }, { x: 1, y: 1, z: -2 });
    expect(box).toEqual({ first: { x: 1, y: -1, z: -2 }, last: { x: 3, y: 1, z: 0 } });
    expect(sidesOf(box)).toEqual([3, 3, 3]);
    let voxels = 0;
    eachVoxel(box, () => ++voxels);
    expect(voxels).toBe(volumeOf(box));
  });
});
