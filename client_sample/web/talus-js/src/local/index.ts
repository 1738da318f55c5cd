// Worlds made here, and sources of their chunks: README.md, "Worlds without a server".
import { LocalSource, type SourceOptions } from './source.js';
import type { Client } from '../types.js';
import type { World } from './world.js';

export { workersFor, World, WorldError, type MadeChunk, type OpenOptions, type Wanted } from './world.js';
export { IndexedDbEdits } from './indexed_db_edits.js';
export type { EditedChunk, EditStore } from './edit_store.js';
export type { SourceOptions } from './source.js';

/** Chunks of a world made here by the interface of connect(): setView(), the event `chunk`, edit(). Its close() leaves
 *  the World open. */
export function source(world: World, options: SourceOptions = {}): Client {
  return new LocalSource(world, options);
}
