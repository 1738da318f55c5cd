// A worker: one instance of the module, which makes what a World asks for. In browsers and Node.
import { World as Module, WorldError } from '../../wasm/world.js';
import type { About, Answer, Call, Calls, Columns, EditedChunk, Key, MadeColumns, OpenMessage } from './messages.js';

interface Port {
  postMessage(message: unknown, transfer: readonly ArrayBuffer[]): void;
}

const nameOf = ({ lod, x, y, z }: Key) => `${lod}/${x}/${y}/${z}`;

class Maker implements Calls {
  private world!: Module;
  /** Chunks that were edited at some time: rows of one material may hold them. */
  private readonly edited = new Set<string>();

  async start(message: OpenMessage): Promise<About> {
    const { toml, ...options } = message;
    this.world = await Module.open(toml, options);
    return this.open();
  }

  open(): About {
    const { fingerprint, generatorVersion, codecVersion, heightRange, materials, placeables, instructionSet } = this.world;
    return { fingerprint, generatorVersion, codecVersion, heightRange, materials, placeables, instructionSet };
  }

  spawn() {
    return this.world.spawn();
  }

  columns({ lod, columns }: Columns): MadeColumns {
    const what: number[] = [];
    const payloads: Uint8Array[] = [];
    for (let i = 0; i < columns.length; i += 4) {
      const [x, z, first, last] = columns.subarray(i, i + 4) as unknown as [number, number, number, number];
      const mixed = this.world.rows({ lod, x, z });
      for (let y = first; y <= last; ++y) {
        const isPlain = (y < mixed.first || y > mixed.last) && !(this.edited.size > 0 && this.edited.has(nameOf({ lod, x, y, z })));
        if (isPlain) {
          what.push(y < mixed.first ? mixed.below : 0);
          continue;
        }
        const { uniform, payload } = this.world.generate({ lod, x, y, z }, { voxels: false, payload: true });
        what.push(uniform ?? -payload!.length);
        if (uniform === null) payloads.push(payload!);
      }
    }
    const joined = new Uint8Array(payloads.reduce((sum, payload) => sum + payload.length, 0));
    let at = 0;
    for (const payload of payloads) {
      joined.set(payload, at);
      at += payload.length;
    }
    return { what: Int32Array.from(what), payloads: joined };
  }

  generate(...[key, wanted]: Parameters<Calls['generate']>) {
    return this.world.generate(key, wanted);
  }

  heights(...[area]: Parameters<Calls['heights']>) {
    return this.world.heights(area);
  }

  map(...[tile]: Parameters<Calls['map']>) {
    return this.world.map(tile);
  }

  edit(...[edit]: Parameters<Calls['edit']>) {
    const { changed, chunks } = this.world.edit(edit);
    this.note(chunks);
    const rows = chunks.filter(({ lod }) => lod === 0).map(({ x, y, z }) => ({ x, y, z, runs: this.world.overrides({ x, y, z }) as Uint8Array<ArrayBuffer> }));
    return { changed, chunks, rows };
  }

  restore(rows: readonly EditedChunk[]) {
    const chunks = rows.flatMap(({ x, y, z, runs }) => this.world.restore({ x, y, z }, runs));
    this.note(chunks);
    return chunks;
  }

  private note(chunks: readonly Key[]): void {
    for (const key of chunks) this.edited.add(nameOf(key));
  }
}

/** The arrays in a result whose memory can be given away. */
function buffersOf(result: unknown): ArrayBuffer[] {
  if (result === null || typeof result !== 'object') return [];
  const found = ArrayBuffer.isView(result) ? [result] : Object.values(result).filter((value) => ArrayBuffer.isView(value));
  return [...new Set(found.map(({ buffer }) => buffer as ArrayBuffer))].filter(({ byteLength }) => byteLength > 0);
}

const maker = new Maker();

async function answer(port: Port, { id, name, args }: Call): Promise<void> {
  let said: Answer;
  try {
    const result = name === 'open' ? await maker.start(args[0] as OpenMessage) : (maker[name] as (...args: unknown[]) => unknown)(...args);
    said = { id, result };
  } catch (error) {
    const { kind, message, line, column, key } = error instanceof WorldError ? error : { kind: 'broken' as const, message: String(error), line: 0, column: 0, key: '' };
    said = { id, failure: { kind, message, line, column, key } };
  }
  port.postMessage(said, 'result' in said ? buffersOf(said.result) : []);
}

if (typeof (globalThis as { WorkerGlobalScope?: unknown }).WorkerGlobalScope === 'undefined') {
  const threads = 'node:worker_threads'; // a name that bundlers for browsers do not follow
  void import(/* @vite-ignore */ threads).then(({ parentPort }: typeof import('node:worker_threads')) => {
    parentPort!.on('message', (call: Call) => void answer(parentPort as Port, call));
  });
} else {
  self.onmessage = ({ data }: MessageEvent<Call>) => void answer(self as unknown as Port, data);
}
