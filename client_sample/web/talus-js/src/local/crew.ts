// The workers of a world: who does what next. Calls of generate() come first, then what suppliers have.
import { WorldError } from '../../wasm/world.js';
import type { About, Call, CallName, Calls, EditedChunk, OpenMessage } from './messages.js';
import { startWorker, type WorkerThread } from './worker_thread.js';

/** What a worker has at once: one that it makes, and one that waits, so that it never idles. */
const JOBS_AT_ONCE = 2;
const MAX_STARTS = 3;

export interface Job<K extends CallName = CallName> {
  readonly name: K;
  readonly args: Parameters<Calls[K]>;
  /** Jobs of one place share work, so one worker does them. */
  readonly place: string;
  done(result: ReturnType<Calls[K]>): void;
  failed(error: WorldError): void;
}

/** Has jobs when a worker has time. */
export interface Supplier {
  next(): Job | null;
  /** No worker is left, and none starts again. What it has under way fails after this. */
  lost(error: WorldError): void;
}

class Hand {
  thread: WorkerThread | null = null;
  about: Promise<About>;
  readonly open = new Map<number, Job>();
  place = '';
  starts = 0;
  private ids = 0;
  private started: WorkerThread | null = null;
  private ended = false;
  private isLetGo = false;
  private hasOpened = false;

  constructor(
    private readonly message: OpenMessage,
    private readonly make: (() => Worker) | undefined,
    private readonly rows: () => readonly EditedChunk[],
    private readonly free: () => void,
    /** It ends for good, before what it had fails; null: it was let go. */
    private readonly lost: (hand: Hand, error: WorldError | null) => void,
  ) {
    this.about = this.start();
    this.about.catch(() => {});
  }

  get isFree(): boolean {
    return this.thread !== null && !this.isLetGo && this.open.size < JOBS_AT_ONCE;
  }

  get isOver(): boolean {
    return this.ended || this.isLetGo;
  }

  give(job: Job): void {
    const call: Call = { id: ++this.ids, name: job.name, args: job.args };
    this.open.set(call.id, job);
    if (job.place !== '') this.place = job.place;
    this.thread!.await(true);
    this.thread!.post(call);
  }

  /** Ends when it has done what it has. */
  letGo(): void {
    this.isLetGo = true;
    this.endIfDone();
  }

  private endIfDone(): void {
    if (!this.isLetGo || this.ended || this.thread === null || this.open.size > 0) return;
    this.lost(this, null);
    this.end(new WorldError('closed', 'this worker was let go'));
  }

  end(error: WorldError): void {
    this.ended = true;
    this.started?.end();
    this.thread = null;
    this.failAll(error);
  }

  private async start(): Promise<About> {
    ++this.starts;
    const about = await new Promise<About>((resolve, reject) => {
      const events = {
        answered: (answer: Parameters<Parameters<typeof startWorker>[0]['answered']>[0]) => {
          if (this.ended) return;
          const job = this.open.get(answer.id);
          if (job === undefined) return;
          this.open.delete(answer.id);
          if ('result' in answer) job.done(answer.result as never);
          else this.refused(job, new WorldError(answer.failure.kind, answer.failure.message, answer.failure));
          this.free();
          this.thread?.await(this.open.size > 0);
          this.endIfDone();
        },
        failed: (why: string) => {
          if (this.ended) return;
          const error = new WorldError('broken', `a worker that makes the world ended: ${why}`);
          reject(error);
          this.restart(error);
        },
      };
      startWorker(events, this.make).then((started) => {
        this.started = started;
        if (this.ended) {
          reject(new WorldError('closed', 'this worker has ended'));
          return started.end();
        }
        this.open.set(0, { name: 'open', args: [this.message], place: '', done: resolve, failed: reject } as unknown as Job);
        started.post({ id: 0, name: 'open', args: [this.message] });
      }, (error: Error) => events.failed(error.message));
    });
    if (!this.ended) {
      this.hasOpened = true;
      this.thread = this.started!;
      this.thread.await(false);
      this.endIfDone();
    }
    if (!this.isOver) {
      const rows = this.rows();
      if (rows.length > 0) this.give({ name: 'restore', args: [rows], place: '', done: () => {}, failed: () => {} });
      this.free();
    }
    return about;
  }

  /** After these kinds nothing in its memory can be relied on. */
  private refused(job: Job, error: WorldError): void {
    if (job.name !== 'open' && error.kind !== 'out_of_memory' && error.kind !== 'broken') return job.failed(error);
    this.open.set(0, job);
    this.restart(error);
  }

  /** Unless it never opened, or ended too often. */
  private restart(error: WorldError): void {
    this.started?.end();
    this.thread = null;
    if (this.isLetGo || !this.hasOpened || this.starts >= MAX_STARTS) {
      this.about = Promise.reject(error);
      this.about.catch(() => {});
      this.lost(this, error);
      this.end(error);
      return;
    }
    this.failAll(error);
    if (this.ended) return; // by who was told
    this.about = this.start();
    this.about.catch(() => {});
  }

  private failAll(error: WorldError): void {
    const open = [...this.open.values()];
    this.open.clear();
    for (const job of open) job.failed(error);
  }
}

export class Crew {
  private readonly hands: Hand[] = [];
  /** Let go, but not done yet. */
  private readonly leaving = new Set<Hand>();
  private readonly queue = new Map<string, Job[]>();
  private readonly suppliers = new Set<Supplier>();
  private ended: WorldError | null = null;

  /** `rows()`: the edits that a worker that starts must know. */
  constructor(
    private readonly message: OpenMessage,
    private readonly make: (() => Worker) | undefined,
    private readonly rows: () => readonly EditedChunk[],
  ) {}

