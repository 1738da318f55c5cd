// Against the repository's vectors: what the engine waits for is what a server sends.
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { chunksOf, shapeOf } from '../../../src/engine/stream/shape.js';

interface Vector {
  name: string;
  centre: [string, string, string];
  horizontal_radius: number;
  vertical_radius: number;
  rings: { lod: number; radius: number }[];
  horizon?: { min_y: string; max_y: string };
  chunks: number;
  levels: { lod: number; x: number[]; y: number[]; z: number[]; inner_x: number[] | null; inner_z: number[] | null }[];
}
const file = new URL('../../../../../../core/voxel/vectors/views.json', import.meta.url);
const { views } = JSON.parse(readFileSync(file, 'utf8')) as { views: Vector[] };

describe('the shape of a View', () => {
  it.each(views.map((view) => [view.name, view] as const))('%s', (_name, view) => {
    const [x, y, z] = view.centre.map(Number) as [number, number, number];
    const { horizontal_radius: horizontalRadius, vertical_radius: verticalRadius, rings, horizon } = view;
    const shape = shapeOf(
      { centre: { x, y, z }, horizontalRadius, verticalRadius, rings, horizon: horizon !== undefined },
      { minY: Number(horizon?.min_y ?? 0), maxY: Number(horizon?.max_y ?? 0) },
    );
    expect(chunksOf(shape)).toBe(view.chunks);
    for (const level of view.levels) {
      const { x0, x1, y0, y1, z0, z1, hole } = shape[level.lod]!;
      if (x1 >= x0 && y1 >= y0 && z1 >= z0) expect([[x0, x1], [y0, y1], [z0, z1]]).toEqual([level.x, level.y, level.z]);
      if (level.inner_x === null || level.inner_z === null) expect(hole).toBeNull();
      else expect(hole).toEqual({ x0: level.inner_x[0], x1: level.inner_x[1], z0: level.inner_z[0], z1: level.inner_z[1] });
    }
  });
});
