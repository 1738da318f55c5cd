// Greedy meshing with ambient occlusion at the corners. A row of 32 voxels along x is a bit mask, so a few operations
// find the visible faces of a whole row; only these are processed one by one.
import { DOWN, EAST, GROUPS, NORTH, SKIRTS, SOUTH, UP, WEST } from './quad.js';
import {
  DX, DY, DZ, ROWS, blockEnds, blockRow, classify, eastOf, ground, liquidEnds, liquidRow, openCut, openCutEnds, row, solid, solidRow, westOf,
  type KeptColumns,
} from './rows.js';
import { PADDED, SIDE, paddedIndex } from './volume.js';

export { GAS, LIQUID, SOLID, type KeptColumns } from './rows.js';

/** Depth of a skirt below open space, in voxels. */
const SKIRT_DEPTH = 12;
/** The part of it used at the top of a border column whose surface lies in the chunk above. */
const SKIRT_CAP = 6;

export interface MeshOptions {
  /** By material id: GAS, LIQUID or SOLID. Ids beyond the end are solid. */
  readonly kinds: Uint8Array;
  /** By material id: index in the world's list. */
  readonly places: Uint16Array;
  readonly slot: number;
  readonly occlusion: boolean;
  /** Grounds single voxels that float just above the ground, such as crowns whose trunks are thinner than a voxel. */
  readonly grounded: boolean;
  /** For each row z, the voxels x that a slice keeps, as bits; null: all. 34 rows, -1 to 32, bit 0 is x = 0; western
   *  and eastern aprons have their own arrays. */
  readonly kept: KeptColumns | null;
}

export interface ChunkMesh {
  /** Two words per quad. Opaque quads by FACES, then SKIRTS, then liquid. */
  readonly quads: Uint32Array<ArrayBuffer>;
  /** Number of quads in each of FACES and SKIRTS, and finally of liquids. */
  readonly counts: Uint32Array<ArrayBuffer>;
  /** For each column (z * 32 + x): 1 + the highest solid voxel, or 0. */
  readonly tops: Uint8Array<ArrayBuffer>;
  /** The same for liquids; null without liquids. */
  readonly liquidTops: Uint8Array<ArrayBuffer> | null;
  /** Lowest and highest voxel row of a quad. */
  readonly low: number;
  readonly high: number;
}

// Buffers reused by every call: a mesher belongs to one thread.
const planes = new Uint32Array(6 * SIDE * SIDE); // for each face: [plane][row of v], bits along u
const keys = new Uint32Array(SIDE * SIDE);

let out = new Uint32Array(1 << 14);
let used = 0;
let low = SIDE;
let high = -1;

/** Writes a row of visible western or eastern faces, bits along x, to planes of x with bits along z. */
function scatter(face: number, bits: number, y: number, z: number): void {
  for (let rest = bits; rest !== 0; rest &= rest - 1) {
    const x = 31 - Math.clz32(rest & -rest);
    planes[(face * SIDE + x) * SIDE + y]! |= 1 << z;
  }
}

function facesOf(rows: Uint32Array, notToward: Uint32Array, notTowardEnds: Uint8Array): void {
  planes.fill(0);
  for (let y = 0; y < SIDE; y++) {
    for (let z = 0; z < SIDE; z++) {
      const r = row(y, z);
      const here = rows[r]!;
      if (here === 0) continue;
      const west = here & ~westOf(notToward, notTowardEnds, r);
      const east = here & ~eastOf(notToward, notTowardEnds, r);
      if (west !== 0) scatter(WEST, west, y, z);
      if (east !== 0) scatter(EAST, east, y, z);
      planes[(UP * SIDE + y) * SIDE + z] = here & ~notToward[r + PADDED]!;
      planes[(DOWN * SIDE + y) * SIDE + z] = here & ~notToward[r - PADDED]!;
      planes[(SOUTH * SIDE + z) * SIDE + y] = here & ~notToward[r + 1]!;
      planes[(NORTH * SIDE + z) * SIDE + y] = here & ~notToward[r - 1]!;
    }
  }
}

