// Where two levels of detail meet, land that stands higher on one side shows a wall there, so that nobody looks into it: the
// meshes of both sides, for land of any slope up to 3 in 1, at rows of chunks too, and with neighbours of the own level or none.
import { describe, expect, it } from 'vitest';
import { GAS, SOLID, meshChunk } from '../../../src/engine/mesh/mesher.js';
import { EAST, FACES, SKIRTS, WEST, unpack } from '../../../src/engine/mesh/quad.js';
import { PADDED_VOXELS, SIDE, UNKNOWN, paddedIndex } from '../../../src/engine/mesh/volume.js';

const options = { kinds: Uint8Array.of(GAS, SOLID), places: Uint16Array.of(0, 1), slot: 1, occlusion: false, grounded: true, kept: null };
/** Of base voxels, where the fine level (to the west) ends and the coarse one begins. */
const BORDER = SIDE;

type Height = (x: number, z: number) => number;

/** The mesh's walls toward `face` at its side, by row and place along the side. */
function wallsOf(height: Height, scale: number, x0: number, y0: number, face: typeof EAST | typeof WEST, isAlone: boolean): Set<string> {
  const padded = new Uint16Array(PADDED_VOXELS);
  const beyond = face === EAST ? SIDE : -1;
  for (let z = -1; z <= SIDE; z++)
    for (let x = -1; x <= SIDE; x++) {
      const top = height(x0 / scale + x, z);
      for (let y = -1; y <= SIDE; y++) padded[paddedIndex(x, y, z)] = isAlone && x === beyond ? UNKNOWN : y0 + y < top ? 1 : 0;
    }
  const { quads, counts } = meshChunk(padded, options);
  const walls = new Set<string>();
  let first = 0;
  counts.forEach((count, group) => {
    const isOfFace = group === face || group === FACES.length + SKIRTS.indexOf(face);
    for (let i = first; isOfFace && i < first + count; i++) {
      const quad = unpack(quads[2 * i]!, quads[2 * i + 1]!);
      if (quad.x !== (face === EAST ? SIDE - 1 : 0)) continue;
      for (let y = quad.y; y < quad.y + quad.height; y++) for (let z = quad.z; z < quad.z + quad.width; z++) walls.add(`${y0 + y} ${z}`);
    }
    first += count;
  });
  return walls;
}

describe('between levels of detail', () => {
  for (const slope of [0.3, 1, 3])
    for (const isAlone of [true, false])
      it(`no wall is missing: slope ${slope}, ${isAlone ? 'no' : 'a'} neighbour of the same level`, () => {
        for (let seed = 0; seed < 12; seed++) {
          const land = (x: number, z: number) => 34 + 9 * Math.sin((x - BORDER) * (slope / 9) + seed) + 4 * Math.sin((z * slope) / 8 + 2.4 * seed);
          const fine: Height = (x, z) => Math.round(land(x + 0.5, z + 0.5));
          const coarse: Height = (x, z) => Math.round(land(2 * x + 1, 2 * z + 1) / 2);
          const fineWalls = [0, SIDE].map((y0) => wallsOf(fine, 1, 0, y0, EAST, isAlone));
          const coarseWalls = wallsOf(coarse, 2, BORDER, 0, WEST, isAlone);
          for (let z = 0; z < SIDE; z++)
            for (let y = 0; y < 2 * SIDE; y++) {
              const isFine = y < fine(BORDER - 1, z);
              const isCoarse = y >> 1 < coarse(BORDER / 2, z >> 1);
              const where = `seed ${seed}, row ${y}, z ${z}: ${isFine ? 'fine' : 'coarse'} land`;
              if (isFine && !isCoarse) expect(fineWalls[y >> 5]!.has(`${y} ${z}`), where).toBe(true);
              if (isCoarse && !isFine) expect(coarseWalls.has(`${y >> 1} ${z >> 1}`), where).toBe(true);
            }
        }
      });
});
