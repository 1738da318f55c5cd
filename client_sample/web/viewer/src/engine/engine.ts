// The engine of the viewer: streams chunks, meshes them in workers and draws them.
import type { Edit, EditDone, EditLimits, View, World } from 'talus';
import type { EngineEvents, EngineOptions, EngineState, Hit, Marker, Slice, Stats, Vector, WorldInfo } from './api.js';
import { Frame, type Eye } from './draw/frame.js';
import { Ground } from './draw/ground.js';
import { materialTexture } from './draw/materials.js';
import { NearestFirst } from './draw/nearest_first.js';
import type { TerrainMesh } from './draw/terrain.js';
import { EditSender } from './edit/edit_sender.js';
import { Predictions, type Content, type VoxelChange } from './edit/predictions.js';
import { touchedNeighbours } from './edit/touched.js';
import { kindIn, tablesOf } from './mesh/kinds.js';
import { MATERIALS_MAX } from './mesh/quad.js';
import { Rate, Sample } from './meter.js';
import { castRay } from './raycast.js';
import { decodeChunk } from './stream/decode.js';
import { Land } from './stream/land.js';
import { Link } from './stream/link.js';
import { Pool, workersFor } from './stream/pool.js';
import { chunksOf, shapeOf, viewFor } from './stream/shape.js';
import { ViewSender } from './stream/view_sender.js';
import { Voxels } from './stream/voxels.js';
import { waterline } from './waterline.js';

export type * from './api.js';

/** Chunks that may wait for workers before the server is told to pause. */
const WAITING_MAX = 3000;
/** Maximum time that the first picture waits for land; until then, a picture of the sky would delay it. */
const SKY_AFTER_MS = 3000;

export class Engine {
  /** Resolves when the server has described its world; rejects with a TalusError, or an Error that names a missing
   *  feature of the browser (WebGL 2). */
  static async create(options: EngineOptions): Promise<Engine> {
    const engine = new Engine(options);
    try {
      await engine.joined;
    } catch (error) {
      engine.dispose();
      throw error;
    }
    return engine;
  }

  private info: WorldInfo | null = null;
  private readonly link: Link;
  private joined: Promise<World>;
  private readonly frames: Frame;
  private readonly pool: Pool;
  private readonly land: Land<TerrainMesh>;
  private readonly voxels = new Voxels((x, y, z) => this.land.get(0, x, z)?.chunks.get(y));
  private readonly handlers = new Map<keyof EngineEvents, Set<(...args: never[]) => void>>();
  private kinds: Uint8Array = new Uint8Array();
  private state: EngineState = 'connecting';
  private viewComplete = false;
  private complete = false;
  private eye: Eye = { x: 0, y: 0, z: 0, yaw: 0, pitch: 0 };
  private readonly views = new ViewSender();
  private chunksWanted = 0;
  private radius: number;
  private horizon: number;
  private token: string | undefined;
  private slice: Slice | null = null;
  private selection: Vector | null = null;
  private marker: Marker | null = null;
  private readonly predictions: Predictions;
  private readonly editing: EditSender;
  private readonly nearestFirst = new NearestFirst<TerrainMesh>();
  private lost = false;
  private disposed = false;
  private readonly started = performance.now();
  private hasPicture = false;
  private firstFrameMs: number | null = null;
  private completeMs: number | null = null;
  private readonly latency = new Sample(1024);
  private readonly cpu = new Sample(256);
  /** Time in update() since the last frame(). */
  private updated = 0;
  private readonly rate = new Rate();
  private seaLevel: number | null = null;
  private drawnVersion = -1;
  private reducedMotion: boolean;
  private wantsPicture: ((blob: Blob | null) => void)[] = [];