  get size(): number {
    return this.hands.length;
  }

  /** The first worker, which edits, is never let go. */
  async resize(workers: number): Promise<About> {
    if (this.ended !== null) throw this.ended;
    for (const hand of this.hands.splice(Math.max(1, workers))) {
      this.leaving.add(hand);
      hand.letGo();
    }
    while (this.hands.length < workers) {
      this.hands.push(new Hand(this.message, this.make, this.rows, () => this.work(), (hand, error) => this.lose(hand, error)));
    }
    const abouts = await Promise.all(this.hands.map(({ about }) => about));
    return abouts[0]!;
  }

  supply(supplier: Supplier): void {
    this.suppliers.add(supplier);
    this.work();
  }

  letGo(supplier: Supplier): void {
    this.suppliers.delete(supplier);
  }

  /** There may be work. */
  work(): void {
    for (let found = true; found; ) {
      found = false;
      // One job a worker and round, so that near chunks are shared out.
      for (const hand of this.hands) {
        if (!hand.isFree) continue;
        const job = this.take(hand);
        if (job === null) continue;
        hand.give(job);
        found = true;
      }
    }
  }

  ask<K extends CallName>(name: K, args: Parameters<Calls[K]>, place: string, signal?: AbortSignal): Promise<ReturnType<Calls[K]>> {
    return new Promise((resolve, reject) => {
      if (this.ended !== null) throw this.ended;
      signal?.throwIfAborted();
      const job = { name, args, place, done: resolve, failed: reject } as unknown as Job;
      if (signal !== undefined) {
        const abort = () => {
          this.drop(place, job);
          reject(signal.reason as Error);
        };
        const over = onAbort(signal, abort);
        Object.assign(job, { done: (result: never) => (over(), resolve(result)), failed: (error: WorldError) => (over(), reject(error)) });
      }
      const jobs = this.queue.get(place);
      if (jobs === undefined) this.queue.set(place, [job]);
      else jobs.push(job);
      this.work();
    });
  }

  /** By the first worker, after all that it was given before. */
  askFirst<K extends CallName>(name: K, args: Parameters<Calls[K]>): Promise<ReturnType<Calls[K]>> {
    return this.askOne(this.hands[0], name, args);
  }

  /** By all workers, after all that they were given before; resolves with the first one's answer. */
  askAll<K extends CallName>(name: K, args: Parameters<Calls[K]>): Promise<ReturnType<Calls[K]>> {
    const [first, ...others] = this.hands.map((hand) => this.askOne(hand, name, args));
    for (const other of others) other.catch(() => {}); // it starts again, and is told then
    return first ?? Promise.reject(this.ended);
  }

  /** By all workers but the first. */
  tellOthers<K extends CallName>(name: K, args: Parameters<Calls[K]>): void {
    for (const hand of this.hands.slice(1)) this.askOne(hand, name, args).catch(() => {}); // it starts again, and is told then
  }

  end(error: WorldError): void {
    const isNew = this.ended === null;
    this.ended = error;
    if (isNew) for (const supplier of [...this.suppliers]) supplier.lost(error);
    for (const hand of [...this.hands.splice(0), ...this.leaving]) hand.end(error);
    this.leaving.clear();
    const waiting = [...this.queue.values()].flat();
    this.queue.clear();
    for (const job of waiting) job.failed(error);
  }

  private async askOne<K extends CallName>(hand: Hand | undefined, name: K, args: Parameters<Calls[K]>): Promise<ReturnType<Calls[K]>> {
    if (this.ended !== null || hand === undefined) throw this.ended;
    while (hand.thread === null && !hand.isOver) await hand.about;
    if (hand.isOver) throw this.ended ?? new WorldError('closed', 'this worker was let go');
    return new Promise((resolve, reject) => hand.give({ name, args, place: '', done: resolve, failed: reject } as unknown as Job));
  }

  private lose(hand: Hand, error: WorldError | null): void {
    if (this.leaving.delete(hand) || error === null) return;
    const at = this.hands.indexOf(hand);
    if (at >= 0) this.hands.splice(at, 1);
    if (this.hands.length === 0 && this.ended === null) this.end(error);
  }

  private drop(place: string, job: Job): void {
    const jobs = this.queue.get(place)?.filter((each) => each !== job);
    if (jobs === undefined) return;
    if (jobs.length === 0) this.queue.delete(place);
    else this.queue.set(place, jobs);
  }

  private take(hand: Hand): Job | null {
    const others = new Set(this.hands.filter((each) => each !== hand && each.open.size > 0).map(({ place }) => place));
    const place = this.queue.has(hand.place) ? hand.place : ([...this.queue.keys()].find((each) => !others.has(each)) ?? this.queue.keys().next().value);
    if (place !== undefined) {
      const job = this.queue.get(place)![0]!;
      this.drop(place, job);
      return job;
    }
    for (const supplier of this.suppliers) {
      const job = supplier.next();
      if (job !== null) return job;
    }
    return null;
  }
}

const waiting = new WeakMap<AbortSignal, Set<() => void>>();

/** One listener a signal, however many calls have it. Returns what ends the wait. */
function onAbort(signal: AbortSignal, abort: () => void): () => void {
  let aborts = waiting.get(signal);
  if (aborts === undefined) {
    const all = new Set<() => void>();
    waiting.set(signal, (aborts = all));
    signal.addEventListener('abort', () => {
      for (const each of all) each();
    }, { once: true });
  }
  aborts.add(abort);
  return () => void aborts.delete(abort);
}
