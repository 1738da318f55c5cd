// What an application sees of Talus. Axes: x east, y up, z south. The unit of length is the base voxel; a chunk is
// 32 x 32 x 32 voxels of one level of detail, and a voxel of level l spans 2^l base voxels along each axis.
import type { Edit, EditDone, EditLimits } from './edits/types.js';
import type { TalusError } from './errors.js';

export type { Edit, EditDone, EditLimits, Fill, Paste, VoxelWrite } from './edits/types.js';

/** A chunk. Coordinates count chunks of its level. */
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

/** What a player wants to have around it. */
export interface View {
  /** Base voxels; fractions are rounded down. */
  readonly centre: Position;
  /** Of any length: chunks along it come first. Absent or zero: no preference. */
  readonly direction?: Position;
  /** Chunks of level 0 around the chunk that holds the centre. */
  readonly horizontalRadius: number;
  readonly verticalRadius: number;
  /** Levels and radii growing. */
  readonly rings?: readonly LodRing[];
  /** Rings have all rows that the world's ground can lie in; only where `limits.viewHorizon`. */
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

/** What a server grants a second, by token buckets; 0: no limit. */
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
  /** Of all levels in one View. */
  readonly viewChunks: number;
  readonly windowBytes: number;
  readonly idleTimeoutMs: number;
  readonly sessionRates: Rates | null;
  readonly addressRates: Rates | null;
  readonly viewHorizon: boolean;
}

/** What a server tells about its world. */
export interface World {
  /** Of the stream, as agreed; by HTTP 0. */
  readonly protocol: number;
  /** 32 hexadecimal digits; worlds of one fingerprint have equal voxels everywhere. */
  readonly fingerprint: string;
  /** Revisions can be compared within one; 32 zeros: nothing is stored, so nobody edits. */
  readonly storeId: string;
  readonly codec: number;
  readonly materials: readonly Material[];
  /** Base rows: below minY everything is one rock, at and above maxY everything is air. */
  readonly minY: number;
  readonly maxY: number;
  /** The base voxel for a player's feet. */
  readonly spawn: Position;
  readonly limits: Limits;
  readonly server: string;
  readonly looks: readonly string[];
  readonly fields: readonly string[];
}

/** A chunk as it came: not decoded, so that the application decides where to do that. */
export interface Chunk {
  readonly key: ChunkKey;
  /** 0n: as generated; a higher one is newer. By HTTP it may be that of the chunk's whole column. */
  readonly revision: bigint;
  /** XXH3-128 of the voxels, 32 hexadecimal digits, as decodeChunk() checks it; null where the source has none
   *  (HTTP, and uniform chunks). */
  readonly hash: string | null;
  /** For decodeChunk(). The bytes own their ArrayBuffer: it may be transferred to a worker. */
  readonly payload: Uint8Array<ArrayBuffer>;
  /** The one material of a chunk known to be uniform without decoding it; else null. */
  readonly material: number | null;
}

/** Voxels of a chunk, 32 x 32 x 32; that of (x, y, z) is at (y * 32 + z) * 32 + x. */
export type Voxels =
  | { readonly uniform: number; readonly voxels: null }
  | { readonly uniform: null; readonly voxels: Uint16Array<ArrayBuffer> };

/** What there is at columns of base voxels, in the order of the question. */
export interface Places {
  /** Height of the ground in 1/256 base voxel above y = 0. */
  readonly heightsFx: Int32Array;
  /** Places in World.looks; where asked for. */
  readonly looks: Uint8Array | null;
  /** Of each column the values of all fields; where asked for. */
  readonly values: Float32Array | null;
}

/** Running totals since the client was made. */
export interface Stats {
  readonly chunks: number;
  readonly uniformChunks: number;
  /** Of a View, held since before and not sent again. */
  readonly unchangedChunks: number;
  readonly receivedBytes: number;
  readonly sentBytes: number;
  readonly chunkBytes: number;
  readonly connections: number;
  /** HTTP: requests made. */
  readonly requests: number;
  /** Of the last ping or HTTP request; null: none yet. */
  readonly latencyMs: number | null;
  /** From setView() to the first chunk, and to the whole View; null: not yet. */
  readonly firstChunkMs: number | null;
  readonly viewCompleteMs: number | null;
}

