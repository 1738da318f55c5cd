// The land that the View asks for: which chunks are here, which are to be meshed and when, and what is drawn.
//
// A chunk is meshed once all its neighbours in the View are here, so that no seam shows, and again when a neighbour
// comes that the View had not before. Chunks that left stay drawn until what replaces them is there (cover.ts).
import type { ChunkMesh } from '../mesh/mesher.js';
import { coverOf, nearestMissing } from './cover.js';
import { ALL_AROUND } from '../edit/touched.js';
import { columnKey } from './keys.js';
import type { Job, SlicePlane } from './messages.js';
import { hasColumn, type Shape } from './shape.js';
import { sideOf } from './slice.js';

/** A mesh on the GPU. */
export interface Drawable {
  readonly slot: number;
}

/** Where meshes go. */
export interface Drawer<D extends Drawable> {
  takeSlot(lod: number, x: number, y: number, z: number): number;
  freeSlot(slot: number): void;
  add(slot: number, mesh: ChunkMesh): D;
  remove(drawable: D): void;
}

/** The workers; `drop` follows every chunk that was sent. */
export interface Meshers {
  send(chunk: Chunk): void;
  drop(chunk: Chunk): void;
  /** Whether one more job finds a place; few are under way at once, so that what left is never worked on for long. */
  hasRoom(chunk: Chunk): boolean;
  mesh(chunk: Chunk, job: Job): void;
}

export type Kind = 'gas' | 'liquid' | 'solid';


export class Chunk<D extends Drawable = Drawable> {
  payload: Uint8Array | null = null;
  /** Of a chunk of one material. */
  material: number | null = null;
  arrived = 0;
  /** Neighbours that are held, as bits (Job.known). */
  known = 0;
  /** What the mesh was made with; -1: not meshed yet. */
  meshedWith = -1;
  meshedSlice: SlicePlane | null = null;
  changed = false;
  /** Something in it was edited: it goes before all that is not. */
  hurried = false;
  job: { id: number; known: number; slice: SlicePlane | null; slot: number } | null = null;
  queued = false;
  left = false;
  drawable: D | null = null;
  tops: Uint8Array | null = null;
  liquidTops: Uint8Array | null = null;

  constructor(
    readonly column: Column<D>,
    readonly y: number,
  ) {}

  get lod(): number {
    return this.column.lod;
  }
  get x(): number {
    return this.column.x;
  }
  get z(): number {
    return this.column.z;
  }
}

export class Column<D extends Drawable = Drawable> {
  readonly chunks = new Map<number, Chunk<D>>();
  /** Of the View: bit (dz + 1) * 3 + dx + 1 for the columns around. */
  around = 0;
  wanted = false;
  drawn = false;
  ready = false;
  begun = false;
  stale = true;
  /** Voxel rows of the level, of the highest solid voxel + 1 and of liquid; a great negative number: none. */
  heights: Int16Array | null = null;
  liquids: Int16Array | null = null;
  lowest = -32768;
  /** Of its chunks. */
  drawables: D[] = [];
  left = 0;
  /** Whether a slice cut it when that was last looked at. */
  cut = false;
  /** Sides (mesh/quad.ts, SKIRTS) beyond which another level is drawn, as bits. */
  skirts = 0;

  constructor(
    readonly lod: number,
    readonly x: number,
    readonly z: number,
  ) {}
}

export const NO_HEIGHT = -32768;

export interface LandOptions<D extends Drawable> {
  readonly drawer: Drawer<D>;
  readonly meshers: Meshers;
  kindOf(material: number): Kind;
  now(): number;
  /** The heights of a column that has none or others than before. */
  heights(column: Column<D>): void;
  arrivedToDrawn(ms: number): void;
}

export class Land<D extends Drawable> {
  shape: Shape = [];
  slice: SlicePlane | null = null;
  private readonly columns = new Map<number, Column<D>>();
  private readonly jobs = new Map<number, Chunk<D>>();
  private queue: Chunk<D>[] = [];
  private queueSorted = false;
  private sortedAt = -Infinity;
  private nextJob = 1;
  private coverStale = true;
  private coveredAt = -Infinity;
  private cover = new Set<Column<D>>();
  /** Grows whenever what is drawn may have changed. */
  version = 0;
  private camera = { x: 0, y: 0, z: 0 };
  held = 0;
  payloadBytes = 0;
  readonly heldPerLevel = [0, 0, 0, 0, 0, 0, 0];

