// Checks an application's edit and converts it to the form for the wire.
import { encodeChunk } from '../encode.js';
import { TalusError } from '../errors.js';
import type { Position } from '../types.js';
import type { WireEdit, WireFill } from '../wire/write_edit.js';
import type { Edit, Fill, VoxelWrite } from './types.js';

function wrong(what: string): TalusError {
  return new TalusError('out_of_range', `edit: ${what}`);
}

function voxel(at: Position, what: string): Position {
  const { x, y, z } = at;
  if ([x, y, z].every(Number.isSafeInteger)) return { x, y, z };
  throw wrong(`${what} (${x}, ${y}, ${z}) must be of whole numbers`);
}

function material(id: number, what: string): number {
  if (Number.isInteger(id) && id >= 0 && id <= 0xffff) return id;
  throw wrong(`material ${id} of ${what}; materials are 0 to 65535`);
}

function writes(list: readonly VoxelWrite[] = [], what: string): VoxelWrite[] {
  return list.map((each) => ({ voxel: voxel(each.voxel, what), material: material(each.material, what) }));
}

function fill({ first, last, material: to, only }: Fill): WireFill {
  const corners = { first: voxel(first, 'fill.first'), last: voxel(last, 'fill.last') };
  if (first.x > last.x || first.y > last.y || first.z > last.z) throw wrong('fill.first must be the lowest corner, fill.last the highest');
  return {
    ...corners,
    material: to === 'generated' ? 0 : material(to, 'a fill'),
    only: only === undefined ? 0 : material(only, 'fill.only'),
    flags: (only === undefined ? 1 : 0) | (to === 'generated' ? 2 : 0),
  };
}

/** Returns a copy. Throws a TalusError if the edit is invalid. */
export function checkedEdit(edit: Edit): WireEdit {
  const { paste } = edit;
  return {
    guards: writes(edit.guards, 'a guard'),
    writes: writes(edit.writes, 'a write'),
    fills: (edit.fills ?? []).map(fill),
    paste:
      paste === undefined
        ? null
        : {
            origin: voxel(paste.origin, 'paste.origin'),
            payload: encodeChunk(paste.voxels),
            withAir: paste.withAir ?? false,
          },
    subject: edit.subject ?? '',
  };
}
