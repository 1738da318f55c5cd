import { TalusError } from '../errors.js';

/** Faults of a payload, named as in core/voxel/FORMAT.md, "Errors". */
export type DecodeFault =
  | 'empty'
  | 'unknown_version'
  | 'unknown_encoding'
  | 'truncated'
  | 'too_long'
  | 'bad_materials'
  | 'bad_number'
  | 'bad_ending'
  /** The payload decodes, but its voxels do not match the hash. */
  | 'bad_hash';

const TEXTS: Record<DecodeFault, string> = {
  empty: 'has no bytes; it needs at least a version and an encoding',
  unknown_version: 'begins with a byte that is no version known here, 3 or 4',
  unknown_encoding: 'has a second byte that names no encoding of its version',
  truncated: 'ends before the chunk does; it must be passed whole',
  too_long: "goes on after the chunk's end; it must be passed without other bytes",
  bad_materials: 'has a list of materials that is empty, too long or out of order',
  bad_number: 'holds a number that is past its range or not in its shortest form',
  bad_ending: 'does not end as its chunk does; it was changed on its way',
  bad_hash: 'decodes to voxels that do not have the hash it came with',
};

/** An invalid payload. */
export class DecodeError extends TalusError {
  constructor(readonly fault: DecodeFault) {
    super('bad_chunk', `the chunk payload ${TEXTS[fault]}`);
  }
}