  private constructor(private readonly options: EngineOptions) {
    this.radius = options.radius;
    this.horizon = options.horizon;
    this.token = options.token;
    this.reducedMotion = options.reducedMotion;
    this.link = new Link(
      options,
      {
        connected: (world, sameWorld) => this.onConnected(world, sameWorld),
        chunk: (chunk) => {
          const { lod, x, y, z } = chunk.key;
          this.rate.add(performance.now());
          const content = lod === 0 ? this.predictions.arrived(chunk.key, chunk.revision, chunk) : chunk;
          if (content !== null) this.addChunk(lod, x, y, z, content);
        },
        left: (key) => {
          if (key.lod === 0) this.predictions.left(key);
          this.land.leave(key.lod, key.x, key.y, key.z);
        },
        viewComplete: () => {
          this.viewComplete = true;
          this.workSoon();
        },
        lost: (text, refused) => this.setState(refused ? 'refused' : 'lost', text),
        error: (text) => this.emit('error', text),
      },
      () => this.land.waiting >= WAITING_MAX,
    );
    // Start with work that waits for the network and for other threads.
    this.joined = this.link.open(this.token);
    this.pool = new Pool(
      workersFor(navigator.hardwareConcurrency ?? 2),
      () => new Worker(new URL('./stream/worker.ts', import.meta.url), { type: 'module' }),
      (answer) => {
        if (this.disposed) return;
        this.workSoon();
        if (answer.kind === 'meshed') this.land.meshed(answer.id, answer.mesh);
        else {
          this.land.failed(answer.id);
          if (answer.text !== 'not held') this.emit('error', `a chunk does not decode: ${answer.text}`);
        }
      },
      (text) => this.emit('error', `a worker that makes meshes ended: ${text}`),
    );
    try {
      this.frames = new Frame(options.canvas, options.quality);
    } catch (error) {
      this.link.close();
      this.pool.dispose();
      throw new Error(`this browser cannot draw the world: it needs WebGL 2 (${(error as Error).message})`);
    }
    this.land = new Land<TerrainMesh>({
      drawer: this.frames.terrain,
      meshers: this.pool,
      kindOf: (material) => kindIn(this.kinds, material),
      now: () => performance.now(),
      heights: (column) => {
        this.frames.ground?.set(column);
        if (column.liquids !== null && this.seaLevel === null) this.seeSea(column.liquids, column.lod);
      },
      arrivedToDrawn: (ms) => this.latency.add(ms),
    });
    this.predictions = new Predictions({
      held: ({ x, y, z }) => {
        const chunk = this.land.get(0, x, z)?.chunks.get(y);
        return chunk === undefined || chunk.left ? null : chunk;
      },
      show: ({ x, y, z }, content) => this.addChunk(0, x, y, z, content),
    });
    this.editing = new EditSender(this.predictions, () => (this.disposed ? null : this.link.client));
    options.canvas.addEventListener('webglcontextlost', this.onContextLost);
    options.canvas.addEventListener('webglcontextrestored', this.onContextRestored);
  }

  get world(): WorldInfo {
    if (this.info === null) throw new Error('the engine has not joined yet');
    return { ...this.info, seaLevel: this.seaLevel };
  }

  setCamera(x: number, y: number, z: number, yaw: number, pitch: number): void {
    this.eye = { x, y, z, yaw, pitch };
  }

  setFov(degrees: number): void {
    this.frames.setFov(degrees);
  }

  resize(width: number, height: number, devicePixelRatio: number): void {
    this.frames.resize(width, height, devicePixelRatio);
  }

  /** Streams: requests the View at the camera, passes chunks to the workers and meshes to the GPU. Call as often as
   *  possible, at least for each frame. */
  update(): void {
    if (this.disposed) return;
    const start = performance.now();
    this.sendView(start);
    this.work();
    this.updated += performance.now() - start;
  }

  /** Draws. `now` as in requestAnimationFrame, in milliseconds. */
  frame(now: number): void {
    if (this.disposed) return;
    const start = performance.now();
    if (!this.lost && this.info !== null) this.draw(now);
    this.cpu.add(performance.now() - start + this.updated);
    this.updated = 0;
  }

  /** Material of the base voxel at integer coordinates; undefined: not loaded yet. */
  voxelAt(x: number, y: number, z: number): number | undefined {
    return this.voxels.atBlock(x, y, z, this.info?.maxY ?? Infinity);
  }

  /** The first voxel that is neither gas nor, unless `liquids`, liquid. */
  raycast(origin: Vector, direction: Vector, max: number, liquids = false): Hit | null {
    return castRay(origin, direction, max, (x, y, z) => this.voxelAt(x, y, z), (m) => this.isSolid(m) || (liquids && this.isLiquid(m)));
  }

