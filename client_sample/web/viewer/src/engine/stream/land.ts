// The land of the View: received chunks, chunks to be meshed, and columns drawn.
//
// A chunk is meshed once all its neighbours in the View are loaded, so that no seams show, and again when a neighbour
// arrives that the View did not have before. Chunks that left stay drawn until their replacement is ready (cover.ts).
import type { ChunkMesh } from '../mesh/mesher.js';
import { ALL_AROUND } from '../edit/touched.js';
import { Chunk, Column, type Drawable, type Kind } from './column.js';
import { Columns } from './columns.js';
import { coverOf, nearestMissing } from './cover.js';
import { refreshHeights } from './heights.js';
import { MeshQueue } from './mesh_queue.js';
import type { Job, SlicePlane } from './messages.js';
import { columnsAround, type Shape } from './shape.js';
import { sideOf } from './slice.js';

/** Destination of meshes. */
export interface Drawer<D extends Drawable> {
  takeSlot(lod: number, x: number, y: number, z: number): number;
  freeSlot(slot: number): void;
  add(slot: number, mesh: ChunkMesh): D;
  remove(drawable: D): void;
}

/** The workers; `drop` is called for every chunk sent. */
export interface Meshers {
  send(chunk: Chunk): void;
  drop(chunk: Chunk): void;
  /** True if there is room for a job; few run at once, so that little time is spent on chunks that left. */
  hasRoom(chunk: Chunk): boolean;
  mesh(chunk: Chunk, job: Job): void;
}

export interface LandOptions<D extends Drawable> {
  readonly drawer: Drawer<D>;
  readonly meshers: Meshers;
  kindOf(material: number): Kind;
  now(): number;
  /** Called when a column's heights were found or changed. */
  heights(column: Column<D>): void;
  arrivedToDrawn(ms: number): void;
}

const COVER_EVERY_MS = 80;
/** If finding the cover is slow, wait this multiple of its time; bounded, as a page may have been suspended. */
const COVER_SHARE = 40;
const COVER_LATEST_MS = 240;
/** Time per update for heights: a few columns at least, then as many as possible; more before anything is drawn. */
const HEIGHTS_MS = 1;
const FIRST_HEIGHTS_MS = 4;
const MIN_HEIGHTS = 4;

export class Land<D extends Drawable> {
  shape: Shape = [];
  slice: SlicePlane | null = null;
  private readonly columns = new Columns<D>();
  private readonly jobs = new Map<number, Chunk<D>>();
  private readonly queue = new MeshQueue<D>((chunk) => this.sliceOf(chunk));
  private nextJob = 1;
  private coverStale = true;
  /** Columns whose heights or readiness may have changed. */
  private readonly stale = new Set<Column<D>>();
  /** Number of these to check before the cover is updated; null: not due. */
  private toRefresh: number | null = null;
  /** Columns with chunks that left but are still drawn. */
  private readonly leaving = new Set<Column<D>>();
  private coveredAt = -Infinity;
  private coverMs = 0; // duration of the last update
  private cover: Column<D>[] = [];
  /** Incremented when the drawn meshes may have changed. */
  version = 0;
  private covers = 0; // number of updates of the cover
  /** Incremented when other columns are drawn. */
  coverVersion = 0;
  private camera = { x: 0, y: 0, z: 0 };
  held = 0;
  payloadBytes = 0;
  readonly heldPerLevel = [0, 0, 0, 0, 0, 0, 0];

  constructor(private readonly options: LandOptions<D>) {}

  get(lod: number, x: number, z: number): Column<D> | undefined {
    return this.columns.get(lod, x, z);
  }

  values(): Iterable<Column<D>> {
    return this.columns.values();
  }

  /** True if everything received of the View is meshed and drawn in its final form. */
  get settled(): boolean {
    return this.queue.length === 0 && this.jobs.size === 0 && !this.coverStale && this.stale.size === 0;
  }

  get waiting(): number {
    return this.queue.length + this.jobs.size;
  }

