// Public types. Axes: x east, y up, z south. The unit of length is the base voxel; a chunk has 32 x 32 x 32 voxels of
// one level of detail, and a voxel of level l spans 2^l base voxels along each axis.
import type { Edit, EditDone, EditLimits } from './edits/types.js';
import type { TalusError } from './errors.js';

export type { Edit, EditDone, EditLimits, Fill, Paste, VoxelWrite } from './edits/types.js';

/** A chunk. Coordinates are in chunks of its level. */
export interface ChunkKey {
  readonly lod: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface Position {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** Chunks of a coarser level around the View, out to `radius` base chunks. */
export interface LodRing {
  readonly lod: number;
  readonly radius: number;
}

/** The chunks that a player wants around it. */
export interface View {
  /** Base voxels; fractions are rounded down. */
  readonly centre: Position;
  /** Need not be normalised: chunks along it come first. Absent or zero: no preference. */
  readonly direction?: Position;
  /** Chunks of level 0 around the chunk that holds the centre. */
  readonly horizontalRadius: number;
  readonly verticalRadius: number;
  /** Ascending levels and radii. */
  readonly rings?: readonly LodRing[];
  /** Rings cover every row in which the world's ground can lie; requires `limits.viewHorizon`. */
  readonly horizon?: boolean;
}

export type Phase = 'gas' | 'liquid' | 'solid';

export interface Material {
  readonly id: number;
  readonly name: string;
  /** 0xRRGGBB */
  readonly colour: number;
  readonly phase: Phase;
}

/** Rates that a server grants per second, enforced by token buckets; 0: unlimited. */
export interface Rates {
  readonly chunks: number;
  readonly bytes: number;
  readonly requests: number;
  readonly burstMs: number;
}

export interface Limits {
  readonly frameBytes: number;
  readonly requestsInFlight: number;
  readonly heightsPerRequest: number;
  readonly viewHorizontalRadius: number;
  readonly viewVerticalRadius: number;
  /** All levels of one View together. */
  readonly viewChunks: number;
  readonly windowBytes: number;
  readonly idleTimeoutMs: number;
  readonly sessionRates: Rates | null;
  readonly addressRates: Rates | null;
  readonly viewHorizon: boolean;
  /** The world is published: chunks can be made here (ConnectOptions.generate). */
  readonly viewBase: boolean;
}

/** The server's description of its world. */
export interface World {
  /** Negotiated version of the stream; 0 over HTTP. */
  readonly protocol: number;
  /** 32 hexadecimal digits; equal fingerprints: equal voxels everywhere. */
  readonly fingerprint: string;
  /** Revisions are comparable if store ids are equal; 32 zeros: nothing is stored, so edits are impossible. */
  readonly storeId: string;
  readonly codec: number;
  readonly materials: readonly Material[];
  /** Base rows: below minY all voxels are one rock, from maxY up all are air. */
  readonly minY: number;
  readonly maxY: number;
  /** The base voxel for a player's feet. */
  readonly spawn: Position;
  readonly limits: Limits;
  readonly server: string;
  readonly looks: readonly string[];
  readonly fields: readonly string[];
  /** Path of the world's file by HTTP; empty: it is not published. */
  readonly worldFile: string;
}

/** A chunk as received: not decoded, so that the application chooses where to do that. */
export interface Chunk {
  readonly key: ChunkKey;
  /** 0n: as generated; increases with each change. Over HTTP it may be the revision of the chunk's whole column. */
  readonly revision: bigint;
  /** XXH3-128 of the voxels, 32 hexadecimal digits, for decodeChunk(); null if unknown (HTTP, and uniform chunks). */
  readonly hash: string | null;
  /** For decodeChunk(). The bytes own their ArrayBuffer, which may be transferred to a worker. */
  readonly payload: Uint8Array<ArrayBuffer>;
  /** The material of a chunk that is known to be uniform without decoding; otherwise null. */
  readonly material: number | null;
}

/** Voxels of a chunk, 32 x 32 x 32; voxel (x, y, z) is at index (y * 32 + z) * 32 + x. */
export type Voxels =
  | { readonly uniform: number; readonly voxels: null }
  | { readonly uniform: null; readonly voxels: Uint16Array<ArrayBuffer> };

/** Data of columns of base voxels, in the order of the request. */
export interface Places {
  /** Height of the ground in 1/256 base voxel above y = 0. */
  readonly heightsFx: Int32Array;
  /** Indexes into World.looks; null if not requested. */
  readonly looks: Uint8Array | null;
  /** Values of all fields of a column, then of the next; null if not requested. */
  readonly values: Float32Array | null;
}

/** Totals since the client was created. */
export interface Stats {
  readonly chunks: number;
  /** Of them those made here. */
  readonly madeChunks: number;
  /** Of those made here that were compared with the server's. */
  readonly proofs: number;
  readonly uniformChunks: number;
  /** Chunks of a View that were already held and not sent again. */
  readonly unchangedChunks: number;
  readonly receivedBytes: number;
  readonly sentBytes: number;
  readonly chunkBytes: number;
  readonly connections: number;
  /** HTTP requests made. */
  readonly requests: number;
  /** Of the last ping or HTTP request; null before the first. */
  readonly latencyMs: number | null;
  /** From setView() to the first chunk, and to the complete View; null: not yet. */
  readonly firstChunkMs: number | null;
  readonly viewCompleteMs: number | null;
}

export interface ClientEvents {
  /** The client joined, for the first time or again. If `sameWorld` is false, chunkLeft was emitted for all chunks held
   *  before. */
  connected: (world: World, sameWorld: boolean) => void;
  /** A chunk of the current View arrived or changed. */
  chunk: (chunk: Chunk) => void;
  /** A chunk delivered by `chunk` left the View and will no longer be updated. */
  chunkLeft: (key: ChunkKey) => void;
  /** Every chunk of the View arrived, except any reported by `error`. */
  viewComplete: (view: View) => void;
  /** The connection broke. `retryInMs`: delay until the next attempt; null: no attempt, `closed` follows. */
  disconnected: (error: TalusError, retryInMs: number | null) => void;
  /** An error that the connection survives. */
  error: (error: TalusError) => void;
  /** The final event: after close() (null), or if further attempts are useless. */
  closed: (error: TalusError | null) => void;
}

export interface ReconnectPolicy {
  /** Consecutive failures until the client gives up; Infinity: never. 0: it does not reconnect. */
  readonly maxAttempts?: number;
  readonly firstDelayMs?: number;
  readonly maxDelayMs?: number;
}

export interface ConnectOptions {
  /** ws:, wss:, http: or https: URL of the server's HTTP port. With http(s), chunks are fetched over HTTP, through any
   *  cache; with ws(s), over the WebSocket /v1/stream. `talus-client/node` also accepts tcp://HOST:PORT and
   *  tls://HOST:PORT. Several URLs, except http(s), are servers of one world: if one cannot be reached, goes away or
   *  disconnects, the next is tried, then around again. One URL is enough if a balancer covers all servers. */
  readonly url: string | readonly string[];
  readonly token?: string;
  /** For the server's log. */
  readonly clientName?: string;
  /** Maximum chunk bytes in flight; default 1 MiB. */
  readonly windowBytes?: number;
  /** Payload bytes kept of chunks that left the View; only their hashes are sent when they return. Default 16 MiB. */
  readonly keepBytes?: number;
  /** True if the application calls Client.taken() when it is done with a chunk, so that the server never sends more
   *  than windowBytes ahead of a slow application. Otherwise chunks count as done at once. */
  readonly manualCredit?: boolean;
  readonly reconnect?: ReconnectPolicy;
  /** Limit for the server's answer to an attempt to connect; default 10 s. */
  readonly connectTimeoutMs?: number;
  /** HTTP: maximum concurrent requests, at most 6, which is the default. */
  readonly requestsAtOnce?: number;
  /** HTTP: interval of asking which columns of the View's regions were edited; default 5,000. Infinity: ask only
   *  once. */
  readonly editsIntervalMs?: number;
  /** Makes chunks here where the server publishes its world, and takes only edits from it; not by tcp: and tls:. `auto`
   *  begins when the first View is complete, `always` at once; default `never`. What cannot be made, or differs from the
   *  server's, is streamed as without, and the event `error` says why, with kind `cannot_generate`. */
  readonly generate?: 'never' | 'auto' | 'always';
  /** An implementation of WebSocket, if there is no global one (Node before 22). */
  readonly WebSocket?: unknown;
  readonly fetch?: typeof fetch;
}

/** The same interface over a stream (WebSocket, TCP) and over HTTP. */
export interface Client {
  /** The server's last description; null until `connected`. */
  readonly world: World | null;
  readonly connected: boolean;
  readonly stats: Stats;

  /** An exception of a handler is reported like any uncaught error; the client and its other handlers continue. */
  on<K extends keyof ClientEvents>(event: K, handler: ClientEvents[K]): this;
  off<K extends keyof ClientEvents>(event: K, handler: ClientEvents[K]): this;

  /** Resolves with the world after joining; rejects if the client gave up. */
  ready(): Promise<World>;

  /** Replaces the View; null: no View. Cheap: call it every frame. Kept until `connected`. Throws a TalusError, and
   *  keeps the previous View, if the View exceeds the server's limits. */
  setView(view: View | null): void;

  /** With manualCredit: call when the application is done with the chunk. */
  taken(chunk: Chunk): void;

  /** Requests a chunk inside or outside the View. */
  getChunk(key: ChunkKey): Promise<Chunk>;

  /** Heights at columns of base voxels, with their looks and values of World.fields on request. */
  getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    wanted?: { readonly looks?: boolean; readonly fields?: readonly string[] },
  ): Promise<Places>;

  /** Changes voxels. Edits are applied in the order of the calls, each once, however often the connection breaks; at
   *  most as many as the server allows are in flight, the rest wait here. An edit that the server refuses temporarily
   *  is sent again, after edits sent meanwhile: if order matters, use guards. Resolves when the edit is stored; changed
   *  chunks of the View arrive by `chunk`, before or after that. Rejects with a TalusError: `conflict`, `out_of_range`,
   *  `not_applied`, `outcome_unknown`; `refused` if the token lacks the right, if the server stores no edits, and over
   *  HTTP. */
  edit(edit: Edit): Promise<EditDone>;

  /** Limits of this client's edits. Rejects like edit(), so call it before offering to edit. */
  editLimits(): Promise<EditLimits>;

  /** Round-trip time in milliseconds. */
  ping(): Promise<number>;

  /** If the connection is lost: makes the next attempt at once. */
  retry(): void;

  close(): void;
}