  isSolid(material: number): boolean {
    return kindIn(this.kinds, material) === 'solid';
  }

  isLiquid(material: number): boolean {
    return kindIn(this.kinds, material) === 'liquid';
  }

  /** 0 to 24; the sun rises at 6. */
  setTimeOfDay(hours: number): void {
    this.frames.setTimeOfDay(((hours % 24) + 24) % 24);
  }

  setSlice(slice: Slice | null): void {
    const same = this.slice?.x === slice?.x && this.slice?.z === slice?.z && this.slice?.yaw === slice?.yaw;
    this.slice = slice;
    if (same) return;
    this.land.setSlice(slice === null ? null : { x: slice.x, z: slice.z, nx: Math.sin(slice.yaw), nz: -Math.cos(slice.yaw) });
  }

  setChunkBorders(on: boolean): void {
    this.frames.setBorders(on);
  }

  /** Frames a voxel; null: no frame. */
  setSelection(voxel: Vector | null): void {
    this.selection = voxel;
  }

  /** Marks what an edit would change; null: no mark. */
  setMarker(marker: Marker | null): void {
    this.marker = marker;
  }

  /** Reason why edits are impossible here, in words for users; null: they may be tried. */
  get whyNoEdits(): string | null {
    if (this.options.transport === 'http' && this.options.source === undefined) return 'By HTTP one only looks. The settings have WebSocket, which takes edits.';
    if (this.info === null) return 'The world is not here yet.';
    return /^0*$/.test(this.info.storeId) ? 'This server keeps no edits: it has no place to store them.' : null;
  }

  /** Rejects with a TalusError if the server does not let this player edit. */
  editLimits(): Promise<EditLimits> {
    return this.link.client.editLimits();
  }

  /** Sends an edit, and shows `changes`, its effect, at once; they are reverted if it is refused. */
  edit(edit: Edit, changes: readonly VoxelChange[]): Promise<EditDone> {
    return this.editing.edit(this.link.client, edit, changes);
  }

  setRadius(radius: number, horizon: number): void {
    if (radius === this.radius && horizon === this.horizon) return;
    this.radius = radius;
    this.horizon = horizon;
    if (this.info !== null) this.makeGround();
  }

  setQuality(quality: 'low' | 'high'): void {
    this.frames.setQuality(quality);
  }

  setReducedMotion(on: boolean): void {
    this.reducedMotion = on;
  }

  setToken(token: string): void {
    this.token = token;
    this.reconnect();
  }

  /** If the connection is lost: makes the next attempt at once. Waiting edits keep waiting. */
  hurry(): void {
    if (!this.link.hurry()) this.reconnect();
  }

  /** Reconnects; the drawn land stays until it arrives again. */
  reconnect(): void {
    this.link.drop();
    this.setState('connecting', '');
    this.joined = this.link.open(this.token);
  }

  /** The next picture as a PNG; the first one waits for land, at most a few seconds. */
  screenshot(): Promise<Blob> {
    return new Promise((resolve, reject) => {
      this.wantsPicture.push((blob) => (blob ? resolve(blob) : reject(new Error('the browser made no picture'))));
    });
  }

  /** Cheap enough for every frame: expensive values are computed when read. */
  stats(): Stats {
    const now = performance.now();
    const { latency, cpu, land, eye } = this;
    return {
      state: this.state,
      chunks: this.land.held,
      chunksPerLevel: [...this.land.heldPerLevel],
      chunksWanted: this.chunksWanted,
      pendingMeshes: this.land.waiting,
      meshes: this.frames.terrain.meshes,
      current: this.land.version === this.drawnVersion,
      triangles: this.frames.triangles,
      drawCalls: this.frames.drawCalls,
      receivedBytes: this.link.client.stats.receivedBytes,
      madeChunks: this.link.client.stats.madeChunks,
      receivedChunks: this.link.client.stats.chunks - this.link.client.stats.madeChunks,
      get latency() {
        const of = latency.percentiles(0.5, 0.95, 0.99);
        return of && { p50: of[0]!, p95: of[1]!, p99: of[2]! };
      },
      chunkRate: this.rate.at(now),
      get nearestMissing() {
        return land.nearestMissing(eye.x, eye.z);
      },
      gpuBytes: this.frames.gpuBytes,
      heapBytes: this.pool.heldBytes + this.voxels.bytes + this.land.payloadBytes,
      get frameCpu() {
        const [p50, p95] = cpu.percentiles(0.5, 0.95) ?? [0, 0];
        return { p50: p50!, p95: p95! };
      },
      meshMs: this.pool.meanMs,
      hasPicture: this.hasPicture,
      firstFrameMs: this.firstFrameMs,
      completeMs: this.completeMs,
    };
  }