  /** Columns to draw, without overlaps. */
  get drawn(): readonly Column<D>[] {
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
      for (const chunk of column.chunks.values()) {
        if (column.wanted && chunk.y >= level!.y0 && chunk.y <= level!.y1) this.consider(chunk);
        else this.leave(chunk.lod, chunk.x, chunk.y, chunk.z); // a client that is gone does not report this
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

  /** `touched`: for a replaced chunk, the neighbours affected by the change (as bits of Job.known). */
  add(
    lod: number, x: number, y: number, z: number,
    payload: Uint8Array | null, material: number | null, touched = ALL_AROUND, hash: string | null = null,
  ): void {
    let column = this.get(lod, x, z);
    if (column === undefined) {
      column = new Column<D>(lod, x, z);
      this.columns.add(column);
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
    chunk.hash = hash;
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
    this.leaving.add(chunk.column);
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
      this.stale.add(chunk.column);
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

  /** Passes jobs to the workers, nearest first, and updates the cover. */
  update(camera: { x: number; y: number; z: number }): void {
    const start = this.options.now();
    if (Math.abs(camera.x - this.camera.x) + Math.abs(camera.z - this.camera.z) > 24) {
      this.camera = { ...camera };
      this.queue.moved();
    }
    this.dispatch();
    if (this.toRefresh === null) {
      if ((!this.coverStale && this.stale.size === 0) || !this.isDue(start)) return;
      this.coveredAt = start;
      this.toRefresh = this.stale.size;
    }
    this.refresh(start, this.toRefresh);
    if (this.toRefresh === null) this.recover();
  }

  /** A few times per second suffice while loading; the first cover is immediate. */
  private isDue(now: number): boolean {
    return now - this.coveredAt > Math.min(COVER_LATEST_MS, Math.max(COVER_EVERY_MS, COVER_SHARE * this.coverMs)) || this.cover.length === 0;
  }

  /** Meshes were lost with the graphics context: all are recreated. */
  loseMeshes(): void {
    for (const column of this.cover) column.drawn = false;
    this.cover = [];
    for (const column of this.columns.values()) {
      column.ready = column.begun = false;
      this.stale.add(column);
      for (const chunk of column.chunks.values()) {
        if (chunk.drawable !== null) this.options.drawer.remove(chunk.drawable);
        chunk.drawable = null;
        chunk.meshedWith = -1;
        if (chunk.left) this.forget(chunk);
        else this.consider(chunk);
      }
      column.gather();
    }
    this.coverStale = true;
  }

  clear(): void {
    for (const column of [...this.columns.values()]) {
      for (const chunk of column.chunks.values()) {
        this.leave(chunk.lod, chunk.x, chunk.y, chunk.z);
        this.forget(chunk);
      }
    }
    this.queue.clear();
    this.stale.clear();
    this.toRefresh = null;
    this.coverStale = true;
    this.recover();
  }

  private placeInShape(column: Column<D>): void {
    column.around = columnsAround(this.shape, column.lod, column.x, column.z);
    column.wanted = (column.around & 16) !== 0;
  }

  /** Neighbours in the View, as bits. */
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
    const { near } = chunk.column;
    for (let at = 0; at < 9; at++) {
      const column = near[at];
      if (column === undefined) continue;
      for (let dy = -1; dy <= 1; dy++) {
        if (at === 4 && dy === 0) continue;
        const other = column.chunks.get(chunk.y + dy);
        if (other !== undefined) visit(other, (dy + 1) * 9 + at);
      }
    }
  }

  /** Queues the chunk if it must and can be meshed. */
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
        this.stale.add(chunk.column);
      }
      return;
    }
    this.queue.add(chunk);
  }

  /** The slice that cuts the chunk; null if none does. */
  private sliceOf(chunk: Chunk<D>): SlicePlane | null {
    return this.isCut(chunk.column) ? this.slice : null;
  }

  /** Includes its apron. */
  private isCut(column: Column<D>): boolean {
    if (this.slice === null) return false;
    const size = 32 * 2 ** column.lod;
    return sideOf(this.slice, (column.x - 1 / 32) * size, (column.z - 1 / 32) * size, size * 1.0625) === 'cut';
  }

