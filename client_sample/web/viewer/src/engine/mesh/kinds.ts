// Properties of a world's materials for the meshers and the page.
import type { Material } from 'talus';
import type { Kind } from '../stream/column.js';
import { GAS, LIQUID, SOLID } from './mesher.js';

export interface MaterialTables {
  /** By id. */
  readonly kinds: Uint8Array;
  /** By id: index in the world's list, by which quads refer to materials. */
  readonly places: Uint16Array;
}

export function tablesOf(materials: readonly Material[]): MaterialTables {
  const highest = materials.reduce((most, m) => Math.max(most, m.id), 0);
  const kinds = new Uint8Array(highest + 1).fill(SOLID);
  const places = new Uint16Array(65536);
  materials.forEach((material, place) => {
    kinds[material.id] = material.phase === 'gas' ? GAS : material.phase === 'liquid' ? LIQUID : SOLID;
    places[material.id] = place;
  });
  return { kinds, places };
}

export function kindIn(kinds: Uint8Array, material: number): Kind {
  const kind = kinds[material] ?? SOLID;
  return kind === GAS ? 'gas' : kind === LIQUID ? 'liquid' : 'solid';
}
