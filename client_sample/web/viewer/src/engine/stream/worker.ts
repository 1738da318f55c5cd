// A meshing worker: decodes its chunks, and meshes on request.
import { meshChunk } from '../mesh/mesher.js';
import { PADDED_VOXELS, fillPadded } from '../mesh/volume.js';
import { apply } from './changes.js';
import { decodeChunk } from './decode.js';
import type { FromWorker, Job, ToWorker } from './messages.js';
import { keptOf } from './slice.js';
import { WorkerChunks } from './worker_chunks.js';

const chunks = new WorkerChunks(decodeChunk);
const padded = new Uint16Array(PADDED_VOXELS);
let kinds: Uint8Array = new Uint8Array();
let places: Uint16Array = new Uint16Array();

/** Above this level, corners would darken whole hillsides. */
const OCCLUDED_LEVELS = 3;

const answer = (message: FromWorker, transfer: Transferable[] = []) =>
  (self as unknown as Worker).postMessage(message, transfer);

function mesh(job: Job): void {
  const { id, lod, x, y, z } = job;
  const start = performance.now();
  const centre = chunks.centre(lod, x, y, z);
  if (centre === undefined) {
    answer({ kind: 'failed', id, text: 'not held' });
    return;
  }
  fillPadded(padded, centre, (dx, dy, dz) =>
    (job.known >>> ((dy + 1) * 9 + (dz + 1) * 3 + dx + 1)) & 1 ? chunks.shell(lod, x + dx, y + dy, z + dz) : undefined,
  );
  const kept = job.slice === null ? null : keptOf(job.slice, lod, x, z);
  const made = meshChunk(padded, { kinds, places, slot: job.slot, occlusion: lod < OCCLUDED_LEVELS, grounded: lod > 0, kept });
  answer(
    { kind: 'meshed', id, mesh: made, ms: performance.now() - start, heldBytes: chunks.bytes },
    [made.quads.buffer, made.counts.buffer, made.tops.buffer, ...(made.liquidTops ? [made.liquidTops.buffer] : [])],
  );
}

self.onmessage = (event: MessageEvent<ToWorker>) => {
  const message = event.data;
  if (message.kind === 'world') {
    kinds = message.kinds;
    places = message.places;
    return;
  }
  if (message.changes !== null) apply(message.changes, chunks);
  for (const job of message.jobs) {
    try {
      mesh(job);
    } catch (error) {
      answer({ kind: 'failed', id: job.id, text: String(error) });
    }
  }
};
