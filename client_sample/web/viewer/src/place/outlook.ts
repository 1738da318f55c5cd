// Initial heading of an arriving player: over open ground to high land, as talus-client flies.

const STEP = 100; // blocks between samples
const REACH = 9; // samples to each side
const SIDE = 2 * REACH + 1;
const HEADINGS = 24;
/** Samples of a heading: the way, the open ground behind it, the high land behind that. */
const WAY = 3;
const OPEN = 6;

/** The samples of bestHeading(), and a level of detail that is fine enough for them. */
export const OUTLOOK = { step: STEP, reach: REACH, lod: 3 };

/** The request for bestHeading()'s input: heights of a square around a column. */
export function outlookRequest(x: number, z: number): string {
  const from = (middle: number) => Math.floor(middle) - REACH * STEP;
  return `v1/heights?x=${from(x)}&z=${from(z)}&w=${SIDE}&h=${SIDE}&step=${STEP}`;
}

/** `heights`: row by row from the north-west. Returns degrees, 0 is north, 90 east. */
export function bestHeading(heights: ArrayLike<number>): number {
  const here = heights[REACH * SIDE + REACH]!;
  let best = 0;
  let bestScore = -Infinity;
  for (let heading = 0; heading < 360; heading += 360 / HEADINGS) {
    const angle = (heading * Math.PI) / 180;
    let score = 0;
    for (let sample = 1; sample <= REACH; ++sample) {
      const x = REACH + Math.round(Math.sin(angle) * sample);
      const z = REACH - Math.round(Math.cos(angle) * sample);
      const height = heights[z * SIDE + x]!;
      // A nearby slope hides the land behind it.
      if (sample <= WAY) score -= 4 * Math.max(0, height - here);
      else score += height * (sample <= OPEN ? -1.2 : 1);
    }
    if (score > bestScore) [bestScore, best] = [score, heading];
  }
  return best;
}

/** Blocks that must be open ahead of the eye, and degrees between headings tried. */
const NEAR = 64;
const TURN = 15;

/** The nearest heading, in degrees, whose central ray meets nothing near; `yaw` if all meet something. Undefined: the
 *  voxels needed are not loaded yet. */
export function clearHeading(
  eye: readonly [number, number, number],
  yaw: number,
  pitch: number,
  voxelAt: (x: number, y: number, z: number) => number | undefined,
  stops: (material: number) => boolean,
): number | undefined {
  const slope = (pitch * Math.PI) / 180;
  for (let turn = 0; turn <= 180; turn += TURN) {
    for (const heading of [yaw + turn, yaw - turn]) {
      const angle = (heading * Math.PI) / 180;
      const along = [Math.sin(angle) * Math.cos(slope), Math.sin(slope), -Math.cos(angle) * Math.cos(slope)] as const;
      let isClear = true;
      for (let distance = 0; isClear && distance <= NEAR; distance += 0.5) {
        const [x, y, z] = along.map((part, i) => Math.floor(eye[i]! + part * distance)) as [number, number, number];
        const material = voxelAt(x, y, z);
        if (material === undefined) return undefined;
        isClear = !stops(material);
      }
      if (isClear) return ((heading % 360) + 360) % 360;
    }
  }
  return yaw;
}
