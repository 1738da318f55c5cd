// How a quad is packed into two 32-bit words, which the vertex shader takes apart again (shaders/terrain.ts).
//
//   word 0   x 5 | y 5 | z 5 | face 3 | width - 1: 5 | height - 1: 5 | flip 1 | cut 1 | material, high bits 2
//   word 1   slot 16 | ambient occlusion 4 x 2 | material, low bits 8
//
// (x, y, z) is the lowest voxel that the quad covers. Width goes along u, height along v: faces x have u = z, v = y;
// faces y have u = x, v = z; faces z have u = x, v = y. Occlusion is that of the corners (0, 0), (1, 0), (1, 1),
// (0, 1) in (u, v), 0 dark to 3 open. `flip`: the diagonal joins corners 1 and 3, so that occlusion is interpolated
// alike on both sides. `cut`: the face is open only because a slice cuts the land there. `material` is the place in
// the world's list of materials.

export const MATERIALS_MAX = 1024;
export const SLOTS = 1 << 16;

/** Order in a mesh; faces that a camera sees together tend to be adjacent. */
export const FACES = [
  { axis: 0, sign: -1 },
  { axis: 2, sign: -1 },
  { axis: 1, sign: 1 },
  { axis: 0, sign: 1 },
  { axis: 2, sign: 1 },
  { axis: 1, sign: -1 },
] as const;

export const [WEST, NORTH, UP, EAST, SOUTH, DOWN] = [0, 1, 2, 3, 4, 5] as const;

/** Sides of a chunk that have a skirt; in a mesh, skirts follow the faces in this order. */
export const SKIRTS = [WEST, NORTH, EAST, SOUTH] as const;
export const GROUPS = FACES.length + SKIRTS.length;

export interface Quad {
  x: number;
  y: number;
  z: number;
  face: number;
  width: number;
  height: number;
  flip: boolean;
  cut: boolean;
  material: number;
  slot: number;
  occlusion: [number, number, number, number];
}

export function unpack(low: number, high: number): Quad {
  const ao = high >>> 16;
  return {
    x: low & 31,
    y: (low >>> 5) & 31,
    z: (low >>> 10) & 31,
    face: (low >>> 15) & 7,
    width: ((low >>> 18) & 31) + 1,
    height: ((low >>> 23) & 31) + 1,
    flip: ((low >>> 28) & 1) === 1,
    cut: ((low >>> 29) & 1) === 1,
    material: ((low >>> 30) << 8) | (high >>> 24),
    slot: high & 0xffff,
    occlusion: [ao & 3, (ao >>> 2) & 3, (ao >>> 4) & 3, (ao >>> 6) & 3],
  };
}
