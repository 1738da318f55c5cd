import { decodeChunk as decode } from '../../../../talus-js/src/decode.js';

/** Voxels, or the one material that the chunk consists of. Throws where they are none, or do not have the hash. */
export function decodeChunk(payload: Uint8Array, hash: string | null = null): number | Uint16Array {
  const { uniform, voxels } = decode(payload, { hash });
  return voxels ?? uniform;
}