  constructor(private readonly options: LandOptions<D>) {}

  get(lod: number, x: number, z: number): Column<D> | undefined {
    return this.columns.get(columnKey(lod, x, z));
  }

  values(): Iterable<Column<D>> {
    return this.columns.values();
  }

  /** Whether all of the View that is here is meshed and drawn as it is to be. */
  get settled(): boolean {
    return this.queue.length === 0 && this.jobs.size === 0 && !this.coverStale;
  }

  get waiting(): number {
    return this.queue.length + this.jobs.size;
  }

  /** Columns to draw: no two overlap. */
  get drawn(): ReadonlySet<Column<D>> {
    return this.cover;
  }

  nearestMissing(x: number, z: number): number | null {
    return nearestMissing(this.shape, this, x, z);
  }

  setShape(shape: Shape): void {
    const rows = shape.map((level, lod) => level?.y0 !== this.shape[lod]?.y0 || level?.y1 !== this.shape[lod]?.y1);
    this.shape = shape;
    for (const column of this.columns.values()) {
      const before = column.around;
      this.placeInShape(column);
      if (before === column.around && !rows[column.lod]) continue;
      const level = shape[column.lod];
      for (const chunk of [...column.chunks.values()]) {
        if (column.wanted && chunk.y >= level!.y0 && chunk.y <= level!.y1) this.consider(chunk);
        else this.leave(chunk.lod, chunk.x, chunk.y, chunk.z); // a client that is gone would not say so
      }
    }
    this.coverStale = true;
  }

  setSlice(slice: SlicePlane | null): void {
    this.slice = slice;
    for (const column of this.columns.values()) {
      const cut = this.isCut(column);
      if (cut || column.cut) for (const chunk of column.chunks.values()) this.consider(chunk);
      column.cut = cut;
    }
    this.version++;
  }

  /** `touched`: of a chunk that is here already, which neighbours (as bits of Job.known) show something of what changed. */
  add(lod: number, x: number, y: number, z: number, payload: Uint8Array | null, material: number | null, touched = ALL_AROUND): void {
    let column = this.get(lod, x, z);
    if (column === undefined) {
      column = new Column<D>(lod, x, z);
      this.columns.set(columnKey(lod, x, z), column);
      this.placeInShape(column);
    }
    let chunk = column.chunks.get(y);
    const isNew = chunk === undefined;
    if (chunk === undefined) {
      chunk = new Chunk<D>(column, y);
      column.chunks.set(y, chunk);
    }
    const returns = chunk.left;
    if (isNew || returns) {
      this.held++;
      this.heldPerLevel[lod]!++;
    }
    if (returns) column.left--;
    chunk.left = false;
    this.payloadBytes += (payload?.length ?? 0) - (chunk.payload?.length ?? 0);
    chunk.payload = payload;
    chunk.material = material;
    chunk.arrived = this.options.now();
    chunk.changed = true;
    chunk.hurried = !isNew && !returns;
    this.options.meshers.send(chunk);
    this.eachNeighbour(chunk, (other, bit) => {
      if (!other.left) {
        chunk!.known |= 1 << bit;
        other.known |= 1 << (26 - bit);
        if (!isNew && (touched >>> bit) & 1) {
          other.changed = true;
          other.hurried = !returns;
        }
        this.consider(other);
      }
    });
    this.consider(chunk);
  }

  leave(lod: number, x: number, y: number, z: number): void {
    const chunk = this.get(lod, x, z)?.chunks.get(y);
    if (chunk === undefined || chunk.left) return;
    chunk.left = true;
    chunk.column.left++;
    this.payloadBytes -= chunk.payload?.length ?? 0;
    chunk.payload = null;
    chunk.known = 0;
    this.held--;
    this.heldPerLevel[lod]!--;
    this.options.meshers.drop(chunk);
    this.eachNeighbour(chunk, (other, bit) => {
      other.known &= ~(1 << (26 - bit));
    });
    if (chunk.job !== null) this.cancel(chunk);
    if (chunk.drawable === null && chunk.meshedWith < 0) this.forget(chunk);
    this.coverStale = true;
  }

