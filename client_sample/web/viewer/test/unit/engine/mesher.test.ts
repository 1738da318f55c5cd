// The mesher against a plain reference: every face that can be seen is covered by one quad, and no other.
import { describe, expect, it } from 'vitest';
import { GAS, LIQUID, SOLID, meshChunk, type ChunkMesh, type KeptColumns } from '../../../src/engine/mesh/mesher.js';
import { FACES, GROUPS, unpack } from '../../../src/engine/mesh/quad.js';
import { PADDED_VOXELS, SIDE, UNKNOWN, fillPadded, paddedIndex, shellOf, voxelIndex } from '../../../src/engine/mesh/volume.js';

const kinds = Uint8Array.of(GAS, LIQUID, SOLID, SOLID, SOLID);
const places = Uint16Array.from({ length: 65536 }, (_, id) => (id < 5 ? id : 5));
const options = { kinds, places, slot: 7, occlusion: true, grounded: false, kept: null };

function random(seed: number): () => number {
  let s = seed >>> 0;
  return () => {
    s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
    return s / 2 ** 32;
  };
}

/** Hills of two rocks with holes, water below row 12, and an apron some of which is unknown. */
function land(seed: number): Uint16Array {
  const next = random(seed);
  const padded = new Uint16Array(PADDED_VOXELS);
  const roughness = next() * 8;
  for (let z = -1; z <= SIDE; z++) {
    for (let x = -1; x <= SIDE; x++) {
      const top = 14 + 6 * Math.sin(x / 5 + seed) + 5 * Math.cos(z / 7) + roughness * next();
      for (let y = -1; y <= SIDE; y++) {
        const hole = next() < 0.02;
        padded[paddedIndex(x, y, z)] = y < top && !hole ? (y < top - 3 ? 2 : 3) : y < 12 ? 1 : 0;
      }
    }
  }
  if (seed % 3 === 0) for (let y = -1; y <= SIDE; y++) for (let x = -1; x <= SIDE; x++) padded[paddedIndex(x, y, -1)] = UNKNOWN;
  return padded;
}

const kindAt = (padded: Uint16Array, x: number, y: number, z: number) => {
  const material = padded[paddedIndex(x, y, z)]!;
  return material === UNKNOWN ? 'unknown' : kinds[material]!;
};

const axes = (axis: number) => (axis === 0 ? [2, 1] : axis === 1 ? [0, 2] : [0, 1]) as [number, number];

function quadsOf(mesh: ChunkMesh, from: number, to: number) {
  let first = 0;
  for (let i = 0; i < from; i++) first += mesh.counts[i]!;
  let count = 0;
  for (let i = from; i < to; i++) count += mesh.counts[i]!;
  return Array.from({ length: count }, (_, i) => unpack(mesh.quads[(first + i) * 2]!, mesh.quads[(first + i) * 2 + 1]!));
}

/** Face and voxel of all that quads cover, with what they say of it. */
function cover(quads: ReturnType<typeof quadsOf>): Map<string, { material: number; occlusion: number[] | null; times: number }> {
  const covered = new Map<string, { material: number; occlusion: number[] | null; times: number }>();
  for (const quad of quads) {
    const [u, v] = axes(FACES[quad.face]!.axis);
    for (let j = 0; j < quad.height; j++) {
      for (let i = 0; i < quad.width; i++) {
        const at = [quad.x, quad.y, quad.z];
        at[u]! += i;
        at[v]! += j;
        const key = `${quad.face}: ${at.join(' ')}`;
        // A corner's value belongs to the voxel there; between them it must not change along the merged axis.
        const o = quad.occlusion;
        if (quad.width > 1) expect([o[0], o[3]], key).toEqual([o[1], o[2]]);
        if (quad.height > 1) expect([o[0], o[1]], key).toEqual([o[3], o[2]]);
        covered.set(key, { material: quad.material, occlusion: o, times: (covered.get(key)?.times ?? 0) + 1 });
      }
    }
  }
  return covered;
}

function referenceOcclusion(padded: Uint16Array, x: number, y: number, z: number, face: number): number[] {
  const { axis, sign } = FACES[face]!;
  const [u, v] = axes(axis);
  const solid = (du: number, dv: number) => {
    const at = [x, y, z];
    at[axis]! += sign;
    at[u]! += du;
    at[v]! += dv;
    return kindAt(padded, at[0]!, at[1]!, at[2]!) === SOLID ? 1 : 0;
  };
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([du, dv]) => {
    const a = solid(du!, 0);
    const b = solid(0, dv!);
    return a && b ? 0 : 3 - a - b - solid(du!, dv!);
  });
}

function reference(padded: Uint16Array, of: number): Map<string, { material: number; occlusion: number[] | null; times: number }> {
  const visible = new Map<string, { material: number; occlusion: number[] | null; times: number }>();
  for (let y = 0; y < SIDE; y++)
    for (let z = 0; z < SIDE; z++)
      for (let x = 0; x < SIDE; x++) {
        if (kindAt(padded, x, y, z) !== of) continue;
        FACES.forEach(({ axis, sign }, face) => {
          const at = [x, y, z];
          at[axis]! += sign;
          const beyond = kindAt(padded, at[0]!, at[1]!, at[2]!);
          if (beyond === SOLID || beyond === 'unknown' || beyond === of) return;
          visible.set(`${face}: ${x} ${y} ${z}`, {
            material: padded[paddedIndex(x, y, z)]!,
            occlusion: of === SOLID ? referenceOcclusion(padded, x, y, z, face) : [3, 3, 3, 3],
            times: 1,
          });
        });
      }
  return visible;
}

