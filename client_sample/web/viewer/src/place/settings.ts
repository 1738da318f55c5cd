// The player's settings, stored by the browser if it allows that.

export interface Settings {
  /** Chunks of full detail around the player. */
  radius: number;
  /** Extent of the land, in base voxels; 0: only full detail. */
  horizon: number;
  quality: 'low' | 'high';
  transport: 'websocket' | 'http';
  /** Maximum frames per second; 0: the display's rate. */
  frameRate: number;
  /** Degrees of turn per pixel of mouse or finger. */
  sensitivity: number;
  invertLook: boolean;
  timeRuns: boolean;
  chunkBorders: boolean;
  /** null: the system's setting. */
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

/** Takes valid settings from `said`, and all others from `base`. */
export function mend(base: Settings, said: unknown): Settings {
  const mended: Record<string, unknown> = { ...base };
  if (typeof said === 'object' && said !== null) {
    for (const [key, value] of Object.entries(said)) {
      if (key in fits && fits[key as keyof Settings](value)) mended[key] = value;
    }
  }
  return mended as unknown as Settings;
}

/** Settings in a link override stored ones and are not stored: #radius=4&horizon=0. */
export function fromLink(hash: string): Record<string, unknown> {
  const said: Record<string, unknown> = {};
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    if (!(key in fits)) continue;
    said[key] = text === 'true' ? true : text === 'false' ? false : /^\d+(\.\d+)?$/.test(text) ? Number(text) : text;
  }
  return said;
}

const KEY = 'talus.settings';

/** A browser may deny storage (private windows, blocked cookies): then nothing is stored. */
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
    // Not stored.
  }
}