/** Occlusion of the four corners of a face, from the cell `at` in front of it and the steps `du` and `dv`: 8 bits. */
function occlusionAt(at: number, du: number, dv: number): number {
  const w = solid[at - du]!;
  const e = solid[at + du]!;
  const n = solid[at - dv]!;
  const s = solid[at + dv]!;
  const nw = solid[at - du - dv]!;
  const ne = solid[at + du - dv]!;
  const sw = solid[at - du + dv]!;
  const se = solid[at + du + dv]!;
  if ((w | e | n | s | nw | ne | sw | se) === 0) return 0xff;
  const a = w & n ? 0 : 3 - w - n - nw;
  const b = e & n ? 0 : 3 - e - n - ne;
  const c = e & s ? 0 : 3 - e - s - se;
  const d = w & s ? 0 : 3 - w - s - sw;
  return a | (b << 2) | (c << 4) | (d << 6);
}

const STEP_U = [DZ, DX, DX, DZ, DX, DX];
const STEP_V = [DY, DY, DZ, DY, DY, DZ];
const STEP_N = [-DX, -DZ, DY, DX, DZ, -DY];
const PLANE_STEP = [DX, DZ, DY, DX, DZ, DY];
const ORIGIN = paddedIndex(0, 0, 0);

const CUT_BIT = 1 << 26;

function isCut(face: number, plane: number, u: number, v: number): number {
  let bit: number;
  if (face === WEST || face === EAST) {
    const r = row(v, u);
    bit = face === WEST ? (plane === 0 ? openCutEnds[r]! & 1 : (openCut[r]! >>> (plane - 1)) & 1)
      : plane === 31 ? openCutEnds[r]! >>> 1 : (openCut[r]! >>> (plane + 1)) & 1;
  } else if (face === NORTH || face === SOUTH) {
    bit = (openCut[row(v, face === NORTH ? plane - 1 : plane + 1)]! >>> u) & 1;
  } else {
    return 0;
  }
  return bit === 0 ? 0 : CUT_BIT;
}

/** Covers the faces of one plane, bits along u in 32 rows of v from planes[rows], with as few quads as a greedy search
 *  finds, and clears their bits. */
function coverPlane(padded: Uint16Array, face: number, plane: number, options: MeshOptions, occlusion: boolean): void {
  const rows = (face * SIDE + plane) * SIDE;
  let any = 0;
  for (let v = 0; v < SIDE; v++) any |= planes[rows + v]!;
  if (any === 0) return;
  const du = STEP_U[face]!;
  const dv = STEP_V[face]!;
  const base = ORIGIN + plane * PLANE_STEP[face]!;
  const toFront = STEP_N[face]!;
  const places = options.places;
  const cuts = options.kept !== null;
  for (let v = 0; v < SIDE; v++) {
    for (let rest = planes[rows + v]!; rest !== 0; rest &= rest - 1) {
      const u = 31 - Math.clz32(rest & -rest);
      const at = base + u * du + v * dv;
      let key = (places[padded[at]!]! << 8) | (occlusion ? occlusionAt(at + toFront, du, dv) : 0xff);
      if (cuts) key |= isCut(face, plane, u, v);
      keys[v * SIDE + u] = key;
    }
  }
  for (let v = 0; v < SIDE; v++) {
    while (planes[rows + v] !== 0) {
      const bits = planes[rows + v]!;
      const u = 31 - Math.clz32(bits & -bits);
      const key = keys[v * SIDE + u]!;
      const a = key & 3;
      const b = (key >>> 2) & 3;
      const c = (key >>> 4) & 3;
      const d = (key >>> 6) & 3;
      // Quads merge only along axes without changes in occlusion.
      let width = 1;
      if (a === b && c === d) {
        while (u + width < SIDE && (bits >>> (u + width)) & 1 && keys[v * SIDE + u + width] === key) width++;
      }
      const mask = width === SIDE ? 0xffffffff : ((1 << width) - 1) << u;
      let height = 1;
      if (a === d && b === c) {
        while (v + height < SIDE && (planes[rows + v + height]! & mask) === (mask | 0)) {
          const next = (v + height) * SIDE + u;
          let i = 0;
          while (i < width && keys[next + i] === key) i++;
          if (i < width) break;
          height++;
        }
      }
      for (let i = 0; i < height; i++) planes[rows + v + i]! &= ~mask;
      emit(face, plane, u, v, width, height, key, options.slot, a + c < b + d ? 1 : 0);
    }
  }
}

