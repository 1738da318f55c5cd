// The chunks of a View that are made here: nearest first, each once, those of one patch together.
import type { WorldError } from '../../wasm/world.js';
import type { ChunkKey, View } from '../types.js';
import type { Range, ViewShape } from '../view_shape.js';
import { contains, sizeOf } from '../view_shape.js';
import type { Job, Supplier } from './crew.js';
import type { MadeColumns } from './messages.js';
import { patchOf, type World } from './world.js';

/** A chunk as made: `payload` is null if all its voxels are `material`. */
export interface Made {
  readonly key: ChunkKey;
  readonly payload: Uint8Array<ArrayBuffer> | null;
  readonly material: number | null;
}

export interface Taker {
  /** `edits`: World.edits when it was asked for. */
  made(chunk: Made, edits: number): void;
  /** All chunks of the View are made, or failed. */
  whole(): void;
  failed(error: WorldError): void;
  /** The application has enough to do for now; call Making.goOn() then. */
  isFull?(): boolean;
}

interface Column {
  readonly x: number;
  readonly z: number;
  readonly rows: Range;
}

interface Patch {
  readonly lod: number;
  readonly place: string;
  readonly columns: Column[];
  distance: number;
  failures: number;
}

/** Straight ahead counts as this much nearer. */
const AHEAD = 0.4;
const MAX_FAILURES = 3;

export class Making implements Supplier {
  private shape: ViewShape | null = null;
  private patches: Patch[] = [];
  private next_ = 0;
  /** Rows of columns that were made, or are being made. */
  private readonly asked = new Map<string, Range>();
  private underway = 0;
  private isTold = true;
  private lostBy: WorldError | null = null;
  private readonly supply: { again(): void; end(): void };

  constructor(
    private readonly world: World,
    private readonly taker: Taker,
  ) {
    this.supply = world.supply(this);
  }

  /** Replaces the View; null: nothing is wanted. What is being made still comes. */
  want(view: View | null, shape: ViewShape | null): void {
    this.shape = shape;
    this.patches = [];
    this.next_ = 0;
    this.isTold = view === null;
    if (view === null || shape === null) {
      this.asked.clear();
      return;
    }
    if (this.lostBy !== null) return this.taker.failed(this.lostBy);
    for (const [name, rows] of this.asked) {
      const [lod, x, z] = name.split('/').map(Number) as [number, number, number];
      const wanted = shape.rows(lod, x, z);
      const first = Math.max(rows.first, wanted.first);
      const last = Math.min(rows.last, wanted.last);
      if (last < first) this.asked.delete(name);
      else if (first !== rows.first || last !== rows.last) this.asked.set(name, { first, last });
    }
    const patches = new Map<string, Patch>();
    shape.forEachColumn((lod, x, z, rows) => {
      for (const range of missing(rows, this.asked.get(`${lod}/${x}/${z}`))) {
        const place = patchOf({ lod, x, z });
        let patch = patches.get(place);
        if (patch === undefined) patches.set(place, (patch = { lod, place, columns: [], distance: Infinity, failures: 0 }));
        patch.columns.push({ x, z, rows: range });
        patch.distance = Math.min(patch.distance, distanceTo(view, lod, x, z));
      }
    });
    this.patches = [...patches.values()].sort((a, b) => a.distance - b.distance);
    this.supply.again();
    this.tell();
  }

  /** The application has all of this View. */
  has(shape: ViewShape): void {
    this.shape = shape;
    this.isTold = true;
    shape.forEachColumn((lod, x, z, rows) => this.asked.set(`${lod}/${x}/${z}`, rows));
  }

  /** The next View makes this chunk's column again. */
  forget({ lod, x, z }: ChunkKey): void {
    this.asked.delete(`${lod}/${x}/${z}`);
  }

  end(): void {
    this.supply.end();
    this.patches = [];
    this.next_ = 0;
    this.isTold = true;
    this.shape = null;
  }

  goOn(): void {
    this.supply.again();
  }

  next(): Job | null {
    const patch = this.patches[this.next_];
    if (patch === undefined || this.taker.isFull?.()) return null;
    ++this.next_;
    ++this.underway;
    const { lod, columns, place } = patch;
    for (const { x, z, rows } of columns) this.ask(`${lod}/${x}/${z}`, rows);
    const { edits } = this.world;
    const packed = Int32Array.from(columns.flatMap(({ x, z, rows }) => [x, z, rows.first, rows.last]));
    return {
      name: 'columns',
      args: [{ lod, columns: packed }],
      place,
      done: (result: MadeColumns) => this.done(patch, result, edits),
      failed: (error: WorldError) => this.failed(patch, error),
    } as unknown as Job;
  }

  private ask(name: string, rows: Range): void {
    const before = this.asked.get(name);
    this.asked.set(name, before === undefined ? rows : { first: Math.min(before.first, rows.first), last: Math.max(before.last, rows.last) });
  }

  private done({ lod, columns }: Patch, { what, payloads }: MadeColumns, edits: number): void {
    --this.underway;
    let i = 0;
    let at = 0;
    for (const { x, z, rows } of columns) {
      for (let y = rows.first; y <= rows.last; ++y) {
        const is = what[i++]!;
        const payload = is < 0 ? payloads.slice(at, at - is) : null;
        if (payload !== null) at += payload.length;
        const key = { lod, x, y, z };
        if (this.shape?.covers(key)) this.taker.made({ key, payload, material: is < 0 ? null : is }, edits);
      }
    }
    this.tell();
  }

  lost(error: WorldError): void {
    this.lostBy = error;
    this.patches = [];
    this.isTold = true;
    this.taker.failed(error);
  }

  /** A worker that ended is replaced, so its work is done again. */
  private failed(patch: Patch, error: WorldError): void {
    --this.underway;
    for (const { x, z } of patch.columns) this.asked.delete(`${patch.lod}/${x}/${z}`);
    if (this.lostBy !== null) return;
    if (++patch.failures < MAX_FAILURES) {
      this.patches.push(patch);
      this.supply.again();
      return;
    }
    this.taker.failed(error);
    this.tell();
  }

  private tell(): void {
    if (this.isTold || this.underway > 0 || this.next_ < this.patches.length) return;
    this.isTold = true;
    this.taker.whole();
  }
}

function missing(rows: Range, asked: Range | undefined): Range[] {
  if (asked === undefined) return [rows];
  const below = { first: rows.first, last: asked.first - 1 };
  const above = { first: asked.last + 1, last: rows.last };
  return [below, above].filter((range) => sizeOf(range) > 0 && contains(rows, range.first));
}

/** Horizontal, in base voxels. */
function distanceTo({ centre, direction }: View, lod: number, x: number, z: number): number {
  const size = 32 * 2 ** lod;
  const dx = (x + 0.5) * size - centre.x;
  const dz = (z + 0.5) * size - centre.z;
  const distance = Math.max(0, Math.hypot(dx, dz) - size / 2);
  const length = direction === undefined ? 0 : Math.hypot(direction.x, direction.z) * Math.hypot(dx, dz);
  return length > 0 ? distance * (1 - (AHEAD * (direction!.x * dx + direction!.z * dz)) / length) : distance;
}
