// Computes the chunks of a View: PROTOCOL.md, "Which chunks". Coordinates may exceed 32 bits before the world's edge
// cuts them, so levels are divided, not shifted.
import { TalusError } from './errors.js';
import type { ChunkKey, Limits, LodRing, View } from './types.js';

export const MAX_LOD = 6;

/** Both ends included; empty if last < first. */
export interface Range {
  readonly first: number;
  readonly last: number;
}
const EMPTY: Range = { first: 0, last: -1 };

export interface Heights {
  readonly minY: number;
  readonly maxY: number;
}

/** The chunks of one level: the outer box without the columns of the inner one. */
export interface LevelBox {
  readonly lod: number;
  readonly x: Range;
  readonly y: Range;
  readonly z: Range;
  readonly innerX: Range;
  readonly innerZ: Range;
}

export function sizeOf(range: Range): number {
  return Math.max(0, range.last - range.first + 1);
}

export function contains(range: Range, at: number): boolean {
  return range.first <= at && at <= range.last;
}

function overlap(a: Range, b: Range): Range {
  return { first: Math.max(a.first, b.first), last: Math.min(a.last, b.last) };
}

function touching(centre: number, radius: number, size: number): Range {
  return { first: Math.floor((centre - radius) / size), last: Math.floor((centre + radius) / size) };
}

/** Chunks of `size` base chunks entirely inside chunks of `finerSize`. */
function whollyInside(finer: Range, finerSize: number, size: number): Range {
  return {
    first: Math.ceil((finer.first * finerSize) / size) + 0, // not -0
    last: Math.floor(((finer.last + 1) * finerSize) / size) - 1,
  };
}

function rowsOfWorld(heights: Heights, size: number): Range {
  const edge = 2 ** 36;
  const clamp = (row: number) => Math.max(-edge, Math.min(edge, row));
  return {
    first: Math.floor((Math.floor(clamp(heights.minY) / size) - 1) / 32),
    last: Math.floor(Math.floor((clamp(heights.maxY) - 1) / size) / 32),
  };
}

function cutToWorld(box: LevelBox): LevelBox {
  const limit = 2 ** (31 - box.lod);
  const world = { first: -limit, last: limit - 1 };
  return {
    lod: box.lod,
    x: overlap(box.x, world),
    y: overlap(box.y, world),
    z: overlap(box.z, world),
    innerX: overlap(box.innerX, world),
    innerZ: overlap(box.innerZ, world),
  };
}

function countOf(box: LevelBox): number {
  const inner = sizeOf(overlap(box.x, box.innerX)) * sizeOf(overlap(box.z, box.innerZ));
  return (sizeOf(box.x) * sizeOf(box.z) - inner) * sizeOf(box.y);
}

/** Level 0, then each ring, before the world's edge cuts them. */
function levelBoxes(view: View, heights: Heights): LevelBox[] {
  const x = Math.floor(view.centre.x / 32);
  const y = Math.floor(view.centre.y / 32);
  const z = Math.floor(view.centre.z / 32);
  const outer = (lod: number, radius: number): LevelBox => ({
    lod,
    x: touching(x, radius, 2 ** lod),
    y: touching(y, view.verticalRadius, 2 ** lod),
    z: touching(z, radius, 2 ** lod),
    innerX: EMPTY,
    innerZ: EMPTY,
  });
  const boxes = [outer(0, view.horizontalRadius)];
  for (const ring of view.rings ?? []) {
    const finer = boxes[boxes.length - 1]!;
    const box = outer(ring.lod, ring.radius);
    const hasInner = !view.horizon || boxes.length > 1; // level 0 does not contain all rows of its columns
    boxes.push({
      ...box,
      y: view.horizon ? rowsOfWorld(heights, 2 ** ring.lod) : box.y,
      innerX: hasInner ? whollyInside(finer.x, 2 ** finer.lod, 2 ** ring.lod) : EMPTY,
      innerZ: hasInner ? whollyInside(finer.z, 2 ** finer.lod, 2 ** ring.lod) : EMPTY,
    });
  }
  return boxes;
}

/** Exactly the chunks that a server sends for a View. */
export class ViewShape {
  readonly boxes: readonly LevelBox[];
  readonly count: number;
  /** count if the world's edge cut off nothing: the number that limits.viewChunks bounds. */
  readonly uncutCount: number;
  private readonly byLod: (LevelBox | undefined)[] = [];

  /** `heights`: the world's; needed only for a View with a horizon. */
  constructor(view: View, heights: Heights = { minY: 0, maxY: 0 }) {
    const uncut = levelBoxes(view, heights);
    this.boxes = uncut.map(cutToWorld);
    this.count = this.boxes.reduce((sum, box) => sum + countOf(box), 0);
    this.uncutCount = uncut.reduce((sum, box) => sum + countOf(box), 0);
    for (const box of this.boxes) this.byLod[box.lod] = box;
  }

