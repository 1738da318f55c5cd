// Where a source keeps its edits: in memory, or in what an application gives, such as IndexedDbEdits.
import type { EditedChunk } from './messages.js';

export type { EditedChunk };

/** Edits of one world. Revisions start at 0 and grow by one with each save(). */
export interface EditStore {
  /** The revision, and the chunks saved after `since`. */
  load(since: number): Promise<{ readonly revision: number; readonly rows: readonly EditedChunk[] }>;
  /** Keeps all `rows` or none, each in the place of the chunk's row before, as revision `before + 1`. Resolves with
   *  false, and keeps nothing, if the revision is not `before`: somebody else saved. */
  save(before: number, rows: readonly EditedChunk[]): Promise<boolean>;
  /** Calls `handler` when somebody else has saved. */
  watch?(handler: () => void): void;
  close(): void;
}
