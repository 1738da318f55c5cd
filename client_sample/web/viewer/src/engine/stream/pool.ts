// The meshing workers. Each owns squares of 8 x 8 columns of chunks, and holds their chunks and the adjacent ones.
import type { Chunk } from './column.js';
import type { Meshers } from './land.js';
import { ChangeList } from './changes.js';
import type { FromWorker, Job, ToWorker } from './messages.js';

const SQUARE = 3; // 2^3 columns
const JOBS_AT_ONCE = 6;

interface Crew {
  readonly worker: Worker;
  jobs: number;
  readonly changes: ChangeList;
  orders: Job[];
  heldBytes: number;
}

export const workersFor = (cores: number): number => Math.min(4, Math.max(2, cores - 1));

export class Pool implements Meshers {
  private readonly crews: Crew[];
  private readonly ownerOfJob = new Map<number, Crew>();
  private meshMs = 0;
  private meshes = 0;

  constructor(
    workers: number,
    makeWorker: () => Worker,
    private readonly handle: (answer: FromWorker) => void,
    /** A worker could not be started, or ended: its results will never arrive. */
    private readonly broken: (text: string) => void,
  ) {
    this.crews = Array.from({ length: workers }, () => {
      const crew: Crew = { worker: makeWorker(), jobs: 0, changes: new ChangeList(), orders: [], heldBytes: 0 };
      crew.worker.onmessage = (event: MessageEvent<FromWorker>) => this.answered(crew, event.data);
      crew.worker.onerror = ({ message }) => this.broken(message || 'it did not start');
      crew.worker.onmessageerror = () => this.broken('a message that cannot be read');
      return crew;
    });
  }

  get heldBytes(): number {
    return this.crews.reduce((sum, crew) => sum + crew.heldBytes, 0);
  }

  get meanMs(): number {
    return this.meshes === 0 ? 0 : this.meshMs / this.meshes;
  }

  setWorld(kinds: Uint8Array, places: Uint16Array): void {
    for (const crew of this.crews) this.post(crew, { kind: 'world', kinds, places });
  }

  send(chunk: Chunk): void {
    for (const crew of this.holdersOf(chunk)) crew.changes.add(chunk);
  }

  drop(chunk: Chunk): void {
    for (const crew of this.holdersOf(chunk)) crew.changes.drop(chunk);
  }

  hasRoom(chunk: Chunk): boolean {
    return this.ownerOf(chunk.lod, chunk.x, chunk.z).jobs < JOBS_AT_ONCE;
  }

  mesh(chunk: Chunk, job: Job): void {
    const crew = this.ownerOf(chunk.lod, chunk.x, chunk.z);
    crew.jobs++;
    crew.orders.push(job);
    this.ownerOfJob.set(job.id, crew);
  }

  /** Sends the collected changes and jobs. */
  flush(): void {
    for (const crew of this.crews) this.flushCrew(crew);
  }

  dispose(): void {
    for (const crew of this.crews) crew.worker.terminate();
  }

  private flushCrew(crew: Crew): void {
    if (crew.changes.isEmpty && crew.orders.length === 0) return;
    const changes = crew.changes.isEmpty ? null : crew.changes.take();
    const transfer = changes === null ? [] : [changes.table.buffer, changes.payloads.buffer];
    this.post(crew, { kind: 'work', changes, jobs: crew.orders.splice(0) }, transfer);
  }

  private post(crew: Crew, message: ToWorker, transfer: Transferable[] = []): void {
    crew.worker.postMessage(message, transfer);
  }

  private ownerOf(lod: number, x: number, z: number): Crew {
    const count = this.crews.length;
    const square = (x >> SQUARE) + (z >> SQUARE) + lod;
    return this.crews[((square % count) + count) % count]!;
  }

  /** Each worker once. Most columns, with their neighbours, lie in squares of one worker. */
  private holdersOf({ lod, x, z }: Chunk): Iterable<Crew> {
    const inner = (at: number) => (at + 1) >> SQUARE === (at - 1) >> SQUARE;
    if (inner(x) && inner(z)) return [this.ownerOf(lod, x, z)];
    const holders = new Set<Crew>();
    for (let dz = -1; dz <= 1; dz++) for (let dx = -1; dx <= 1; dx++) holders.add(this.ownerOf(lod, x + dx, z + dz));
    return holders;
  }

  private answered(crew: Crew, answer: FromWorker): void {
    if (this.ownerOfJob.delete(answer.id)) crew.jobs--;
    if (answer.kind === 'meshed') {
      this.meshMs += answer.ms;
      this.meshes++;
      crew.heldBytes = answer.heldBytes;
    }
    this.handle(answer);
  }
}