function emit(face: number, plane: number, u: number, v: number, width: number, height: number, key: number, slot: number, flip: number): void {
  let x = u;
  let y = v;
  let z = plane;
  if (face === WEST || face === EAST) {
    x = plane;
    z = u;
  } else if (face === UP || face === DOWN) {
    y = plane;
    z = v;
  }
  if (used + 2 > out.length) {
    const bigger = new Uint32Array(out.length * 2);
    bigger.set(out);
    out = bigger;
  }
  const material = (key >>> 8) & 0x3ff;
  const cut = key & CUT_BIT ? 1 : 0;
  out[used++] = x | (y << 5) | (z << 10) | (face << 15) | ((width - 1) << 18) | ((height - 1) << 23) |
    (flip << 28) | (cut << 29) | ((material >>> 8) << 30);
  out[used++] = slot | ((key & 0xff) << 16) | ((material & 0xff) << 24);
  if (y < low) low = y;
  const top = face === UP || face === DOWN ? y : y + height - 1;
  if (top > high) high = top;
}

/** Faces at the chunk's side that the neighbour there hides, near open space: walls that close gaps to another level of
 *  detail beyond. */
function skirtPlane(face: number): void {
  const plane = face === EAST || face === SOUTH ? 31 : 0;
  const rows = (face * SIDE + plane) * SIDE;
  for (let v = 0; v < SIDE; v++) planes[rows + v] = 0;
  const step = STEP_N[face]!;
  for (let u = 0; u < SIDE; u++) {
    const column = ORIGIN + plane * PLANE_STEP[face]! + u * STEP_U[face]!;
    // Depth below the last open voxel, from above.
    let depth = solid[column + SIDE * DY] && solid[column + SIDE * DY + step] ? SKIRT_DEPTH - SKIRT_CAP : 0;
    for (let y = SIDE - 1; y >= 0; y--) {
      const at = column + y * DY;
      const outer = isBlocked(face, u, y);
      if (!solid[at] || !outer) {
        depth = 0;
      } else if (depth++ < SKIRT_DEPTH) {
        planes[rows + y]! |= 1 << u;
      }
    }
  }
}

function isBlocked(face: number, u: number, y: number): boolean {
  if (face === WEST || face === EAST) return (blockEnds[row(y, u)]! & (face === WEST ? 1 : 2)) !== 0;
  return ((blockRow[row(y, face === NORTH ? -1 : SIDE)]! >>> u) & 1) !== 0;
}

function topsOf(rows: Uint32Array): Uint8Array<ArrayBuffer> {
  const tops = new Uint8Array(SIDE * SIDE);
  for (let z = 0; z < SIDE; z++) {
    let left = 0xffffffff;
    for (let y = SIDE - 1; y >= 0 && left !== 0; y--) {
      for (let found = rows[row(y, z)]! & left; found !== 0; found &= found - 1) {
        tops[z * SIDE + 31 - Math.clz32(found & -found)] = y + 1;
      }
      left &= ~rows[row(y, z)]!;
    }
  }
  return tops;
}

/** May modify `padded`. */
export function meshChunk(padded: Uint16Array, options: MeshOptions): ChunkMesh {
  used = 0;
  low = SIDE;
  high = -1;
  const counts = new Uint32Array(GROUPS + 1);
  const { solids, liquids } = classify(padded, options.kinds, options.kept);
  let before = 0;
  if (solids) {
    if (options.grounded) ground(padded);
    facesOf(solidRow, blockRow, blockEnds);
    for (let face = 0; face < 6; face++) {
      for (let plane = 0; plane < SIDE; plane++) coverPlane(padded, face, plane, options, options.occlusion);
      counts[face] = (used - before) / 2;
      before = used;
    }
    SKIRTS.forEach((face, i) => {
      skirtPlane(face);
      coverPlane(padded, face, face === EAST || face === SOUTH ? 31 : 0, options, false);
      counts[6 + i] = (used - before) / 2;
      before = used;
    });
  }
  if (liquids) {
    for (let r = 0; r < ROWS; r++) {
      liquidBlock[r] = blockRow[r]! | liquidRow[r]!;
      liquidBlockEnds[r] = blockEnds[r]! | liquidEnds[r]!;
    }
    facesOf(liquidRow, liquidBlock, liquidBlockEnds);
    for (let face = 0; face < 6; face++) {
      for (let plane = 0; plane < SIDE; plane++) coverPlane(padded, face, plane, options, false);
    }
    counts[GROUPS] = (used - before) / 2;
  }
  return {
    quads: out.slice(0, used),
    counts,
    tops: topsOf(solidRow),
    liquidTops: liquids ? topsOf(liquidRow) : null,
    low,
    high,
  };
}

const liquidBlock = new Uint32Array(ROWS);
const liquidBlockEnds = new Uint8Array(ROWS);
