// A world made here by workers: README.md, "Worlds without a server".
import { compiledModule, WorldError, type MadeChunk, type Wanted, type WorldMaterial } from '../../wasm/world.js';
import { checkKey, keyName } from '../keys.js';
import type { ChunkKey, Edit, Material, Position } from '../types.js';
import { Crew, type Supplier } from './crew.js';
import { asModuleEdit } from './module_edit.js';
import type { About, Columns, EditedChunk, EditMade, Key, MadeColumns } from './messages.js';

export { WorldError, type MadeChunk, type Wanted };

export interface OpenOptions {
  /** Files that the world names: height maps as .npy, models as .vox. */
  readonly files?: Record<string, Uint8Array>;
  /** How many workers make it; 1 unless told otherwise. */
  readonly workers?: number;
  /** The most memory of each worker, 8 MiB to 4 GiB; 1 GiB unless told otherwise. */
  readonly memoryBytes?: number;
  /** Of it for ground that neighbouring chunks share; 32 MiB unless told otherwise. */
  readonly groundBytes?: number;
  /** Makes a module worker of talus-client/local/worker, for bundlers that put it elsewhere. */
  readonly worker?: () => Worker;
  /** The package's .wasm, for bundlers that put it elsewhere. */
  readonly module?: WebAssembly.Module;
}

const PATCH = 2; // 2^2 x 2^2 columns share most of the work
export const patchOf = ({ lod, x, z }: { lod: number; x: number; z: number }): string => `${lod}/${x >> PATCH}/${z >> PATCH}`;

export const MAX_WORKERS = 64;
/** Half of the cores: meshes and the page need the others. */
export const workersFor = (cores: number): number => Math.min(4, Math.max(1, cores >> 1));

/** Chunks of a world, equal to a server's to the bit. No call blocks. */
export class World {
  private readonly edited = new Map<string, EditedChunk>();

  /** Rejects with a WorldError, which names line and column of what is wrong in the world file. */
  static async open(toml: string | Uint8Array, options: OpenOptions = {}): Promise<World> {
    const { files = {}, workers = 1, memoryBytes = 1 << 30, groundBytes = 32 << 20 } = options;
    const bytes = typeof toml === 'string' ? new TextEncoder().encode(toml) : toml;
    const module = options.module ?? (await compiledModule());
    const edited: { rows: () => readonly EditedChunk[] } = { rows: () => [] };
    const crew = new Crew({ toml: bytes, files, module, memoryBytes, groundBytes }, options.worker, () => edited.rows());
    try {
      const world = new World(crew, await crew.resize(checkedWorkers(workers)));
      edited.rows = () => [...world.edited.values()];
      return world;
    } catch (error) {
      crew.end(new WorldError('closed', 'the world did not open'));
      throw error;
    }
  }

  readonly fingerprint: string;
  readonly generatorVersion: number;
  readonly codecVersion: number;
  /** Base rows that hold everything but rock and air. */
  readonly heightRange: { readonly low: number; readonly high: number };
  /** By rising id, which is no index: those of the land, then those only for edits, whose ids are not a server's. */
  readonly materials: readonly Material[];
  /** 'wasm128' or 'scalar'. */
  readonly instructionSet: string;
  private spawnFound: Promise<Position> | null = null;
  private editCount = 0;

  private constructor(
    private readonly crew: Crew,
    about: About,
  ) {
    this.fingerprint = about.fingerprint;
    this.generatorVersion = about.generatorVersion;
    this.codecVersion = about.codecVersion;
    this.heightRange = about.heightRange;
    this.materials = [...about.materials, ...about.placeables].map(asMaterial);
    this.instructionSet = about.instructionSet;
  }

  /** 1 to 64. Each has a copy of the world, and memory of its own. */
  async useWorkers(workers: number): Promise<void> {
    await this.crew.resize(checkedWorkers(workers));
  }

  get workers(): number {
    return this.crew.size;
  }