  meshed(id: number, mesh: ChunkMesh): void {
    const chunk = this.jobs.get(id);
    this.jobs.delete(id);
    if (chunk === undefined || chunk.job?.id !== id) return;
    const job = chunk.job;
    chunk.job = null;
    const drawable = mesh.quads.length > 0 ? this.options.drawer.add(job.slot, mesh) : null;
    if (drawable === null) this.options.drawer.freeSlot(job.slot);
    if (chunk.meshedWith < 0) this.options.arrivedToDrawn(this.options.now() - chunk.arrived);
    this.replace(chunk, drawable, job.known, job.slice);
    if (job.slice === null) {
      chunk.tops = mesh.tops;
      chunk.liquidTops = mesh.liquidTops;
      chunk.column.stale = true;
    }
    this.consider(chunk);
  }

  failed(id: number): void {
    const chunk = this.jobs.get(id);
    this.jobs.delete(id);
    if (chunk?.job?.id !== id) return;
    this.options.drawer.freeSlot(chunk.job.slot);
    chunk.job = null;
  }

  /** Hands jobs to the workers, nearest first, and finds out what to draw. */
  update(camera: { x: number; y: number; z: number }, budgetMs: number): void {
    const start = this.options.now();
    if (Math.abs(camera.x - this.camera.x) + Math.abs(camera.z - this.camera.z) > 24) {
      this.camera = { ...camera };
      this.queueSorted = false;
    }
    this.dispatch();
    // While it fills, a few times a second are enough; for the first that is drawn nobody is to wait.
    if (this.coverStale && (start - this.coveredAt > 80 || this.cover.size === 0)) this.recover(budgetMs);
  }

  /** Meshes are gone, as when the graphics context was lost: all are made again. */
  loseMeshes(): void {
    for (const column of this.columns.values()) {
      column.ready = column.begun = false;
      column.stale = true;
      column.drawables = [];
      for (const chunk of [...column.chunks.values()]) {
        if (chunk.drawable !== null) this.options.drawer.remove(chunk.drawable);
        chunk.drawable = null;
        chunk.meshedWith = -1;
        if (chunk.left) this.forget(chunk);
        else this.consider(chunk);
      }
    }
    this.coverStale = true;
  }

  clear(): void {
    for (const column of [...this.columns.values()]) {
      for (const chunk of [...column.chunks.values()]) {
        this.leave(chunk.lod, chunk.x, chunk.y, chunk.z);
        this.forget(chunk);
      }
    }
    this.queue = [];
    this.coverStale = true;
    this.recover(Infinity);
  }

  private placeInShape(column: Column<D>): void {
    column.around = 0;
    for (let dz = -1; dz <= 1; dz++)
      for (let dx = -1; dx <= 1; dx++)
        if (hasColumn(this.shape, column.lod, column.x + dx, column.z + dz)) column.around |= 1 << ((dz + 1) * 3 + dx + 1);
    column.wanted = (column.around & 16) !== 0;
  }

  /** Neighbours that the View has, as bits. */
  private wantedAround(chunk: Chunk<D>): number {
    const level = this.shape[chunk.lod];
    if (level === undefined) return 0;
    const around = chunk.column.around;
    let bits = (around & ~16) << 9;
    if (chunk.y > level.y0) bits |= around;
    if (chunk.y < level.y1) bits |= around << 18;
    return bits;
  }

  private eachNeighbour(chunk: Chunk<D>, visit: (other: Chunk<D>, bit: number) => void): void {
    for (let dz = -1; dz <= 1; dz++) {
      for (let dx = -1; dx <= 1; dx++) {
        const column = dx === 0 && dz === 0 ? chunk.column : this.get(chunk.lod, chunk.x + dx, chunk.z + dz);
        if (column === undefined) continue;
        for (let dy = -1; dy <= 1; dy++) {
          if (dx === 0 && dy === 0 && dz === 0) continue;
          const other = column.chunks.get(chunk.y + dy);
          if (other !== undefined) visit(other, (dy + 1) * 9 + (dz + 1) * 3 + dx + 1);
        }
      }
    }
  }

