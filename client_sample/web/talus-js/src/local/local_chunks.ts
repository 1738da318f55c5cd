// A published world's chunks made beside a stream: with the edits that the server sends laid over them, and some of them
// compared with the server's.
import type { Tracker } from '../client/tracker.js';
import { decodeChunk } from '../decode.js';
import { readRuns } from '../edits/runs.js';
import { encodeChunk } from '../encode.js';
import { hashVoxels } from '../hash.js';
import { keyName } from '../keys.js';
import type { BaseHost, EditBroadcast } from '../stream/base_making.js';
import type { Chunk, ChunkKey, ConnectOptions, World as Facts } from '../types.js';
import { materialOf, uniformPayload } from '../uniform.js';
import { Making, type Made } from './making.js';
import { Proofs } from './proofs.js';
import { openPublished } from './published.js';
import type { World } from './world.js';

export interface LocalHost extends Omit<BaseHost, 'failed'> {
  failed(why: Error): void;
}

interface WaitingEdits {
  revision: bigint;
  broadcasts: EditBroadcast[];
}

/** Of edits of chunks that are not made yet. */
const MAX_WAITING_BYTES = 16 << 20;

export class LocalChunks {
  isOn = false;
  private readonly making: Making;
  private readonly proofs: Proofs;
  private readonly edits = new Map<string, WaitingEdits>();
  private editBytes = 0;
  private isServerDone = false;
  private isMade = false;

  static async open(options: ConnectOptions, base: string, facts: Facts, tracker: Tracker, host: LocalHost, signal: AbortSignal): Promise<LocalChunks> {
    return new LocalChunks(await openPublished(options, base, facts, signal), tracker, host);
  }

  private constructor(
    private readonly world: World,
    private readonly tracker: Tracker,
    private readonly host: LocalHost,
  ) {
    this.making = new Making(world, {
      made: (chunk) => this.made(chunk),
      whole: () => {
        this.isMade = true;
        this.tell();
      },
      failed: (error) => host.failed(error),
    });
    this.proofs = new Proofs((key, hash) => host.compare(key, hash), (key) => host.failed(new Error(`chunk ${keyName(key)} differs from the server's`)));
  }

  /** `isWhole`: all of the View came by the stream. */
  begin(isWhole: boolean): void {
    this.joined();
    if (isWhole) this.making.has(this.tracker.shape!);
  }

  joined(): void {
    this.isOn = true;
    // Of these the server says nothing if they are without edits now.
    for (const key of this.tracker.outdated()) this.making.forget(key);
    this.proofs.begin();
  }

  disconnected(): void {
    this.isOn = this.isServerDone = false;
    this.edits.clear();
    this.editBytes = 0;
  }

  viewApplied(): void {
    this.isServerDone = this.isMade = false;
    const { view, shape } = this.tracker;
    for (const [name, { broadcasts }] of this.edits) if (shape?.covers(broadcasts[0]!.key) !== true) this.drop(name);
    this.making.want(view, shape);
  }

  serverIsDone(): void {
    this.isServerDone = true;
    this.tell();
  }

  edited(message: EditBroadcast): boolean {
    const { key, revision, previousRevision, runs } = message;
    if (!this.isOn || this.tracker.shape?.covers(key) !== true) return false;
    const name = keyName(key);
    const held = this.tracker.find(key);
    if (held !== undefined && revision <= held.revision) return true;
    const waiting = this.edits.get(name);
    const isBase = held !== undefined && (held.revision < 0n || (held.revision === 0n && held.hash === null && held.material === null));
    if (held !== undefined && !isBase && waiting === undefined) return false;
    if (previousRevision > (waiting?.revision ?? 0n) || this.editBytes + runs.length > MAX_WAITING_BYTES) {
      this.drop(name);
      this.host.refetch(key);
      return true;
    }
    if (previousRevision === 0n) this.drop(name); // it has all that changed
    const broadcasts = [...(this.edits.get(name)?.broadcasts ?? []), message];
    this.edits.set(name, { revision, broadcasts });
    this.editBytes += runs.length;
    if (held !== undefined && waiting === undefined) this.makeAgain(key);
    return true;
  }

  /** A whole chunk of the View came. */
  came({ key, revision }: Chunk): void {
    const name = keyName(key);
    if ((this.edits.get(name)?.revision ?? revision + 1n) <= revision) this.drop(name);
  }

  end(): void {
    this.isOn = false;
    this.making.end();
    this.world.close();
  }

  private made({ key, payload, material }: Made): void {
    if (!this.isOn) return;
    const name = keyName(key);
    const waiting = this.edits.get(name);
    const base = payload ?? uniformPayload(material!);
    if (waiting !== undefined) {
      this.drop(name);
      this.host.deliver(merged(key, base, waiting));
    } else if (!this.tracker.hasCurrent(key)) {
      if (payload !== null) this.proofs.made(key, payload);
      this.host.deliver({ key, revision: 0n, hash: null, payload: base, material });
    }
  }

  private makeAgain(key: ChunkKey): void {
    this.world.generate(key, { voxels: false, payload: true }).then(
      ({ payload, uniform }) => this.edits.has(keyName(key)) && this.made({ key, payload: payload as Uint8Array<ArrayBuffer> | null, material: uniform }),
      (error: Error) => this.isOn && this.host.failed(error),
    );
  }

  private drop(name: string): void {
    for (const { runs } of this.edits.get(name)?.broadcasts ?? []) this.editBytes -= runs.length;
    this.edits.delete(name);
  }

  private tell(): void {
    if (!this.isServerDone || !this.isMade) return;
    this.isServerDone = false;
    this.host.whole();
  }
}

function merged(key: ChunkKey, base: Uint8Array, { revision, broadcasts }: WaitingEdits): Chunk {
  const decoded = decodeChunk(base);
  const voxels = decoded.voxels ?? new Uint16Array(32_768).fill(decoded.uniform);
  for (const { runs } of broadcasts) readRuns(runs, (first, end, material) => voxels.fill(material, first, end));
  const payload = encodeChunk({ uniform: null, voxels });
  return { key, revision, hash: hashVoxels({ uniform: null, voxels }), payload, material: materialOf(payload) };
}
