// Chunks of one View that another lacks, as boxes, computed from the shapes' edges, so that the cost of moving a View
// by a chunk depends on the chunks that enter and leave.
import type { ChunkKey } from './types.js';
import { type LevelBox, type Range, sizeOf, type ViewShape } from './view_shape.js';

/** Both ends included; never empty. */
export interface ChunkBox {
  readonly lod: number;
  readonly x: Range;
  readonly y: Range;
  readonly z: Range;
}

interface Rectangle {
  readonly x: Range;
  readonly z: Range;
}

const isEmpty = (range: Range) => range.last < range.first;

function overlap(a: Range, b: Range): Range {
  return { first: Math.max(a.first, b.first), last: Math.min(a.last, b.last) };
}

/** The parts of `a` before and after `b`. */
function minus(a: Range, b: Range): Range[] {
  if (isEmpty(overlap(a, b))) return isEmpty(a) ? [] : [a];
  const parts = [
    { first: a.first, last: b.first - 1 },
    { first: b.last + 1, last: a.last },
  ];
  return parts.filter((part) => !isEmpty(part));
}

function common(a: Rectangle, b: Rectangle): Rectangle[] {
  const both = { x: overlap(a.x, b.x), z: overlap(a.z, b.z) };
  return isEmpty(both.x) || isEmpty(both.z) ? [] : [both];
}

/** `a` without `b`, in at most four rectangles. */
function without(a: Rectangle, b: Rectangle): Rectangle[] {
  const [both] = common(a, b);
  if (both === undefined) return isEmpty(a.x) || isEmpty(a.z) ? [] : [a];
  return [...minus(a.z, both.z).map((z) => ({ x: a.x, z })), ...minus(a.x, both.x).map((x) => ({ x, z: both.z }))];
}

const innerOf = (box: LevelBox): Rectangle => ({ x: box.innerX, z: box.innerZ });

/** The columns of a level. */
const columnsOf = (box: LevelBox): Rectangle[] => without(box, innerOf(box));

/** Columns of `a` that `b` lacks: outside its outer rectangle, or in its inner one. */
function columnsLeft(a: LevelBox, b: LevelBox): Rectangle[] {
  const outside = without(a, b);
  const inside = common(a, b).flatMap((both) => common(both, innerOf(b)));
  return [...outside, ...inside].flatMap((part) => without(part, innerOf(a)));
}

function columnsKept(a: LevelBox, b: LevelBox): Rectangle[] {
  return columnsOf(a).flatMap((part) => columnsOf(b).flatMap((other) => common(part, other)));
}

/** The chunks of `from` that `other` lacks; null means no chunks. Boxes do not overlap. */
export function chunksOutside(from: ViewShape, other: ViewShape | null): ChunkBox[] {
  const outside: ChunkBox[] = [];
  for (const box of from.boxes) {
    const { lod, y } = box;
    if (isEmpty(y)) continue;
    const against = other?.boxes.find((level) => level.lod === lod);
    const add = (columns: Rectangle[], rows: Range) => {
      for (const { x, z } of columns) outside.push({ lod, x, y: rows, z });
    };
    if (against === undefined) {
      add(columnsOf(box), y);
      continue;
    }
    add(columnsLeft(box, against), y);
    for (const rows of minus(y, against.y)) add(columnsKept(box, against), rows);
  }
  return outside;
}

export function countOf(boxes: readonly ChunkBox[]): number {
  return boxes.reduce((sum, { x, y, z }) => sum + sizeOf(x) * sizeOf(y) * sizeOf(z), 0);
}

export function forEachChunk(boxes: readonly ChunkBox[], visit: (key: ChunkKey) => void): void {
  for (const { lod, x, y, z } of boxes) {
    for (let atZ = z.first; atZ <= z.last; ++atZ) {
      for (let atX = x.first; atX <= x.last; ++atX) {
        for (let atY = y.first; atY <= y.last; ++atY) visit({ lod, x: atX, y: atY, z: atZ });
      }
    }
  }
}
