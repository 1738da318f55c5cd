import { decodeChunk as decode } from '../../../../talus-js/src/decode.js';

/** Voxels, or the one material that the chunk consists of. */
export function decodeChunk(payload: Uint8Array): number | Uint16Array {
  const { uniform, voxels } = decode(payload);
  return voxels ?? uniform;
}
