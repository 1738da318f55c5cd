// What a player chose, kept by the browser where it lets us.

export interface Settings {
  /** Chunks of full detail around the player. */
  radius: number;
  /** How far the land reaches, in base voxels; 0: full detail alone. */
  horizon: number;
  quality: 'low' | 'high';
  transport: 'websocket' | 'http';
  /** Frames a second at most; 0: as the display does. */
  frameRate: number;
  /** Degrees of turn for a pixel of mouse or finger. */
  sensitivity: number;
  invertLook: boolean;
  timeRuns: boolean;
  chunkBorders: boolean;
  /** null: as the system says. */
  reducedMotion: boolean | null;
}

const isOneOf =
  <T>(...values: T[]) =>
  (value: unknown): value is T =>
    values.includes(value as T);
const isBetween = (low: number, high: number) => (value: unknown) =>
  typeof value === 'number' && value >= low && value <= high;
const isBoolean = (value: unknown) => typeof value === 'boolean';

const fits: { [K in keyof Settings]: (value: unknown) => boolean } = {
  radius: isBetween(2, 24),
  horizon: isBetween(0, 16384),
  quality: isOneOf('low', 'high'),
  transport: isOneOf('websocket', 'http'),
  frameRate: isBetween(0, 240),
  sensitivity: isBetween(0.02, 1),
  invertLook: isBoolean,
  timeRuns: isBoolean,
  chunkBorders: isBoolean,
  reducedMotion: (value) => value === null || isBoolean(value),
};

export function defaults(phone: boolean): Settings {
  return {
    radius: phone ? 6 : 10,
    horizon: phone ? 2048 : 4096,
    quality: phone ? 'low' : 'high',
    transport: 'websocket',
    frameRate: 0,
    sensitivity: 0.12,
    invertLook: false,
    timeRuns: false,
    chunkBorders: false,
    reducedMotion: null,
  };
}

/** Takes from `said` what is a setting and fits, and leaves the rest as `base` has it. */
export function mend(base: Settings, said: unknown): Settings {
  const mended: Record<string, unknown> = { ...base };
  if (typeof said === 'object' && said !== null) {
    for (const [key, value] of Object.entries(said)) {
      if (key in fits && fits[key as keyof Settings](value)) mended[key] = value;
    }
  }
  return mended as unknown as Settings;
}

/** Settings that a link names win over those kept, and are not kept: #radius=4&horizon=0. */
export function fromLink(hash: string): Record<string, unknown> {
  const said: Record<string, unknown> = {};
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    if (!(key in fits)) continue;
    said[key] = text === 'true' ? true : text === 'false' ? false : /^\d+(\.\d+)?$/.test(text) ? Number(text) : text;
  }
  return said;
}

const KEY = 'talus.settings';

/** A browser may refuse storage altogether (private windows, blocked cookies): then nothing is kept. */
export function load(base: Settings, storage: () => Storage): Settings {
  try {
    return mend(base, JSON.parse(storage().getItem(KEY) ?? 'null'));
  } catch {
    return base;
  }
}

export function save(settings: Settings, storage: () => Storage): void {
  try {
    storage().setItem(KEY, JSON.stringify(settings));
  } catch {
    // Not kept.
  }
}
