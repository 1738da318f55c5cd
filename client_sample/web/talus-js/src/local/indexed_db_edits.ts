// Edits kept by the browser. A row is the overrides of a chunk of level 0 (core/edits/FORMAT.md, "Runs"). A world is
// known by its fingerprint, its generator version and the names of its materials: with others the numbers in the rows
// would mean something else, so another world begins without edits, and leaves the rows of this one alone.
import type { EditedChunk, EditStore } from './edit_store.js';
import type { World } from './world.js';

const DATABASE = 'talus.edits';
const VERSION = 1;

interface WorldRow {
  readonly id?: number;
  readonly fingerprint: string;
  readonly generatorVersion: number;
  readonly names: readonly string[];
  readonly revision: number;
}

interface ChunkRow extends EditedChunk {
  readonly world: number;
  readonly revision: number;
}

const asked = <T>(request: IDBRequest<T>) =>
  new Promise<T>((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error!);
  });

const finished = (transaction: IDBTransaction) =>
  new Promise<void>((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error ?? new DOMException('the browser stopped it', 'AbortError'));
  });

function openDatabase(): Promise<IDBDatabase> {
  const request = indexedDB.open(DATABASE, VERSION);
  request.onupgradeneeded = () => {
    request.result.createObjectStore('worlds', { keyPath: 'id', autoIncrement: true }).createIndex('fingerprint', 'fingerprint');
    request.result.createObjectStore('chunks', { keyPath: ['world', 'x', 'y', 'z'] }).createIndex('revision', ['world', 'revision']);
  };
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error!);
    request.onblocked = () => reject(new DOMException('another page holds an older store of edits open; close it', 'AbortError'));
  });
}

export class IndexedDbEdits implements EditStore {
  private readonly channel: BroadcastChannel | null;
  private readonly key: IDBKeyRange;

  /** Rejects with a DOMException if the browser keeps nothing for this page. */
  static async open(world: World): Promise<IndexedDbEdits> {
    const database = await openDatabase();
    const { fingerprint, generatorVersion } = world;
    const names = world.materials.map(({ id, name }) => `${id} ${name}`);
    const transaction = database.transaction('worlds', 'readwrite');
    const worlds = transaction.objectStore('worlds');
    const known = (await asked(worlds.index('fingerprint').getAll(fingerprint))) as WorldRow[];
    const same = known.find((row) => row.generatorVersion === generatorVersion && row.names.join('\n') === names.join('\n'));
    const id = same?.id ?? ((await asked(worlds.add({ fingerprint, generatorVersion, names, revision: 0 }))) as number);
    await finished(transaction);
    return new IndexedDbEdits(database, id);
  }

  private constructor(
    private readonly database: IDBDatabase,
    private readonly id: number,
  ) {
    this.key = IDBKeyRange.only(id);
    this.channel = typeof BroadcastChannel === 'function' ? new BroadcastChannel(`${DATABASE}/${id}`) : null;
    (this.channel as { unref?: () => void } | null)?.unref?.();
    database.onversionchange = () => database.close();
  }

  async load(since: number): Promise<{ revision: number; rows: EditedChunk[] }> {
    const transaction = this.database.transaction(['worlds', 'chunks']);
    const world = (await asked(transaction.objectStore('worlds').get(this.key))) as WorldRow | undefined;
    const newer = IDBKeyRange.bound([this.id, since], [this.id, Infinity], true);
    const rows = (await asked(transaction.objectStore('chunks').index('revision').getAll(newer))) as ChunkRow[];
    return { revision: world?.revision ?? 0, rows };
  }

  async save(before: number, rows: readonly EditedChunk[]): Promise<boolean> {
    const transaction = this.database.transaction(['worlds', 'chunks'], 'readwrite');
    const done = finished(transaction);
    done.catch(() => {});
    const worlds = transaction.objectStore('worlds');
    const world = (await asked(worlds.get(this.key))) as WorldRow | undefined;
    if (world === undefined) throw new DOMException('the edits of this world were deleted', 'NotFoundError');
    if (world.revision !== before) {
      await done;
      return false;
    }
    const revision = before + 1;
    const chunks = transaction.objectStore('chunks');
    try {
      for (const { x, y, z, runs } of rows) chunks.put({ world: this.id, x, y, z, runs, revision } satisfies ChunkRow);
      worlds.put({ ...world, revision });
    } catch (error) {
      transaction.abort(); // or it would keep some of them
      throw error;
    }
    await done;
    this.channel?.postMessage(revision);
    return true;
  }

  watch(handler: () => void): void {
    if (this.channel !== null) this.channel.onmessage = handler;
  }

  close(): void {
    this.channel?.close();
    this.database.close();
  }
}
