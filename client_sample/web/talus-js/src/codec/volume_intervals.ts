import { CLASSES, ENDS } from './volume_tables.js';

const CONTEXTS = 384;

function classOf(letter: number): number {
  if (letter <= 0x39) return letter - 0x30; // 0 to 9
  return letter <= 0x5a ? letter - 0x41 + 10 : letter - 0x61 + 36; // A to Z, a to z
}

/** By table, the intervals of all contexts: the ends of the intervals of symbols 0, 1 and 2, eight bits each. */
export function parseIntervals(): Int32Array[] {
  const ends = ENDS.trim().split(/\s+/).map(Number);
  return CLASSES.map((text) => {
    const letters = text.replace(/\s/g, '');
    return Int32Array.from({ length: CONTEXTS }, (_, context) => {
      const at = 3 * classOf(letters.charCodeAt(context));
      return ends[at]! | (ends[at + 1]! << 8) | (ends[at + 2]! << 16);
    });
  });
}