describe('meshChunk', () => {
  for (const seed of [1, 2, 3, 4, 5, 6]) {
    it(`covers each visible face once, with its material and occlusion (seed ${seed})`, () => {
      const padded = land(seed);
      const mesh = meshChunk(padded, options);
      expect(cover(quadsOf(mesh, 0, 6))).toEqual(reference(padded, SOLID));
      expect(cover(quadsOf(mesh, GROUPS, GROUPS + 1))).toEqual(reference(padded, LIQUID));
    });
  }

  it('keeps quads by face, and names the slot in each', () => {
    const mesh = meshChunk(land(2), options);
    for (let face = 0; face < 6; face++) {
      for (const quad of quadsOf(mesh, face, face + 1)) expect([quad.face, quad.slot]).toEqual([face, 7]);
    }
    expect(mesh.quads.length).toBe(2 * mesh.counts.reduce((a, b) => a + b));
  });

  it('merges a floor into one quad', () => {
    const padded = new Uint16Array(PADDED_VOXELS);
    for (let y = -1; y < 4; y++) for (let z = -1; z <= SIDE; z++) for (let x = -1; x <= SIDE; x++) padded[paddedIndex(x, y, z)] = 2;
    const mesh = meshChunk(padded, options);
    expect(Array.from(mesh.counts.subarray(0, 6))).toEqual([0, 0, 1, 0, 0, 0]);
    expect(mesh.tops).toEqual(new Uint8Array(1024).fill(4));
    expect([mesh.low, mesh.high]).toEqual([0, 3]); // skirts reach down to 0
  });

  it('leaves no crack between chunks: faces at a border are those of both sides together', () => {
    // Two chunks cut from one block of voxels, against the block's own faces at the plane between them.
    const next = random(99);
    const voxels = [new Uint16Array(32768), new Uint16Array(32768)];
    for (const side of voxels) for (let i = 0; i < side.length; i++) side[i] = next() < 0.5 ? 2 : 0;
    const meshes = voxels.map((centre, i) => {
      const padded = new Uint16Array(PADDED_VOXELS);
      const other = shellOf(voxels[1 - i]!);
      fillPadded(padded, centre, (dx, dy, dz) => (dy === 0 && dz === 0 && dx === (i === 0 ? 1 : -1) ? other : undefined));
      return cover(quadsOf(meshChunk(padded, options), 0, 6));
    });
    for (let y = 0; y < SIDE; y++)
      for (let z = 0; z < SIDE; z++) {
        const west = voxels[0]![voxelIndex(31, y, z)] === 2;
        const east = voxels[1]![voxelIndex(0, y, z)] === 2;
        expect(meshes[0]!.has(`3: 31 ${y} ${z}`)).toBe(west && !east);
        expect(meshes[1]!.has(`0: 0 ${y} ${z}`)).toBe(east && !west);
      }
  });

  it('gives a wall down from the surface at each side, where the neighbour hides it', () => {
    const padded = new Uint16Array(PADDED_VOXELS);
    for (let y = -1; y < 20; y++) for (let z = -1; z <= SIDE; z++) for (let x = -1; x <= SIDE; x++) padded[paddedIndex(x, y, z)] = 2;
    const mesh = meshChunk(padded, options);
    for (let side = 0; side < 4; side++) {
      const rows = new Set([...cover(quadsOf(mesh, 6 + side, 7 + side)).keys()].map((key) => Number(key.split(' ')[2])));
      expect(rows).toEqual(new Set([8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19]));
    }
  });

  it('lets single voxels that float above the ground stand on it, where that is asked for', () => {
    const padded = new Uint16Array(PADDED_VOXELS);
    for (let z = -1; z <= SIDE; z++) for (let x = -1; x <= SIDE; x++) padded[paddedIndex(x, 3, z)] = 2;
    for (const [x, y, z] of [[5, 5, 5], [9, 6, 9], [13, 5, 13], [14, 5, 13]] as const) padded[paddedIndex(x, y, z)] = 3; // near; too high; two
    const walls = (grounded: boolean) =>
      [...cover(quadsOf(meshChunk(padded.slice(), { ...options, occlusion: false, grounded }), 0, 1))].map(([key, { material }]) => [key, material]);
    const floating = [['0: 13 5 13', 3], ['0: 5 5 5', 3], ['0: 9 6 9', 3]];
    expect(walls(false).sort()).toEqual(floating);
    expect(walls(true).sort()).toEqual([...floating, ['0: 5 4 5', 3]].sort());
  });

  it('opens the land along a slice, and marks the faces that only the slice opened', () => {
    const padded = new Uint16Array(PADDED_VOXELS).fill(2);
    const kept: KeptColumns = { mask: new Uint32Array(34).fill(0xffff), west: new Uint8Array(34).fill(1), east: new Uint8Array(34) };
    const quads = quadsOf(meshChunk(padded, { ...options, kept }), 0, 6);
    expect(quads.length).toBe(1);
    expect(quads[0]).toMatchObject({ x: 15, y: 0, z: 0, face: 3, width: 32, height: 32, cut: true });
  });
});