  on<K extends keyof EngineEvents>(event: K, handler: EngineEvents[K]): () => void {
    let handlers = this.handlers.get(event);
    if (handlers === undefined) this.handlers.set(event, (handlers = new Set()));
    handlers.add(handler);
    return () => void handlers.delete(handler);
  }

  dispose(): void {
    if (this.disposed) return;
    this.disposed = true;
    this.options.canvas.removeEventListener('webglcontextlost', this.onContextLost);
    this.options.canvas.removeEventListener('webglcontextrestored', this.onContextRestored);
    this.link.close();
    this.pool.dispose();
    this.frames.dispose();
  }

  private onConnected(world: World, sameWorld: boolean): void {
    const isNew = this.info === null || !sameWorld || this.info.fingerprint !== world.fingerprint;
    if (isNew) {
      if (this.info !== null) {
        this.land.clear();
        this.predictions.clear();
        this.voxels.clear();
      }
      this.info = { ...world, seaLevel: null };
      this.seaLevel = null;
      this.prepareMaterials(world);
      this.makeGround();
      if (!this.views.hasSent && this.eye.x === 0 && this.eye.z === 0) {
        this.eye = { ...this.eye, x: world.spawn.x + 0.5, y: world.spawn.y + 1.6, z: world.spawn.z + 0.5 };
      }
    }
    this.setState('streaming', '');
    // At once, so that the end of the View is not reported before it is awaited.
    if (this.views.hasSent) {
      this.views.reset();
      this.sendView(performance.now());
    }
    this.emit('world', this.world, !isNew);
  }

  /** Adds or replaces a chunk; for a replacement, only visible differences are remeshed. */
  private addChunk(lod: number, x: number, y: number, z: number, { payload, material, hash }: Content): void {
    const before = this.land.get(lod, x, z)?.chunks.get(y);
    const isEdited = before !== undefined && !before.left && before.meshedWith >= 0;
    let touched: number | undefined;
    if (isEdited) {
      try {
        touched = touchedNeighbours(before.material ?? decodeChunk(before.payload!), material ?? decodeChunk(payload!));
      } catch {
        // The workers report payloads that do not decode.
      }
    }
    this.land.add(lod, x, y, z, payload, material, touched, hash);
    this.workSoon();
  }

  private prepareMaterials(world: World): void {
    const materials = world.materials.slice(0, MATERIALS_MAX);
    const { kinds, places } = tablesOf(materials);
    this.kinds = kinds;
    this.pool.setWorld(kinds, places);
    this.frames.setMaterials(materialTexture(materials));
  }

  private makeGround(): void {
    const levels = viewFor(this.info!, this.eye, { x: 0, y: 0, z: 0 }, this.radius, this.horizon).rings!.length + 1;
    const middle = Math.round((this.info!.minY + this.info!.maxY) / 128) * 64;
    this.groundBase = this.info!.maxY - this.info!.minY < 2000 ? 0 : middle;
    const current = this.frames.ground;
    if (current !== null && current.isFor(this.radius, levels, this.groundBase) && !this.lost) return;
    this.frames.setGround(new Ground(this.frames.renderer, this.radius, levels, this.groundBase));
    for (const column of this.land.values()) if (column.heights !== null || column.liquids !== null) this.frames.ground!.set(column);
  }
  private groundBase = 0;

  private seeSea(liquids: Int16Array, lod: number): void {
    for (const height of liquids) {
      if (height <= -32768) continue;
      this.seaLevel = height * 2 ** lod;
      return;
    }
  }

