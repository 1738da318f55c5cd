// An edit as the module takes it: without a paste, which becomes fills of its rows.
import type { World as Module } from '../../wasm/world.js';
import type { Edit, Fill, Paste } from '../edits/types.js';

type ModuleEdit = Parameters<Module['edit']>[0];

export function asModuleEdit({ guards = [], writes = [], fills = [], paste }: Edit): ModuleEdit {
  return { guards, writes, fills: paste === undefined ? fills : [...fills, ...fillsOf(paste)] };
}

function fillsOf({ origin, voxels: { uniform, voxels }, withAir = false }: Paste): Fill[] {
  const { x, y, z } = origin;
  if (uniform !== null) {
    return uniform === 0 && !withAir ? [] : [{ first: origin, last: { x: x + 31, y: y + 31, z: z + 31 }, material: uniform }];
  }
  const fills: Fill[] = [];
  for (let row = 0; row < voxels.length; row += 32) {
    const at = { y: y + (row >> 10), z: z + ((row >> 5) & 31) };
    for (let from = 0; from < 32; ) {
      const material = voxels[row + from]!;
      let end = from + 1;
      while (end < 32 && voxels[row + end] === material) ++end;
      if (material !== 0 || withAir) fills.push({ first: { x: x + from, ...at }, last: { x: x + end - 1, ...at }, material });
      from = end;
    }
  }
  return fills;
}
