// What a device is, as far as its browser tells, and how far one may look there: who looks twice as far holds four times
// the land, and a phone closes a page that holds much.
import type { Settings } from './settings';

export interface Device {
  /** Of memory, in GiB, as the browser rounds it (8 at most); null where it keeps that to itself. */
  memory: number | null;
  /** Whether a finger is what one points with first. */
  isCoarse: boolean;
  /** The shorter side of the screen, in CSS pixels. */
  shortSide: number;
}

export type Reach = Pick<Settings, 'radius' | 'horizon'>;

const PHONE_SIDE = 600;
const LITTLE_MEMORY = 2;
const SOME_MEMORY = 4;

/** The most that one may set; null where the settings' own bounds are enough. */
export function capOf({ memory, isCoarse, shortSide }: Device): Reach | null {
  if (memory !== null && memory <= LITTLE_MEMORY) return { radius: 6, horizon: 2048 };
  const isSmall = isCoarse && (shortSide < PHONE_SIDE || memory === null || memory <= SOME_MEMORY);
  if (isSmall || (memory !== null && memory <= SOME_MEMORY)) return { radius: 10, horizon: 4096 };
  return null;
}

export function capped<T extends Partial<Settings>>(settings: T, cap: Reach | null): T {
  if (cap === null) return settings;
  const within = { ...settings };
  for (const key of ['radius', 'horizon'] as const) if (within[key] !== undefined) within[key] = Math.min(within[key], cap[key]);
  return within;
}

export function thisDevice(): Device {
  const { deviceMemory } = navigator as Navigator & { deviceMemory?: number };
  return {
    memory: deviceMemory ?? null,
    isCoarse: matchMedia('(pointer: coarse)').matches,
    shortSide: Math.min(screen.width, screen.height),
  };
}
