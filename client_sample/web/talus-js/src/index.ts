// Talus in browsers and Node. README.md begins with an example.
import type { Client, ConnectOptions } from './types.js';

export { TalusError, type TalusErrorKind } from './errors.js';
export type * from './types.js';

/** Connects, and joins; see ConnectOptions.url for which way. */
export declare function connect(options: ConnectOptions): Client;