  private sendView(now: number): void {
    const next = this.info && this.views.next(now, this.info, this.eye, this.radius, this.horizon, this.complete);
    if (next === null) return;
    const { view, moved } = next;
    try {
      this.link.client.setView(view);
    } catch (error) {
      this.emit('error', (error as Error).message);
      return;
    }
    if (!moved) return;
    const shape = shapeOf(view, this.info!);
    this.land.setShape(shape);
    this.chunksWanted = chunksOf(shape);
    this.viewComplete = this.complete = false;
    if (this.state === 'complete') this.setState('streaming', '');
    const middle = (v: number) => Math.floor(v / 32) * 32 + 16;
    const { x, z } = view.centre;
    this.frames.setReach(middle(x), middle(z), view.horizontalRadius * 32, this.reach(view));
  }

  /** Work to be done between frames too, so that slow frames do not delay streaming. */
  private work(): void {
    this.link.takeBacklog();
    this.land.update(this.eye);
    this.pool.flush();
    this.settle(performance.now());
  }

  private workSoon(): void {
    if (this.working) return;
    this.working = true;
    setTimeout(() => {
      this.working = false;
      if (!this.disposed) this.work();
    }, 6);
  }
  private working = false;

  private settle(now: number): void {
    if (!this.viewComplete || this.complete || !this.land.settled) return;
    this.complete = true;
    this.completeMs ??= now - this.started;
    if (this.state === 'streaming') this.setState('complete', '');
  }

  private draw(now: number): void {
    const { eye } = this;
    if (this.land.version !== this.drawnVersion) this.frames.landChanged();
    const still = this.options.frozenTime ?? (this.reducedMotion ? 0 : null);
    const water = waterline((y) => {
      const material = this.voxelAt(Math.floor(eye.x), Math.floor(y), Math.floor(eye.z));
      return material !== undefined && this.isLiquid(material);
    }, eye.y);
    const column = this.land.get(0, Math.floor(eye.x / 32), Math.floor(eye.z / 32));
    const within = (v: number) => ((Math.floor(v) % 32) + 32) % 32;
    const roof = column?.heights?.[within(eye.z) * 32 + within(eye.x)] ?? -32768;
    const drew = this.frames.draw({
      eye,
      columns: this.nearestFirst.update(this.land.drawn, this.land.coverVersion, eye.x, eye.z),
      seconds: still ?? now / 1000,
      now: performance.now(),
      slice: this.land.slice,
      selected: this.selection,
      marker: this.marker,
      seaLevel: this.seaLevel,
      underWater: water.under,
      closeToWater: water.close,
      hideBuried: this.land.slice === null && eye.y > roof - 4,
      groundBase: this.groundBase,
      onlyWithLand: !this.hasPicture && !this.complete && performance.now() - this.started < SKY_AFTER_MS,
    });
    if (!drew) return; // the canvas is as empty as before
    this.hasPicture = true;
    this.drawnVersion = this.land.version;
    if (this.firstFrameMs === null && this.frames.triangles > 1) this.firstFrameMs = performance.now() - this.started;
    for (const done of this.wantsPicture.splice(0)) this.options.canvas.toBlob(done, 'image/png');
  }

  /** Visible distance in blocks. */
  private reach(view: View): number {
    const asked = 32 * (view.rings?.at(-1)?.radius ?? view.horizontalRadius);
    return this.horizon === 0 ? asked : Math.min(this.horizon, asked);
  }

  private setState(state: EngineState, reason: string): void {
    if (state === this.state && reason === '') return;
    this.state = state;
    this.emit('state', state, reason);
  }

  private emit<K extends keyof EngineEvents>(event: K, ...args: Parameters<EngineEvents[K]>): void {
    for (const handler of this.handlers.get(event) ?? []) (handler as (...a: unknown[]) => void)(...args);
  }

  private readonly onContextLost = (event: Event): void => {
    event.preventDefault();
    this.lost = true;
    this.emit('contextLost');
  };

  private readonly onContextRestored = (): void => {
    this.frames.contextRestored();
    this.land.loseMeshes();
    if (this.info !== null) this.makeGround(); // a new one, as the old one is empty now
    this.lost = false;
    this.complete = false;
    if (this.state === 'complete') this.setState('streaming', '');
    this.emit('contextRestored');
  };
}
