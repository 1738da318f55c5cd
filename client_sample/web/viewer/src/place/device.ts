// Properties of a device, as far as the browser reveals them, and the resulting view distance: twice the distance is
// four times the land, and a phone closes pages that hold too much.
import type { Settings } from './settings';

export interface Device {
  /** Memory in GiB, rounded by the browser (at most 8); null if it is not revealed. */
  memory: number | null;
  /** True if the primary pointer is a finger. */
  isCoarse: boolean;
  /** The shorter side of the screen, in CSS pixels. */
  shortSide: number;
}

export type Reach = Pick<Settings, 'radius' | 'horizon'>;

const PHONE_SIDE = 600;
const LITTLE_MEMORY = 2;
const SOME_MEMORY = 4;

/** Maximum settings; null if the settings' own bounds suffice. */
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
