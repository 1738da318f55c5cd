// Edits of a world made here: one after another, each kept before it is answered.
import { TalusError } from '../errors.js';
import type { Edit, EditDone } from '../types.js';
import type { EditedChunk, EditStore } from './edit_store.js';
import type { Key } from './messages.js';
import type { World } from './world.js';

export interface EditEvents {
  changed(chunks: readonly Key[], revision: bigint): void;
  /** From now on edits are kept in memory alone. */
  notKept(error: TalusError): void;
}

/** Others save between any two attempts only if they edit without a pause. */
const MAX_ATTEMPTS = 16;

export class EditQueue {
  /** Revisions of another queue are not comparable. */
  readonly storeId = [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, '0')).join('');
  private store: EditStore | null = null;
  private ended = false;
  private revision = 0;
  private last: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly world: World,
    private readonly opening: EditStore | Promise<EditStore> | null,
    private readonly events: EditEvents,
  ) {
    Promise.resolve(opening).catch(() => {}); // begin() reports it
  }

  /** Reads what is kept. */
  async begin(): Promise<void> {
    try {
      this.store = await this.opening;
      if (this.ended) return this.end();
      this.store?.watch?.(() => void this.follow());
      await this.follow();
    } catch (error) {
      this.giveUp(error as Error);
    }
  }

  edit(edit: Edit): Promise<EditDone> {
    return this.next(() => this.apply(edit));
  }

  end(): void {
    this.ended = true;
    this.store?.close();
    this.store = null;
  }

  private next<T>(step: () => Promise<T>): Promise<T> {
    const done = this.last.then(step);
    this.last = done.catch(() => {});
    return done;
  }

  private async apply(edit: Edit): Promise<EditDone> {
    for (let attempt = 1; attempt <= MAX_ATTEMPTS; ++attempt) {
      const touched = await this.world.edit(edit);
      const { changed, chunks, rows, before } = touched;
      if (changed === 0) return { revision: BigInt(this.revision), changed };
      if (!(await this.keep(rows))) {
        // Another page was faster: this edit happens on what it left.
        this.events.changed(await this.world.restore(before), BigInt(this.revision));
        await this.catchUp();
        continue;
      }
      ++this.revision;
      this.events.changed(chunks, BigInt(this.revision));
      return { revision: BigInt(this.revision), changed };
    }
    throw new TalusError('not_applied', 'other pages change this world all the time; retry later');
  }

  private async keep(rows: readonly EditedChunk[]): Promise<boolean> {
    if (this.store === null) return true;
    try {
      return await this.store.save(this.revision, rows);
    } catch (error) {
      this.giveUp(error as Error);
      return true;
    }
  }

  private async catchUp(): Promise<void> {
    if (this.store === null) return;
    const { revision, rows } = await this.store.load(this.revision);
    if (revision === this.revision && rows.length === 0) return;
    const chunks = await this.world.restore(rows);
    this.revision = revision;
    this.events.changed(chunks, BigInt(revision));
  }

  private follow(): Promise<void> {
    return this.next(() => this.catchUp()).catch((error: Error) => this.giveUp(error));
  }

  private giveUp(error: Error): void {
    if (this.ended) return;
    this.end();
    this.events.notKept(new TalusError('not_kept', `edits last until the page is closed: ${error.message}`));
  }
}
