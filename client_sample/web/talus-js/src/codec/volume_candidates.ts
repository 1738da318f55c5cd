// The second and third candidates of a voxel: FORMAT.md, "Volume: prediction". Few voxels need them.

const SIZE = 32;

/** Candidate `wanted` (0 to 2) of the voxel at `x` of `row`; -1 if there are fewer. Rows are indexes of their first
 *  voxels. */
export function candidate(
  voxels: Uint16Array,
  row: number,
  north: number,
  below: number,
  belowNorth: number,
  belowSouth: number,
  x: number,
  wanted: number,
): number {
  const east = x === SIZE - 1 ? x : x + 1;
  const west = x === 0 ? 0 : x - 1;
  const n = voxels[north + x]!;
  const b = voxels[below + x]!;
  const d = voxels[belowNorth + x]!;
  const s = voxels[belowSouth + x]!;
  const base = b === d ? n : b;
  const other = b === d ? b : n;
  let count = 0;
  let first = -1;
  let second = -1;
  for (let i = x & 1 ? 0 : 2; i < 10; ++i) {
    let material: number;
    switch (i) {
      case 0:
      case 1: {
        const w = voxels[row + x - 1]!;
        const e = x === SIZE - 1 ? w : voxels[row + x + 1]!;
        const eastFirst = base === e || (base !== w && other === e);
        material = eastFirst === (i === 0) ? e : w;
        break;
      }
      case 2:
        material = base;
        break;
      case 3:
        material = other;
        break;
      case 4:
        material = voxels[north + east]!;
        break;
      case 5:
        material = voxels[north + west]!;
        break;
      case 6:
        material = voxels[below + east]!;
        break;
      case 7:
        material = voxels[below + west]!;
        break;
      case 8:
        material = s;
        break;
      default:
        material = d;
    }
    if (material === first || material === second) continue;
    if (count === wanted) return material;
    if (count === 0) first = material;
    else second = material;
    ++count;
  }
  return -1;
}