  hasColumn(lod: number, x: number, z: number): boolean {
    const box = this.byLod[lod];
    return box !== undefined && boxHasColumn(box, x, z);
  }

  covers(key: ChunkKey): boolean {
    const box = this.byLod[key.lod];
    return box !== undefined && contains(box.y, key.y) && boxHasColumn(box, key.x, key.z);
  }

  /** Rows of a column; empty if the View does not contain it. */
  rows(lod: number, x: number, z: number): Range {
    return this.hasColumn(lod, x, z) ? this.byLod[lod]!.y : EMPTY;
  }

  /** Visits every column, finest level first. */
  forEachColumn(visit: (lod: number, x: number, z: number, rows: Range) => void): void {
    for (const box of this.boxes) {
      if (sizeOf(box.y) === 0) continue;
      for (let z = box.z.first; z <= box.z.last; ++z) {
        for (let x = box.x.first; x <= box.x.last; ++x) {
          if (boxHasColumn(box, x, z)) visit(box.lod, x, z, box.y);
        }
      }
    }
  }

  forEach(visit: (key: ChunkKey) => void): void {
    this.forEachColumn((lod, x, z, rows) => {
      for (let y = rows.first; y <= rows.last; ++y) visit({ lod, x, y, z });
    });
  }
}

function boxHasColumn(box: LevelBox, x: number, z: number): boolean {
  return contains(box.x, x) && contains(box.z, z) && !(contains(box.innerX, x) && contains(box.innerZ, z));
}

/** Rings of levels 1 to 6 from `radius` out to `farthest` base chunks, each wider by the same ratio; fewer if rounding
 *  would make two radii equal. */
export function ringsBetween(radius: number, farthest: number): LodRing[] {
  const begin = Math.max(1, radius);
  const rings: LodRing[] = [];
  let before = radius;
  for (let lod = 1; lod <= MAX_LOD; ++lod) {
    const out = Math.round(begin * (farthest / begin) ** (lod / MAX_LOD));
    if (out <= before) continue;
    rings.push({ lod, radius: out });
    before = out;
  }
  return rings;
}

function refuse(what: string): never {
  throw new TalusError('out_of_range', what);
}

/** Rounds the View to whole numbers; throws a TalusError if a server would reject it. */
export function checkedView(view: View): View {
  for (const axis of ['x', 'y', 'z'] as const) {
    if (!Number.isFinite(view.centre[axis])) {
      refuse(`the View's centre has ${axis} = ${view.centre[axis]}; it must be a finite number`);
    }
  }
  const radius = (value: number, name: string) => {
    if (!Number.isInteger(value) || value < 0 || value > 65_535) {
      refuse(`the View's ${name} is ${value}; it must be a whole number from 0 to 65535`);
    }
  };
  radius(view.horizontalRadius, 'horizontalRadius');
  radius(view.verticalRadius, 'verticalRadius');
  let lod = 0;
  let before = view.horizontalRadius;
  for (const ring of view.rings ?? []) {
    radius(ring.radius, `radius of level ${ring.lod}`);
    if (!Number.isInteger(ring.lod) || ring.lod <= lod || ring.lod > MAX_LOD || ring.radius <= before) {
      refuse(`the View's ring of level ${ring.lod} and radius ${ring.radius} does not grow from level ${lod}, ${before}`);
    }
    lod = ring.lod;
    before = ring.radius;
  }
  // Worlds end at 2^36: there are no chunks where numbers are inexact.
  const whole = (at: number) => Math.max(-(2 ** 52), Math.min(2 ** 52, Math.floor(at)));
  return {
    centre: { x: whole(view.centre.x), y: whole(view.centre.y), z: whole(view.centre.z) },
    ...(view.direction === undefined ? {} : { direction: { ...view.direction } }),
    horizontalRadius: view.horizontalRadius,
    verticalRadius: view.verticalRadius,
    rings: (view.rings ?? []).map((ring) => ({ lod: ring.lod, radius: ring.radius })),
    horizon: view.horizon === true,
  };
}

/** Throws a TalusError if the View exceeds the server's limits. */
export function checkLimits(view: View, shape: ViewShape, limits: Limits): void {
  const within = (value: number, max: number, name: string) => {
    if (value > max) refuse(`the View's ${name} is ${value}; this server allows ${max}`);
  };
  within(view.horizontalRadius, limits.viewHorizontalRadius, 'horizontalRadius');
  within(view.verticalRadius, limits.viewVerticalRadius, 'verticalRadius');
  for (const ring of view.rings ?? []) {
    within(ring.radius, limits.viewHorizontalRadius * 2 ** ring.lod, `radius of level ${ring.lod}`);
  }
  within(shape.uncutCount, limits.viewChunks, 'number of chunks');
  if (view.horizon && !limits.viewHorizon) refuse('the View has a horizon, which this server does not know');
}