  /** The voxels of a chunk, unless `wanted` says otherwise, with the edits. An aborted `signal` rejects with its reason. */
  async generate(key: ChunkKey, { signal, ...wanted }: Wanted & { readonly signal?: AbortSignal } = {}): Promise<MadeChunk> {
    checkKey(key);
    const { lod, x, y, z } = key;
    return this.crew.ask('generate', [{ lod, x, y, z }, wanted], patchOf(key), signal);
  }

  /** Chunks of columns, as sources take them. */
  async columns(columns: Columns): Promise<MadeColumns> {
    const [x, z] = columns.columns;
    return this.crew.ask('columns', [columns], patchOf({ lod: columns.lod, x: x ?? 0, z: z ?? 0 }));
  }

  /** The ground of columns of a level in 1/256 voxel, z slowest: the top of solid material without objects. */
  heights(area: { lod?: number; x: number; z: number; width: number; depth: number }): Promise<Int32Array> {
    return this.crew.ask('heights', [area], '');
  }

  /** A tile of the map as talusd paints it: 256 x 256 pixels of red, green and blue. */
  map(tile: { zoom: number; x: number; z: number }, signal?: AbortSignal): Promise<Uint8Array> {
    return this.crew.ask('map', [tile], 'map', signal);
  }

  /** The base voxel for a player's feet, as a server of this world has it. */
  spawn(): Promise<Position> {
    this.spawnFound ??= this.crew.ask('spawn', [], '').catch((error: WorldError) => {
      this.spawnFound = null; // another attempt may succeed
      throw error;
    });
    return this.spawnFound;
  }

  /** Changes voxels, whole or not at all, as a server would; rejects with kind 'conflict' if a guard does not hold.
   *  `chunks` of all levels changed; `rows` are all overrides of those of level 0, `before` what they were. */
  async edit(edit: Edit): Promise<EditMade & { readonly before: readonly EditedChunk[] }> {
    const made = await this.crew.askFirst('edit', [asModuleEdit(edit)]);
    const before = made.rows.map((row) => this.overrides(row));
    this.keep(made.rows);
    this.crew.tellOthers('restore', [made.rows]);
    return { ...made, before };
  }

  /** Replaces the overrides of chunks of level 0; returns the chunks of all levels that may have changed. */
  async restore(rows: readonly EditedChunk[]): Promise<readonly Key[]> {
    const changed = await this.crew.askAll('restore', [rows]);
    this.keep(rows);
    return changed;
  }

  /** All overrides of a chunk of level 0: empty runs if there are none. */
  overrides({ x, y, z }: { x: number; y: number; z: number }): EditedChunk {
    return this.edited.get(keyName({ lod: 0, x, y, z })) ?? { x, y, z, runs: new Uint8Array(2) };
  }

  close(): void {
    this.crew.end(new WorldError('closed', 'the world is closed'));
  }

  /** How often it was edited: chunks asked for before the last time may lack edits. */
  get edits(): number {
    return this.editCount;
  }

  /** For sources of chunks: `supplier` is asked for work when a worker has nothing else to do. */
  supply(supplier: Supplier): { again(): void; end(): void } {
    this.crew.supply(supplier);
    return { again: () => this.crew.work(), end: () => this.crew.letGo(supplier) };
  }

  private keep(rows: readonly EditedChunk[]): void {
    ++this.editCount;
    for (const row of rows) {
      const name = keyName({ lod: 0, ...row });
      if (row.runs.length > 2) this.edited.set(name, row);
      else this.edited.delete(name);
    }
  }
}

function checkedWorkers(workers: number): number {
  if (Number.isInteger(workers) && workers >= 1 && workers <= MAX_WORKERS) return workers;
  throw new WorldError('range', `workers: ${workers} is out of range; 1 to ${MAX_WORKERS}`);
}

function asMaterial({ id, name, colour: [red, green, blue], kind }: WorldMaterial): Material {
  return { id, name, colour: (red << 16) | (green << 8) | blue, phase: kind === 'air' ? 'gas' : kind === 'water' ? 'liquid' : 'solid' };
}
