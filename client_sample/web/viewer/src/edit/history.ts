// The player's own edits, for undo. An undo is guarded by the edit's result, so that it never overwrites others' edits.
import type { Edit } from 'talus';
import type { Vector } from '../engine/api';

export interface VoxelEdit {
  readonly voxel: Vector;
  readonly before: number;
  readonly after: number;
}

export interface Step {
  readonly made: readonly VoxelEdit[];
}

const KEPT = 200;
/** Bytes of a guard and a write on the wire, and of the rest of a frame. */
const PAIR_BYTES = 64;
const REST_BYTES = 256;

export class History {
  #steps: Step[] = [];

  get isEmpty(): boolean {
    return this.#steps.length === 0;
  }

  push(made: readonly VoxelEdit[]): Step {
    const step = { made };
    this.#steps.push(step);
    if (this.#steps.length > KEPT) this.#steps.shift();
    return step;
  }

  /** The edit was not applied. */
  remove(step: Step): void {
    this.#steps = this.#steps.filter((each) => each !== step);
  }

  pop(): Step | undefined {
    return this.#steps.pop();
  }

  clear(): void {
    this.#steps = [];
  }
}

/** Maximum voxels that one edit can undo. */
export function pairsThatFit(frameBytes: number, voxels: number): number {
  const byVoxels = voxels > 0 ? Math.floor(voxels / 2) : Infinity;
  return Math.max(1, Math.min(Math.floor((frameBytes - REST_BYTES) / PAIR_BYTES), byVoxels));
}

/** Edits that restore `made`, each of at most `maxVoxels` voxels. */
export function undoing(made: readonly VoxelEdit[], maxVoxels: number): { edit: Edit; made: readonly VoxelEdit[] }[] {
  const edits = [];
  for (let from = 0; from < made.length; from += maxVoxels) {
    const part = made.slice(from, from + maxVoxels);
    const edit = {
      guards: part.map(({ voxel, after }) => ({ voxel, material: after })),
      writes: part.map(({ voxel, before }) => ({ voxel, material: before })),
    };
    edits.push({ edit, made: part });
  }
  return edits;
}