export interface ClientEvents {
  /** The client has joined, for the first time or again. Where `sameWorld` is false, chunkLeft told of all chunks
   *  that were held before. */
  connected: (world: World, sameWorld: boolean) => void;
  /** A chunk of the current View has come, or has changed. */
  chunk: (chunk: Chunk) => void;
  /** A chunk that `chunk` delivered is not in the View any more, and will not be kept up to date. */
  chunkLeft: (key: ChunkKey) => void;
  /** Every chunk of the View has come, but for those that `error` told of. */
  viewComplete: (view: View) => void;
  /** The connection broke. `retryInMs` is when the client tries again; null: it does not, and `closed` follows. */
  disconnected: (error: TalusError, retryInMs: number | null) => void;
  /** Something that the connection survives. */
  error: (error: TalusError) => void;
  /** The end, for good: by close() (null), or because no attempt helps. */
  closed: (error: TalusError | null) => void;
}

export interface ReconnectPolicy {
  /** Failures in a row before the client gives up; Infinity: never. 0: it does not reconnect. */
  readonly maxAttempts?: number;
  readonly firstDelayMs?: number;
  readonly maxDelayMs?: number;
}

export interface ConnectOptions {
  /** ws:, wss:, http: or https: of the server's HTTP port. By http(s) chunks come by HTTP, through any cache; by
   *  ws(s) through the socket /v1/stream. `talus-client/node` also takes tcp://HOST:PORT and tls://HOST:PORT.
   *  Several, but for http(s): servers of one world. Where one cannot be reached, goes away or breaks off, the next is
   *  tried, and around again. One is enough where a balancer stands for all. */
  readonly url: string | readonly string[];
  readonly token?: string;
  /** For the server's log. */
  readonly clientName?: string;
  /** Chunk bytes in flight at most; default 1 MiB. */
  readonly windowBytes?: number;
  /** Payloads kept of chunks that left the View, so that only their hashes travel when they return; default 16 MiB. */
  readonly keepBytes?: number;
  /** Whether the application says by Client.taken() when it is done with a chunk; else it is at once. Then the
   *  server never sends more than windowBytes ahead of a slow application. */
  readonly manualCredit?: boolean;
  readonly reconnect?: ReconnectPolicy;
  /** Until the server has answered an attempt to connect; default 10 s. */
  readonly connectTimeoutMs?: number;
  /** HTTP: requests at once, at most 6, which is the default. */
  readonly requestsAtOnce?: number;
  /** HTTP: so often is asked which columns of the View's regions were edited since; default 5,000. Infinity: never
   *  again. */
  readonly editsIntervalMs?: number;
  /** An implementation of WebSocket, where there is no global one (Node before 22). */
  readonly WebSocket?: unknown;
  readonly fetch?: typeof fetch;
}

/** The same over a stream (WebSocket, TCP) and over HTTP. */
export interface Client {
  /** What the server last said; null until `connected`. */
  readonly world: World | null;
  readonly connected: boolean;
  readonly stats: Stats;

  /** What a handler throws is reported as any uncaught error is; the client and its other handlers go on. */
  on<K extends keyof ClientEvents>(event: K, handler: ClientEvents[K]): this;
  off<K extends keyof ClientEvents>(event: K, handler: ClientEvents[K]): this;

  /** Resolves with the world once joined; rejects when the client gave up. */
  ready(): Promise<World>;

  /** In place of the View before; null: none. Cheap: call it every frame. Before `connected` it is kept. Throws a
   *  TalusError where the View is over the server's limits; the View before then stays. */
  setView(view: View | null): void;

  /** With manualCredit: the application is done with the chunk. */
  taken(chunk: Chunk): void;

  /** One chunk, in the View or not. */
  getChunk(key: ChunkKey): Promise<Chunk>;

  /** Heights at columns of base voxels, and their looks and the values of World.fields there. */
  getPlaces(
    columns: readonly { readonly x: number; readonly z: number }[],
    wanted?: { readonly looks?: boolean; readonly fields?: readonly string[] },
  ): Promise<Places>;

  /**
   * Changes voxels. Edits happen in the order of the calls, each once, however often the connection breaks meanwhile; at
   * most as many as the server allows are on their way, the others wait here. One that the server refuses for now is
   * sent again, behind those that were sent since: where order matters, use guards. Resolves when the edit is stored;
   * chunks of the View change by `chunk`, before or after that. Rejects with a TalusError: `conflict`, `out_of_range`,
   * `not_applied`, `outcome_unknown`; `refused` where the token does not give the right, where the server stores no
   * edits, and by HTTP.
   */
  edit(edit: Edit): Promise<EditDone>;

  /** What this client may edit. Rejects as edit() does, so an application may ask before it offers to edit. */
  editLimits(): Promise<EditLimits>;

  /** Round-trip time in milliseconds. */
  ping(): Promise<number>;

  /** Where the connection is lost: tries at once what would be tried later. */
  retry(): void;

  close(): void;
}
