// Worlds and their chunks made here, by WebAssembly: the voxels that a server of the same world sends, to the bit. Works in
// browsers and Node, without SharedArrayBuffer and eval; a Content-Security-Policy needs 'wasm-unsafe-eval' in script-src.
// Axes and units are those of ../src/types.ts.

/** Whether WebAssembly has vectors of 128 bits here, which all browsers since 2023 have. */
export function hasSimd(): boolean;

/** The package's module, compiled once: for OpenOptions.module of instances in other workers. */
export function compiledModule(simd?: boolean): Promise<WebAssembly.Module>;

export interface OpenOptions {
  /** Files that the world names: height maps as .npy, models as .vox. */
  files?: Record<string, Uint8Array>;
  /** The most memory that the world may take, 8 MiB to 4 GiB; 1 GiB unless told otherwise. */
  memoryBytes?: number;
  /** Of it for ground that neighbouring chunks share; 32 MiB unless told otherwise. */
  groundBytes?: number;
  /** By vectors; hasSimd() unless told otherwise. Voxels are the same without, and take three times as long. */
  simd?: boolean;
  /** Instead of the package's .wasm beside this file, for bundlers that put it elsewhere. */
  module?: WebAssembly.Module | Uint8Array | ArrayBuffer;
}

export interface ChunkKey {
  /** 0, base voxels, unless told otherwise, to 6. */
  lod?: number;
  x: number;
  y: number;
  z: number;
}

/** Columns of a level. */
export interface Area {
  lod?: number;
  x: number;
  z: number;
  width: number;
  depth: number;
}

/** What a chunk is asked for; voxels alone unless told otherwise. */
export interface Wanted {
  voxels?: boolean;
  payload?: boolean;
  hash?: boolean;
}

export interface Voxel {
  x: number;
  y: number;
  z: number;
}

export interface VoxelWrite {
  voxel: Voxel;
  material: number;
}

export interface WorldMaterial {
  id: number;
  name: string;
  colour: [number, number, number];
  kind: 'air' | 'water' | 'stratified' | 'eroded';
}

export interface MadeChunk {
  /** 32,768 materials, index (y * 32 + z) * 32 + x. null: all are `uniform`, or they were not asked for. */
  voxels: Uint16Array | null;
  uniform: number | null;
  /** As a server encodes it. */
  payload: Uint8Array | null;
  /** Of the voxels, 32 digits; zeros if not asked for. */
  hash: string;
}

export type WorldErrorKind =
  | 'spec' // the world file; `line`, `column` and `key` say where
  | 'range' // an argument
  | 'conflict' // edit()
  | 'bad_chunk' // decode()
  | 'out_of_memory' // memoryBytes; ends the world
  | 'broken' // ends the world
  | 'closed';

export class WorldError extends Error {
  readonly kind: WorldErrorKind;
  /** From 1; 0: unknown. */
  readonly line: number;
  readonly column: number;
  readonly key: string;
  constructor(kind: WorldErrorKind, message: string, place?: { line?: number; column?: number; key?: string; cause?: unknown });
}

/** Every call but open() blocks until it is done: use it in a worker. An instance has one world and memory of its own. */
export class World {
  /** Rejects with a WorldError. */
  static open(toml: string | Uint8Array, options?: OpenOptions): Promise<World>;
  private constructor();

  readonly fingerprint: string;
  readonly generatorVersion: number;
  readonly codecVersion: number;
  /** Base rows that hold everything but rock and air. */
  readonly heightRange: { low: number; high: number };
  /** By id. */
  readonly materials: readonly WorldMaterial[];
  /** Only for edits. Their ids are those of this module, not of a server. */
  readonly placeables: readonly WorldMaterial[];
  /** 'wasm128' or 'scalar'. */
  readonly instructionSet: string;
  readonly memoryBytes: number;

  /** The voxels of a chunk. Those of 4 x 4 columns of chunks share most of the work: ask for them one after another. */
  generate(key: ChunkKey, wanted?: Wanted): MadeChunk;
  /** Makes columns of chunks (x, z, width and depth count chunks) for the calls of generate() that follow. */
  prepare(tiles: Area): void;
  /** Chunk rows outside `first` to `last` are uniform: `below` under them, air above. */
  rows(column: { lod?: number; x: number; z: number }): { first: number; last: number; below: number };
  /**
   * Changes voxels, whole or not at all, as a server would (types.ts, Edit): from now on generate() has the changes, at
   * every level. They are kept in memory alone. Throws kind 'conflict' if a guard does not hold.
   */
  edit(edit: {
    guards?: readonly VoxelWrite[];
    writes?: readonly VoxelWrite[];
    fills?: readonly { first: Voxel; last: Voxel; material: number | 'generated'; only?: number }[];
  }): { changed: number; chunks: Required<ChunkKey>[] };
  /** All edits of a chunk of level 0, as bytes of core/edits/FORMAT.md, "Runs". */
  overrides(chunk: { x: number; y: number; z: number }): Uint8Array;
  /** Replaces them; returns the chunks of all levels that may have changed. Throws kind 'range' if the bytes are no such
   *  runs, or have a material that this world has not. */
  restore(chunk: { x: number; y: number; z: number }, runs: Uint8Array): Required<ChunkKey>[];
  /** The base voxel for a player's feet, as a server of this world has it: some tenths of a second of work. */
  spawn(): Voxel;
  /** The ground of columns in 1/256 voxel, z slowest: the top of solid material without objects. At most 2,048 a side. */
  heights(columns: Area): Int32Array;
  /** A tile of the map as talusd paints it: 256 x 256 pixels of red, green and blue. */
  map(tile: { zoom: number; x: number; z: number }): Uint8Array;
  /** A chunk that a server sent. */
  decode(payload: Uint8Array, wanted?: Wanted): MadeChunk;
  /** XXH3-128 of any bytes, which all hashes of Talus are. */
  hash(bytes: Uint8Array): string;
  /** Frees its memory. */
  close(): void;
}
