// What the viewer sees of its engine. Lengths are base voxels ("blocks"), axes are x east, y up, z south.
// yaw 0 looks north (-z) and grows toward the east; pitch is up; both in radians.
import type { World } from 'talus';

export interface EngineOptions {
  readonly canvas: HTMLCanvasElement;
  /** Origin of the server's HTTP port, as location.origin; the WebSocket's address follows from it. */
  readonly url: string;
  readonly transport: 'websocket' | 'http';
  readonly token?: string;
  /** Of level 0, in chunks. */
  readonly radius: number;
  /** How far coarser levels reach, in blocks. */
  readonly horizon: number;
  readonly quality: 'low' | 'high';
  /** Nothing sways or flows: waves, clouds and fading stand still. */
  readonly reducedMotion: boolean;
  /** Seconds at which all animation stands, for pictures that are to repeat; absent: real time. */
  readonly frozenTime?: number;
}

export interface WorldInfo extends World {
  /** Of the sea's surface, as far as the engine has seen it; null: no water so far. */
  readonly seaLevel: number | null;
}

export interface Vector {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface Hit {
  /** The voxel. */
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly material: number;
  readonly distance: number;
  /** Outward normal of the face that was hit; zero where the ray began inside. */
  readonly normal: Vector;
}

/** A box that is drawn around voxels, `first` to `last`, both included. */
export interface Marker {
  readonly first: Vector;
  readonly last: Vector;
  /** 0xRRGGBB: of the veil over it, and of its edges. */
  readonly colour: number;
  readonly edge: number;
  /** How thick the veil is, 0 to 1. */
  readonly veil: number;
}

/** A vertical plane through (x, z) that cuts the land open. What lies on the side of the normal,
 *  (sin yaw, -cos yaw), is not drawn: yaw is where somebody looks who stands behind the cut, looking out of it. */
export interface Slice {
  readonly x: number;
  readonly z: number;
  readonly yaw: number;
}

export type EngineState =
  | 'connecting'
  | 'streaming'
  | 'complete' // every chunk of the View is on the GPU or known to be empty
  | 'lost' // the connection broke; it comes back by itself
  | 'refused'; // for good, until setToken() or reconnect()

/** Of the moment, but for `latency`, `nearestMissing` and `frameCpu`: these take long to find and are found anew at each
 *  reading, so whoever compares with later copies them. */
export interface Stats {
  readonly state: EngineState;
  /** Held, of the current View, uniform ones included. */
  readonly chunks: number;
  /** The same, by level. */
  readonly chunksPerLevel: readonly number[];
  /** Chunks that the current View has. */
  readonly chunksWanted: number;
  /** Chunks that are here and wait for a worker, or are with one. */
  readonly pendingMeshes: number;
  readonly meshes: number;
  /** The last frame shows all that is here: no mesh came or went since. */
  readonly current: boolean;
  /** Of the last frame, shadow passes included. */
  readonly triangles: number;
  readonly drawCalls: number;
  readonly receivedBytes: number;
  /** Of a chunk, from its coming to its being on the GPU, its neighbours' coming included; of the last 1,024. */
  readonly latency: { readonly p50: number; readonly p95: number; readonly p99: number } | null;
  /** Chunks a second, over the last second. */
  readonly chunkRate: number;
  /** To the nearest column of chunks that is not drawn yet, in blocks; null: none is missing. */
  readonly nearestMissing: number | null;
  /** Bytes of mesh data on the GPU, and of payloads and voxels that the engine and its workers hold. */
  readonly gpuBytes: number;
  readonly heapBytes: number;
  /** Of main-thread time in frame(), in milliseconds, of the last 256 frames. */
  readonly frameCpu: { readonly p50: number; readonly p95: number };
  /** Mean of meshing a chunk in the workers, in milliseconds. */
  readonly meshMs: number;
  /** Something was drawn: land, or the sky alone where no land came in sight. */
  readonly hasPicture: boolean;
  /** The first frame with land, since the engine was made. */
  readonly firstFrameMs: number | null;
  readonly completeMs: number | null;
}

export interface EngineEvents {
  state: (state: EngineState, reason: string) => void;
  world: (world: WorldInfo, same: boolean) => void;
  error: (message: string) => void;
  contextLost: () => void;
  contextRestored: () => void;
}
