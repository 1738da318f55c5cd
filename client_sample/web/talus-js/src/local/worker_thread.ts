// Starts a worker in a page, or a thread in Node.
import type { Answer, Call } from './messages.js';

export interface WorkerThread {
  post(call: Call): void;
  /** In Node a program ends while nothing is awaited. */
  await(anything: boolean): void;
  end(): void;
}

export interface WorkerEvents {
  answered(answer: Answer): void;
  /** It did not start, or ended by itself. */
  failed(why: string): void;
}

/** `make`: makes the page's Worker of worker.js, for bundlers that put it elsewhere. */
export async function startWorker(events: WorkerEvents, make?: () => Worker): Promise<WorkerThread> {
  if (make !== undefined || typeof Worker === 'function') {
    const worker = make?.() ?? new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }: MessageEvent<Answer>) => events.answered(data);
    worker.onerror = (event) => {
      event.preventDefault?.();
      events.failed(event.message || 'its file did not load');
    };
    return { post: (call) => worker.postMessage(call), await: () => {}, end: () => worker.terminate() };
  }
  const threads = 'node:worker_threads'; // a name that bundlers for browsers do not follow
  const { Worker: Thread } = (await import(/* @vite-ignore */ threads)) as typeof import('node:worker_threads');
  const file = './worker.js'; // likewise
  const thread = new Thread(new URL(file, import.meta.url));
  thread.on('message', events.answered);
  thread.on('error', (error) => events.failed((error as Error).message));
  return { post: (call) => thread.postMessage(call), await: (anything) => (anything ? thread.ref() : thread.unref()), end: () => void thread.terminate() };
}
