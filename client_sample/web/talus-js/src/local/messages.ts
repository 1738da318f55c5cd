// Messages between a World and its workers.
import type { Voxel, Wanted, World as Module, WorldErrorKind, WorldMaterial } from '../../wasm/world.js';

/** What World.open() of ../../wasm/world.js takes. */
export interface OpenMessage {
  readonly toml: Uint8Array;
  readonly files: Record<string, Uint8Array>;
  readonly module: WebAssembly.Module;
  readonly memoryBytes: number;
  readonly groundBytes: number;
}

/** Facts about an open world. */
export interface About {
  readonly fingerprint: string;
  readonly generatorVersion: number;
  readonly codecVersion: number;
  readonly heightRange: { readonly low: number; readonly high: number };
  readonly materials: readonly WorldMaterial[];
  readonly placeables: readonly WorldMaterial[];
  readonly instructionSet: string;
}

/** The overrides of a chunk of level 0: core/edits/FORMAT.md, "Runs". Without bytes it is as generated. */
export interface EditedChunk {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly runs: Uint8Array<ArrayBuffer>;
}

export interface Key {
  readonly lod: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** Rows of columns of chunks, one level's: x, z, first and last row of each. */
export interface Columns {
  readonly lod: number;
  readonly columns: Int32Array<ArrayBuffer>;
}

/** Chunks, row by row of one column after another. */
export interface MadeColumns {
  /** Of each chunk: the material of a uniform one, else minus the size of its payload. */
  readonly what: Int32Array<ArrayBuffer>;
  readonly payloads: Uint8Array<ArrayBuffer>;
}

export interface EditMade {
  readonly changed: number;
  /** Of all levels. */
  readonly chunks: readonly Key[];
  /** Those of level 0. */
  readonly rows: readonly EditedChunk[];
}

/** Calls that a worker answers. */
export interface Calls {
  open(message: OpenMessage): About;
  spawn(): Voxel;
  columns(columns: Columns): MadeColumns;
  generate(key: Key, wanted: Wanted): ReturnType<Module['generate']>;
  heights(...area: Parameters<Module['heights']>): Int32Array;
  map(...tile: Parameters<Module['map']>): Uint8Array;
  edit(...edit: Parameters<Module['edit']>): EditMade;
  restore(rows: readonly EditedChunk[]): readonly Key[];
}
export type CallName = keyof Calls;

export interface Call {
  readonly id: number;
  readonly name: CallName;
  readonly args: readonly unknown[];
}

export interface Failure {
  readonly kind: WorldErrorKind;
  readonly message: string;
  readonly line: number;
  readonly column: number;
  readonly key: string;
}

export type Answer = { readonly id: number; readonly result: unknown } | { readonly id: number; readonly failure: Failure };
