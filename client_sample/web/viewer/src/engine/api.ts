// The engine's interface. Lengths are base voxels ("blocks"); axes are x east, y up, z south. yaw 0 looks north (-z)
// and increases towards the east; pitch is upwards; both in radians.
import type { Client, World } from 'talus';

export interface EngineOptions {
  readonly canvas: HTMLCanvasElement;
  /** Origin of the server's HTTP port, such as location.origin; determines the WebSocket's address. */
  readonly url: string;
  readonly transport: 'websocket' | 'http';
  /** Gives the chunks in place of a server at `url`. */
  readonly source?: () => Client;
  readonly token?: string;
  /** Level 0, in chunks. */
  readonly radius: number;
  /** Extent of coarser levels, in blocks. */
  readonly horizon: number;
  readonly quality: 'low' | 'high';
  /** No swaying or flowing: waves, clouds and fading stand still. */
  readonly reducedMotion: boolean;
  /** Seconds at which all animation is frozen, for reproducible pictures; absent: real time. */
  readonly frozenTime?: number;
}

export interface WorldInfo extends World {
  /** Height of the sea's surface, as far as seen; null: no water so far. */
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
  /** Outward normal of the face hit; zero if the ray began inside. */
  readonly normal: Vector;
}

/** A box drawn around voxels, `first` to `last`, both included. */
export interface Marker {
  readonly first: Vector;
  readonly last: Vector;
  /** 0xRRGGBB: colour of its veil, and of its edges. */
  readonly colour: number;
  readonly edge: number;
  /** Opacity of the veil, 0 to 1. */
  readonly veil: number;
}

/** A vertical plane through (x, z) that cuts the land open. Land on the side of the normal, (sin yaw, -cos yaw), is not
 *  drawn: yaw is the direction of a viewer behind the cut who looks out of it. */
export interface Slice {
  readonly x: number;
  readonly z: number;
  readonly yaw: number;
}

export type EngineState =
  | 'connecting'
  | 'streaming'
  | 'complete' // every chunk of the View is on the GPU or known to be empty
  | 'lost' // the connection broke; it returns by itself
  | 'refused'; // permanently, until setToken() or reconnect()

/** Current values. `latency`, `nearestMissing` and `frameCpu` are expensive and computed at each reading: copy them to
 *  compare later. */
export interface Stats {
  readonly state: EngineState;
  /** Chunks of the current View that are held, including uniform ones. */
  readonly chunks: number;
  /** The same by level. */
  readonly chunksPerLevel: readonly number[];
  /** Chunks of the current View. */
  readonly chunksWanted: number;
  /** Chunks received that wait for a worker, or are with one. */
  readonly pendingMeshes: number;
  readonly meshes: number;
  /** The last frame shows everything received: no mesh was added or removed since. */
  readonly current: boolean;
  /** In the last frame, including shadow passes. */
  readonly triangles: number;
  readonly drawCalls: number;
  readonly receivedBytes: number;
  /** Since the connection began: chunks made in this page, and chunks that came from the server. */
  readonly madeChunks: number;
  readonly receivedChunks: number;
  /** Time from a chunk's arrival to its upload to the GPU, including waiting for neighbours; over the last 1,024. */
  readonly latency: { readonly p50: number; readonly p95: number; readonly p99: number } | null;
  /** Chunks per second, over the last second. */
  readonly chunkRate: number;
  /** Distance in blocks to the nearest column of chunks not drawn yet; null: none is missing. */
  readonly nearestMissing: number | null;
  /** Bytes of mesh data on the GPU, and of payloads and voxels held by the engine and its workers. */
  readonly gpuBytes: number;
  readonly heapBytes: number;
  /** Main-thread time in frame(), in milliseconds, over the last 256 frames. */
  readonly frameCpu: { readonly p50: number; readonly p95: number };
  /** Mean time to mesh a chunk in the workers, in milliseconds. */
  readonly meshMs: number;
  /** Something was drawn: land, or only the sky if no land came in sight. */
  readonly hasPicture: boolean;
  /** Time of the first frame with land, since the engine was created. */
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
