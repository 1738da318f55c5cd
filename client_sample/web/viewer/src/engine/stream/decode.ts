import { decodeChunk as decode } from '../../../../talus-js/src/decode.js';

/** Voxels, or the material of a uniform chunk. Throws if the payload is invalid or does not match the hash. */
export function decodeChunk(payload: Uint8Array, hash: string | null = null): number | Uint16Array {
  const { uniform, voxels } = decode(payload, { hash });
  return voxels ?? uniform;
}
