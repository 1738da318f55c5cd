// A chunk and its apron as rows of 32 voxels along x, one bit each: the mesher's input.
import { PADDED, SIDE, UNKNOWN, paddedIndex } from './volume.js';

export const GAS = 0;
export const LIQUID = 1;
export const SOLID = 2;

/** Columns that a slice keeps: rows z = -1 to 32; bits x = 0 to 31 in `mask`, and x = -1 and x = 32. */
export interface KeptColumns {
  readonly mask: Uint32Array;
  readonly west: Uint8Array;
  readonly east: Uint8Array;
}

/** All voxels of a row. */
const ALL = 0xffffffff;
export const ROWS = PADDED * PADDED;
export const row = (y: number, z: number) => (y + 1) * PADDED + z + 1;

/** Steps of the padded index along x, z and y. */
export const DX = 1;
export const DZ = PADDED;
export const DY = PADDED * PADDED;

// Buffers reused by every call: a mesher belongs to one thread.
export const solidRow = new Uint32Array(ROWS); // solid voxels x = 0 to 31
const solidEnds = new Uint8Array(ROWS); // bit 0: x = -1 is solid, bit 1: x = 32
export const blockRow = new Uint32Array(ROWS); // the same with unknown voxels: no faces are drawn towards them
export const blockEnds = new Uint8Array(ROWS);
export const liquidRow = new Uint32Array(ROWS);
export const liquidEnds = new Uint8Array(ROWS);
export const openCut = new Uint32Array(ROWS); // voxels removed by a slice
export const openCutEnds = new Uint8Array(ROWS);
export const solid = new Uint8Array(PADDED * PADDED * PADDED);

// Masks that contain a material.
const IS_SOLID = 1;
const IS_BLOCK = 2;
const IS_LIQUID = 4;
const bitsOfKind = Uint8Array.of(0, IS_LIQUID, IS_SOLID | IS_BLOCK);
const bitsOfMaterial = new Uint8Array(UNKNOWN + 1);
let kindsInBits: Uint8Array | null = null;

function knowKinds(kinds: Uint8Array): void {
  if (kinds === kindsInBits) return;
  kindsInBits = kinds;
  bitsOfMaterial.fill(bitsOfKind[SOLID]!);
  kinds.forEach((kind, material) => (bitsOfMaterial[material] = bitsOfKind[kind]!));
  bitsOfMaterial[UNKNOWN] = IS_BLOCK;
}

/** Fills the rows above from the chunk. */
export function classify(padded: Uint16Array, kinds: Uint8Array, kept: KeptColumns | null): { solids: boolean; liquids: boolean } {
  knowKinds(kinds);
  const pairs = new Uint32Array(padded.buffer, padded.byteOffset, padded.length / 2);
  let anySolid = 0;
  let anyLiquid = 0;
  for (let y = -1; y <= SIDE; y++) {
    for (let z = -1; z <= SIDE; z++) {
      const r = row(y, z);
      const at = paddedIndex(-1, y, z);
      const first = padded[at]!;
      const pair = pairs[at / 2]!;
      let same = pair >>> 16 === first;
      for (let i = at / 2 + 1; same && i < at / 2 + PADDED / 2; i++) same = pairs[i] === pair;
      let s = 0;
      let b = 0;
      let l = 0;
      let sEnds = 0;
      let bEnds = 0;
      let lEnds = 0;
      if (same) {
        const bits = bitsOfMaterial[first]!;
        solid.fill(bits & IS_SOLID, at, at + PADDED);
        if (bits & IS_SOLID) [s, sEnds] = [ALL, 3];
        if (bits & IS_BLOCK) [b, bEnds] = [ALL, 3];
        if (bits & IS_LIQUID) [l, lEnds] = [ALL, 3];
      } else {
        for (let x = 0; x < SIDE; x++) {
          const bits = bitsOfMaterial[padded[at + 1 + x]!]!;
          solid[at + 1 + x] = bits & IS_SOLID;
          s |= (bits & IS_SOLID) << x;
          b |= ((bits & IS_BLOCK) >> 1) << x;
          l |= (bits >> 2) << x;
        }
        const west = bitsOfMaterial[first]!;
        const east = bitsOfMaterial[padded[at + PADDED - 1]!]!;
        solid[at] = west & IS_SOLID;
        solid[at + PADDED - 1] = east & IS_SOLID;
        sEnds = (west & IS_SOLID) | ((east & IS_SOLID) << 1);
        bEnds = ((west & IS_BLOCK) >> 1) | (east & IS_BLOCK);
        lEnds = (west >> 2) | ((east >> 2) << 1);
      }
      if (kept !== null) {
        const keep = kept.mask[z + 1]!;
        const ends = kept.west[z + 1]! | (kept.east[z + 1]! << 1);
        if (keep !== ALL || ends !== 3) {
          openCut[r] = s & ~keep;
          openCutEnds[r] = sEnds & ~ends;
          s &= keep;
          l &= keep;
          b &= keep;
          sEnds &= ends;
          lEnds &= ends;
          bEnds &= ends;
          for (let i = 0; i < SIDE; i++) if (((keep >>> i) & 1) === 0) solid[at + 1 + i] = 0;
          if ((ends & 1) === 0) solid[at] = 0;
          if ((ends & 2) === 0) solid[at + PADDED - 1] = 0;
        } else {
          openCut[r] = 0;
          openCutEnds[r] = 0;
        }
      }
      solidRow[r] = s;
      solidEnds[r] = sEnds;
      blockRow[r] = b;
      blockEnds[r] = bEnds;
      liquidRow[r] = l;
      liquidEnds[r] = lEnds;
      if (y >= 0 && y < SIDE && z >= 0 && z < SIDE) {
        anySolid |= s;
        anyLiquid |= l;
      }
    }
  }
  return { solids: anySolid !== 0, liquids: anyLiquid !== 0 };
}

/** Puts a voxel of the same material below each single one with exactly one free voxel between it and solid ground. */
export function ground(padded: Uint16Array): void {
  for (let y = 1; y < SIDE; y++) {
    for (let z = 0; z < SIDE; z++) {
      const r = row(y, z);
      const under = r - PADDED;
      const beside = westOf(solidRow, solidEnds, r) | eastOf(solidRow, solidEnds, r) | solidRow[r - 1]! | solidRow[r + 1]!;
      const floats = solidRow[r]! & ~(beside | solidRow[r + PADDED]! | blockRow[under]! | liquidRow[under]!);
      const stands = floats & solidRow[under - PADDED]!;
      solidRow[under]! |= stands;
      blockRow[under]! |= stands;
      for (let rest = stands; rest !== 0; rest &= rest - 1) {
        const at = paddedIndex(31 - Math.clz32(rest & -rest), y, z);
        padded[at - DY] = padded[at]!;
        solid[at - DY] = 1;
      }
    }
  }
}

/** Shifts voxels by one to the west, so that bit x is the voxel at x - 1. */
export const westOf = (rows: Uint32Array, ends: Uint8Array, r: number) => (rows[r]! << 1) | (ends[r]! & 1);
export const eastOf = (rows: Uint32Array, ends: Uint8Array, r: number) => (rows[r]! >>> 1) | ((ends[r]! & 2) << 30);