  /** Queues the chunk where it is to be meshed, and can be. */
  private consider(chunk: Chunk<D>): void {
    if (chunk.left || chunk.queued || chunk.job !== null) return;
    const missing = this.wantedAround(chunk) & ~chunk.known;
    if (missing !== 0) return;
    const slice = this.sliceOf(chunk);
    const isCurrent = chunk.meshedWith >= 0 && !chunk.changed && (chunk.known & ~chunk.meshedWith) === 0 && chunk.meshedSlice === slice;
    if (isCurrent) return;
    if (this.isPlain(chunk)) {
      const first = chunk.meshedWith < 0;
      this.replace(chunk, null, chunk.known, slice);
      chunk.changed = chunk.hurried = false;
      if (first || chunk.tops !== null) {
        chunk.tops = null;
        chunk.column.stale = true;
      }
      return;
    }
    chunk.queued = true;
    this.queue.push(chunk);
    this.queueSorted = false;
  }

  /** What a slice does to it: null where it leaves the chunk whole. */
  private sliceOf(chunk: Chunk<D>): SlicePlane | null {
    return this.isCut(chunk.column) ? this.slice : null;
  }

  /** With its apron. */
  private isCut(column: Column<D>): boolean {
    if (this.slice === null) return false;
    const size = 32 * 2 ** column.lod;
    return sideOf(this.slice, (column.x - 1 / 32) * size, (column.z - 1 / 32) * size, size * 1.0625) === 'cut';
  }

  /** Whether the chunk has no faces, as it is of one material and so are its neighbours. */
  private isPlain(chunk: Chunk<D>): boolean {
    if (chunk.material === null) return false;
    const kind = this.options.kindOf(chunk.material);
    if (kind === 'gas') return true;
    if (this.sliceOf(chunk) !== null) return false;
    let plain = true;
    // Of the six across a face; liquid shows none toward solid either.
    const check = (dx: number, dy: number, dz: number) => {
      const bit = (dy + 1) * 9 + (dz + 1) * 3 + dx + 1;
      if (!plain || !((chunk.known >>> bit) & 1)) return;
      const other = this.get(chunk.lod, chunk.x + dx, chunk.z + dz)?.chunks.get(chunk.y + dy);
      if (other === undefined || other.material === null) {
        plain = false;
        return;
      }
      const beyond = this.options.kindOf(other.material);
      if (!(beyond === 'solid' || beyond === kind)) plain = false;
    };
    check(-1, 0, 0);
    check(1, 0, 0);
    check(0, -1, 0);
    check(0, 1, 0);
    check(0, 0, -1);
    check(0, 0, 1);
    return plain;
  }

  private replace(chunk: Chunk<D>, drawable: D | null, known: number, slice: SlicePlane | null): void {
    if (chunk.drawable !== null) this.options.drawer.remove(chunk.drawable);
    const had = chunk.drawable !== null;
    chunk.drawable = drawable;
    if (had || drawable !== null) this.gather(chunk.column);
    chunk.meshedWith = known;
    chunk.meshedSlice = slice;
    chunk.column.begun ||= drawable !== null;
    chunk.column.stale ||= !chunk.column.ready;
    this.coverStale = true;
    this.version++;
  }

  private priority(chunk: Chunk<D>): number {
    const size = 32 * 2 ** chunk.lod;
    const dx = (chunk.x + 0.5) * size - this.camera.x;
    const dy = (chunk.y + 0.5) * size - this.camera.y;
    const dz = (chunk.z + 0.5) * size - this.camera.z;
    // A chunk that is drawn already can wait; what lies deep too.
    if (chunk.hurried) return Math.hypot(dx, dz) - 100_000;
    return Math.hypot(dx, dz) + (dy > 0 ? dy * 0.25 : -dy * 0.5) + (chunk.meshedWith >= 0 && chunk.meshedSlice === this.sliceOf(chunk) ? 200 : 0);
  }

