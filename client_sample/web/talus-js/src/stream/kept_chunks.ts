// Kept payloads, so that chunks can be sent as their hash and edited by broadcasts.
import { type KeptPayload, PayloadCache } from '../client/payload_cache.js';
import type { DeliveredChunk } from '../client/tracker.js';
import { decodeChunk } from '../decode.js';
import { readRuns } from '../edits/runs.js';
import { encodeChunk } from '../encode.js';
import { hashVoxels } from '../hash.js';
import { keyName } from '../keys.js';
import type { Chunk, ChunkKey } from '../types.js';
import { materialOf, uniformPayload } from '../uniform.js';
import { chunksOutside, countOf, forEachChunk } from '../view_difference.js';
import type { ViewShape } from '../view_shape.js';
import type { ServerMessage } from '../wire/messages.js';
import type { KnownChunk } from '../wire/write.js';

const CHUNK_VOLUME = 32_768;

export class KeptChunks {
  private readonly cache: PayloadCache;

  constructor(maxBytes: number) {
    this.cache = new PayloadCache(maxBytes);
  }

  keep({ key, revision, hash, payload, material }: Chunk): void {
    if (material === null && hash !== null) this.cache.put(keyName(key), { key, revision, hash, payload });
    else this.cache.erase(keyName(key));
  }

  /** The kept payload of these voxels. */
  find(key: ChunkKey, hash: string | null): KeptPayload | undefined {
    const kept = this.cache.find(keyName(key));
    return kept?.hash === hash ? kept : undefined;
  }

  /** Up to `maxCount` kept chunks in `shape` but not in `before`: a View brings back no others. */
  known(maxCount: number, shape: ViewShape, before: ViewShape | null): KnownChunk[] {
    const known: KnownChunk[] = [];
    const entering = chunksOutside(shape, before);
    if (countOf(entering) > this.cache.size) {
      for (const [, { key, hash }] of this.cache.entries()) {
        if (known.length < maxCount && shape.covers(key) && !before?.covers(key)) known.push({ key, hash });
      }
    } else {
      forEachChunk(entering, (key) => {
        const kept = known.length < maxCount ? this.cache.find(keyName(key)) : undefined;
        if (kept !== undefined) known.push({ key, hash: kept.hash });
      });
    }
    return known;
  }

  /** The held chunk with the edit applied; null if it was not kept, or the edit does not apply to it. */
  edited(held: DeliveredChunk, { key, revision, previousRevision, runs }: Extract<ServerMessage, { kind: 'edit_broadcast' }>): Chunk | null {
    const payload = held.material === null ? this.find(key, held.hash)?.payload : uniformPayload(held.material);
    if (payload === undefined || runs.length === 0 || previousRevision > held.revision) return null;
    const voxels = new Uint16Array(CHUNK_VOLUME);
    const before = decodeChunk(payload, { into: voxels });
    if (before.voxels === null) voxels.fill(before.uniform);
    readRuns(runs, (first, end, material) => voxels.fill(material, first, end));
    const after = encodeChunk({ uniform: null, voxels });
    return { key, revision, hash: hashVoxels({ uniform: null, voxels }), payload: after, material: materialOf(after) };
  }

  clear(): void {
    this.cache.clear();
  }
}
