// Where somebody who arrives looks first: over open ground to high land, as talus-client flies.

const STEP = 100; // blocks between samples
const REACH = 9; // samples to each side
const SIDE = 2 * REACH + 1;
const HEADINGS = 24;
/** Samples of a heading: the way, the open ground behind it, the high land behind that. */
const WAY = 3;
const OPEN = 6;

/** The request for what bestHeading() takes: heights of a square around a column. */
export function outlookRequest(x: number, z: number): string {
  const from = (middle: number) => Math.floor(middle) - REACH * STEP;
  return `v1/heights?x=${from(x)}&z=${from(z)}&w=${SIDE}&h=${SIDE}&step=${STEP}`;
}

/** `heights`: row by row from the north-west. Degrees, 0 is north, 90 east. */
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
      // A slope close by hides what lies behind it.
      if (sample <= WAY) score -= 4 * Math.max(0, height - here);
      else score += height * (sample <= OPEN ? -1.2 : 1);
    }
    if (score > bestScore) [bestScore, best] = [score, heading];
  }
  return best;
}