  private dispatch(): void {
    if (this.queue.length === 0) return;
    const now = this.options.now();
    if (!this.queueSorted && now - this.sortedAt > 120) {
      this.sortedAt = now;
      const by = new Map(this.queue.map((chunk) => [chunk, this.priority(chunk)]));
      this.queue.sort((a, b) => by.get(b)! - by.get(a)!);
      this.queueSorted = true;
    }
    const kept: Chunk<D>[] = [];
    while (this.queue.length > 0 && kept.length < 32) {
      const chunk = this.queue.pop()!;
      chunk.queued = false;
      if (chunk.left || (this.wantedAround(chunk) & ~chunk.known) !== 0) continue;
      if (!this.options.meshers.hasRoom(chunk)) {
        chunk.queued = true;
        kept.push(chunk);
        continue;
      }
      const slice = this.sliceOf(chunk);
      const slot = this.options.drawer.takeSlot(chunk.lod, chunk.x, chunk.y, chunk.z);
      const id = this.nextJob++;
      chunk.job = { id, known: chunk.known, slice, slot };
      chunk.changed = chunk.hurried = false;
      this.jobs.set(id, chunk);
      this.options.meshers.mesh(chunk, { id, lod: chunk.lod, x: chunk.x, y: chunk.y, z: chunk.z, slot, known: chunk.known, slice });
    }
    for (let i = kept.length - 1; i >= 0; i--) this.queue.push(kept[i]!);
  }

  private cancel(chunk: Chunk<D>): void {
    // The worker's answer finds no job; the slot is free again then, so that no late mesh is drawn in another's place.
    this.jobs.delete(chunk.job!.id);
    this.options.drawer.freeSlot(chunk.job!.slot);
    chunk.job = null;
  }

  private forget(chunk: Chunk<D>): void {
    if (chunk.drawable !== null) this.options.drawer.remove(chunk.drawable);
    chunk.drawable = null;
    const column = chunk.column;
    if (chunk.left) column.left--;
    column.chunks.delete(chunk.y);
    this.gather(column);
    if (column.chunks.size === 0) this.columns.delete(columnKey(column.lod, column.x, column.z));
  }

  private gather(column: Column<D>): void {
    column.drawables = [];
    for (const chunk of column.chunks.values()) if (chunk.drawable !== null) column.drawables.push(chunk.drawable);
  }

  private recover(budgetMs: number): void {
    this.coverStale = false;
    this.coveredAt = this.options.now();
    let refreshed = 0;
    for (const column of this.columns.values()) {
      if (!column.stale) continue;
      if (refreshed++ >= 24 && this.options.now() - this.coveredAt > budgetMs) {
        this.coverStale = true; // the rest next time
        break;
      }
      this.refresh(column);
    }
    this.version++;
    const before = this.cover;
    this.cover = coverOf(this.shape, this);
    for (const column of before) column.drawn = false;
    for (const column of this.cover) column.drawn = true;
    for (const column of this.cover) {
      const { lod, x, z } = column;
      column.skirts =
        (this.get(lod, x - 1, z)?.drawn ? 0 : 1) | (this.get(lod, x, z - 1)?.drawn ? 0 : 2) |
        (this.get(lod, x + 1, z)?.drawn ? 0 : 4) | (this.get(lod, x, z + 1)?.drawn ? 0 : 8);
    }
    // What left the View and is not drawn in place of something: gone.
    for (const column of [...this.columns.values()]) {
      if (column.left === 0 || (column.drawn && !column.wanted)) continue;
      for (const chunk of [...column.chunks.values()]) if (chunk.left && !(column.drawn && !column.ready)) this.forget(chunk);
    }
  }

  /** Heights, and whether all is meshed that can be seen from above: from the top down to where no column is open. */
  private refresh(column: Column<D>): void {
    column.stale = false;
    const level = this.shape[column.lod];
    if (level === undefined || column.chunks.size === 0) return;
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
      const kind = chunk.material === null ? null : this.options.kindOf(chunk.material);
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
    if (heights !== null || liquids !== null) {
      column.heights = heights;
      column.liquids = liquids;
      let lowest = 32767;
      if (heights !== null) for (let i = 0; i < 1024; i++) if (heights[i]! < lowest) lowest = heights[i]!;
      column.lowest = heights === null ? NO_HEIGHT : lowest;
      this.options.heights(column);
    }
  }
}

