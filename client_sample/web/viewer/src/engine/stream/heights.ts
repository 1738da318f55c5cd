// Heights of a column of chunks, from its meshes.
import { NO_HEIGHT, type Column, type Drawable, type Kind } from './column.js';
import type { LevelShape } from './shape.js';

/** Recomputes them, and whether everything visible from above is meshed: from the top down to where no column is open.
 *  Returns true if there are any. */
export function refreshHeights<D extends Drawable>(column: Column<D>, level: LevelShape, kindOf: (material: number) => Kind): boolean {
  let heights: Int16Array | null = null;
  let liquids: Int16Array | null = null;
  let open = 1024;
  let ready = true;
  for (let y = level.y1; y >= level.y0 && open > 0; y--) {
    const chunk = column.chunks.get(y);
    if (chunk === undefined || chunk.meshedWith < 0) {
      ready = false;
      continue;
    }
    const kind = chunk.material === null ? null : kindOf(chunk.material);
    if (kind === 'gas' || (kind === null && chunk.tops === null)) continue;
    heights ??= new Int16Array(1024).fill(NO_HEIGHT);
    if (kind === 'liquid' || chunk.liquidTops !== null) {
      liquids ??= new Int16Array(1024).fill(NO_HEIGHT);
      for (let i = 0; i < 1024; i++) {
        const top = kind === 'liquid' ? 32 : chunk.liquidTops![i]!;
        if (top > 0 && heights[i] === NO_HEIGHT && liquids[i] === NO_HEIGHT) liquids[i] = y * 32 + top;
      }
    }
    if (kind === 'liquid') continue;
    for (let i = 0; i < 1024; i++) {
      if (heights[i] !== NO_HEIGHT) continue;
      const top = kind === 'solid' ? 32 : chunk.tops![i]!;
      if (top === 0) continue;
      heights[i] = y * 32 + top;
      open--;
    }
  }
  column.ready = ready;
  if (heights === null && liquids === null) return false;
  column.heights = heights;
  column.liquids = liquids;
  let lowest = 32767;
  if (heights !== null) for (let i = 0; i < 1024; i++) if (heights[i]! < lowest) lowest = heights[i]!;
  column.lowest = heights === null ? NO_HEIGHT : lowest;
  return true;
}
