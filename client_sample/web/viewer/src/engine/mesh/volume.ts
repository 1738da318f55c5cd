// A chunk with an apron of one voxel from its 26 neighbours: the mesher's input.

export const SIDE = 32;
export const PADDED = SIDE + 2;
export const PADDED_VOXELS = PADDED * PADDED * PADDED;

/** In an apron: the neighbour is unknown. No face is drawn towards it, and it occludes nothing. */
export const UNKNOWN = 0xffff;

/** Index of (x, y, z), each -1 to 32. */
export const paddedIndex = (x: number, y: number, z: number): number =>
  ((y + 1) * PADDED + z + 1) * PADDED + x + 1;

export const voxelIndex = (x: number, y: number, z: number): number => (y * SIDE + z) * SIDE + x;

/** The part of a chunk that its neighbours see: its outermost voxels, or its uniform material. */
export type Shell = number | Uint16Array;

const FACE = SIDE * SIDE;

/** Six faces: x = 0, x = 31 as [y][z], y = 0, y = 31 as [z][x], z = 0, z = 31 as [y][x]. */
export function shellOf(voxels: Uint16Array): Uint16Array {
  const shell = new Uint16Array(6 * FACE);
  for (let a = 0; a < SIDE; a++) {
    for (let b = 0; b < SIDE; b++) {
      const at = a * SIDE + b;
      shell[at] = voxels[voxelIndex(0, a, b)]!;
      shell[FACE + at] = voxels[voxelIndex(31, a, b)]!;
      shell[4 * FACE + at] = voxels[voxelIndex(b, a, 0)]!;
      shell[5 * FACE + at] = voxels[voxelIndex(b, a, 31)]!;
    }
  }
  shell.set(voxels.subarray(0, FACE), 2 * FACE);
  shell.set(voxels.subarray(31 * FACE), 3 * FACE);
  return shell;
}

/** Fills `padded`. `neighbour` returns the shell at an offset of -1, 0 or 1 along each axis. */
export function fillPadded(
  padded: Uint16Array,
  centre: number | Uint16Array,
  neighbour: (dx: number, dy: number, dz: number) => Shell | undefined,
): void {
  if (typeof centre === 'number') {
    for (let y = 0; y < SIDE; y++) {
      for (let z = 0; z < SIDE; z++) {
        const to = paddedIndex(0, y, z);
        padded.fill(centre, to, to + SIDE);
      }
    }
  } else {
    for (let y = 0; y < SIDE; y++) {
      for (let z = 0; z < SIDE; z++) {
        let to = paddedIndex(0, y, z);
        let from = voxelIndex(0, y, z);
        for (const end = from + SIDE; from < end; ) padded[to++] = centre[from++]!;
      }
    }
  }
  for (let dy = -1; dy <= 1; dy++) {
    for (let dz = -1; dz <= 1; dz++) {
      for (let dx = -1; dx <= 1; dx++) {
        if (dx !== 0 || dy !== 0 || dz !== 0) fillPart(padded, neighbour(dx, dy, dz), dx, dy, dz);
      }
    }
  }
}

const first = (d: number) => (d < 0 ? -1 : d > 0 ? SIDE : 0);
const last = (d: number) => (d < 0 ? -1 : d > 0 ? SIDE : SIDE - 1);

function fillPart(padded: Uint16Array, shell: Shell | undefined, dx: number, dy: number, dz: number): void {
  const x0 = first(dx);
  const x1 = last(dx);
  // The visible face of the neighbour, and the steps along it.
  const face = dx !== 0 ? (dx < 0 ? 1 : 0) : dy !== 0 ? (dy < 0 ? 3 : 2) : dz < 0 ? 5 : 4;
  const [stepX, stepY, stepZ] = dx !== 0 ? [0, SIDE, 1] : dy !== 0 ? [1, 0, SIDE] : [1, SIDE, 0];
  for (let y = first(dy); y <= last(dy); y++) {
    for (let z = first(dz); z <= last(dz); z++) {
      const to = paddedIndex(x0, y, z);
      if (shell === undefined || typeof shell === 'number') {
        const material = shell ?? UNKNOWN;
        for (let i = to; i <= to + x1 - x0; i++) padded[i] = material;
      } else {
        let from = face * FACE + (x0 & 31) * stepX! + (y & 31) * stepY! + (z & 31) * stepZ!;
        for (let i = to; i <= to + x1 - x0; i++, from += stepX!) padded[i] = shell[from]!;
      }
    }
  }
}