  /** True if the chunk has no faces, because it and its neighbours are of one material. */
  private isPlain(chunk: Chunk<D>): boolean {
    if (chunk.material === null) return false;
    const kind = this.options.kindOf(chunk.material);
    if (kind === 'gas') return true;
    if (this.sliceOf(chunk) !== null) return false;
    let plain = true;
    // The six neighbours across faces; liquid has no faces towards solid either.
    const check = (dx: number, dy: number, dz: number) => {
      const bit = (dy + 1) * 9 + (dz + 1) * 3 + dx + 1;
      if (!plain || !((chunk.known >>> bit) & 1)) return;
      const other = chunk.column.near[(dz + 1) * 3 + dx + 1]?.chunks.get(chunk.y + dy);
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
    if (had || drawable !== null) chunk.column.gather();
    chunk.meshedWith = known;
    chunk.meshedSlice = slice;
    const { column } = chunk;
    if (!column.begun && drawable !== null) column.begun = this.coverStale = true;
    if (!column.ready) this.stale.add(column);
    this.version++;
  }

  private dispatch(): void {
    this.queue.forEachNext(this.options.now(), this.camera, (chunk) => {
      if (chunk.left || (this.wantedAround(chunk) & ~chunk.known) !== 0) return true;
      if (!this.options.meshers.hasRoom(chunk)) return false;
      const slice = this.sliceOf(chunk);
      const slot = this.options.drawer.takeSlot(chunk.lod, chunk.x, chunk.y, chunk.z);
      const id = this.nextJob++;
      chunk.job = { id, known: chunk.known, slice, slot };
      chunk.changed = chunk.hurried = false;
      this.jobs.set(id, chunk);
      this.options.meshers.mesh(chunk, { id, lod: chunk.lod, x: chunk.x, y: chunk.y, z: chunk.z, slot, known: chunk.known, slice });
      return true;
    });
  }

  private cancel(chunk: Chunk<D>): void {
    // The worker's answer will find no job; the slot is released then, so that no late mesh appears in another's place.
    this.jobs.delete(chunk.job!.id);
    this.options.drawer.freeSlot(chunk.job!.slot);
    chunk.job = null;
  }

  private forget(chunk: Chunk<D>): void {
    const { column } = chunk;
    if (chunk.left) column.left--;
    column.chunks.delete(chunk.y);
    if (chunk.drawable !== null) {
      this.options.drawer.remove(chunk.drawable);
      chunk.drawable = null;
      column.gather();
    }
    if (column.chunks.size === 0) {
      this.columns.delete(column);
      this.leaving.delete(column);
      this.stale.delete(column);
    }
  }

  /** Recomputes heights of as many columns as time allows. */
  private refresh(start: number, columns: number): void {
    if (this.stale.size === 0) {
      this.toRefresh = null;
      return;
    }
    const budgetMs = this.cover.length === 0 ? FIRST_HEIGHTS_MS : HEIGHTS_MS;
    let refreshed = 0;
    for (const column of this.stale) {
      if (refreshed === columns || (refreshed >= MIN_HEIGHTS && this.options.now() - start > budgetMs)) break;
      refreshed++;
      this.stale.delete(column);
      const level = this.shape[column.lod];
      if (level === undefined) continue;
      const { ready } = column;
      if (refreshHeights(column, level, this.options.kindOf)) this.options.heights(column);
      this.coverStale ||= ready !== column.ready;
    }
    this.toRefresh = refreshed < columns && this.stale.size > 0 ? columns - refreshed : null;
    this.version++;
  }

  /** Updates the columns to draw, if they may have changed. */
  private recover(): void {
    if (!this.coverStale) return;
    this.coverStale = false;
    const began = this.options.now();
    this.version++;
    this.drawAnew();
    this.coverMs = this.options.now() - began;
  }

  /** Draws the new cover and releases columns that are not drawn any more. */
  private drawAnew(): void {
    const before = this.cover;
    this.cover = coverOf(this.shape, this);
    this.covers++;
    const changed: Column<D>[] = [];
    for (const column of this.cover) {
      column.coveredIn = this.covers;
      if (!column.drawn) changed.push(column);
    }
    for (const column of before) if (column.coveredIn !== this.covers) changed.push(column);
    if (changed.length > 0) this.coverVersion++;
    for (const column of changed) column.drawn = column.coveredIn === this.covers;
    // Skirts face columns that are not drawn: they may have changed here and in neighbours.
    for (const column of changed) for (const at of [1, 3, 4, 5, 7]) column.near[at]?.findSkirts();
    // Release columns that left the View, unless they are drawn as a substitute.
    for (const column of this.leaving) {
      if (column.left === 0) this.leaving.delete(column);
      if (column.left === 0 || (column.drawn && (!column.wanted || !column.ready))) continue;
      for (const chunk of column.chunks.values()) if (chunk.left) this.forget(chunk);
    }
  }
}
