// Decodes a chunk's payload: core/voxel/FORMAT.md, codec version 4. Independent of the rest of this package, so that a
// worker can load it alone.
import { DecodeError, type DecodeFault } from './codec/decode_error.js';
import { LayersDecoder } from './codec/layers.js';
import { RunsDecoder } from './codec/runs.js';
import { MAX_PAYLOAD_BYTES, Source } from './codec/source.js';
import { VolumeDecoder } from './codec/volume.js';
import { TalusError } from './errors.js';
import { hashVoxels } from './hash.js';
import type { Voxels } from './types.js';

export { DecodeError, type DecodeFault };

export const CHUNK_SIZE = 32;
export const CHUNK_VOLUME = 32_768;

/** Working memory of the decoder, created for the first chunk. */
class Workshop {
  readonly source = new Source();
  readonly layers = new LayersDecoder();
  readonly volume = new VolumeDecoder();
  readonly runs = new RunsDecoder();
}
let workshop: Workshop | undefined;

/** Returns the voxels of a payload. Throws DecodeError if it is invalid, or if its voxels do not match `hash`, a check
 *  that costs more than decoding. `into`, of 32,768 elements, is filled and returned as `voxels` instead of a new
 *  array, unless the chunk is uniform; its content is undefined after an error. */
export function decodeChunk(
  payload: Uint8Array,
  options: { readonly hash?: string | null; readonly into?: Uint16Array<ArrayBuffer> } = {},
): Voxels {
  if (options.into !== undefined && options.into.length !== CHUNK_VOLUME) {
    throw new TalusError('out_of_range', `decodeChunk: into must have ${CHUNK_VOLUME} voxels, not ${options.into.length}`);
  }
  if (!ArrayBuffer.isView(payload) || payload.BYTES_PER_ELEMENT !== 1) {
    throw new TalusError('out_of_range', 'decodeChunk: a payload is a Uint8Array');
  }
  const decoded = decode(payload, options.into);
  if (options.hash != null && hashVoxels(decoded) !== options.hash) throw new DecodeError('bad_hash');
  return decoded;
}

function decode(payload: Uint8Array, into?: Uint16Array<ArrayBuffer>): Voxels {
  if (payload.length === 0) throw new DecodeError('empty');
  const version = payload[0]!;
  if (version !== 3 && version !== 4) throw new DecodeError('unknown_version');
  if (payload.length < 2) throw new DecodeError('truncated');
  if (payload.length > MAX_PAYLOAD_BYTES) throw new DecodeError('too_long');
  const encoding = payload[1]!;
  if (version === 3 ? encoding !== 0 : encoding === 0 || encoding > 3) throw new DecodeError('unknown_encoding');

  workshop ??= new Workshop();
  const { source, layers, volume, runs } = workshop;
  source.begin(payload);
  const isLayered = version === 3;
  if (isLayered) {
    const uniform = layers.decode(source);
    if (uniform !== null) return { uniform, voxels: null };
  }
  const voxels = into ?? new Uint16Array(CHUNK_VOLUME);
  if (isLayered) layers.expand(voxels);
  else if (encoding === 2) readRaw(payload, voxels);
  else if (encoding === 1) volume.decode(source, voxels);
  else runs.decode(source, voxels);
  return { uniform: null, voxels };
}

function readRaw(payload: Uint8Array, voxels: Uint16Array): void {
  if (payload.length < MAX_PAYLOAD_BYTES) throw new DecodeError('truncated');
  for (let i = 0; i < CHUNK_VOLUME; ++i) voxels[i] = payload[2 + 2 * i]! | (payload[3 + 2 * i]! << 8);
}
