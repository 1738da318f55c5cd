// Talus in browsers and Node. README.md begins with an example.
import type { Client, ConnectOptions } from './types.js';

export { CHUNK_SIZE, CHUNK_VOLUME, decodeChunk, DecodeError, type DecodeFault } from './decode.js';
export { hashVoxels } from './hash.js';
export { TalusError, type TalusErrorKind } from './errors.js';
export type * from './types.js';

/** Connects, and joins; see ConnectOptions.url for which way. */
export declare function connect(options: ConnectOptions): Client;
