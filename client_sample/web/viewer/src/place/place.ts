// A player's position, view and time: contents of a link, so that it opens the same view.

export type Mode = 'walk' | 'fly';

export interface Place {
  /** Base voxels of the feet (walking) or the eyes (flying); null y: on the ground. */
  readonly x: number;
  readonly y: number | null;
  readonly z: number;
  /** Degrees, 0 is north (-z), 90 east (+x). */
  readonly yaw: number;
  /** Degrees above the horizon, -90 to 90. */
  readonly pitch: number;
  /** Hours of the day, 0 to 24. */
  readonly time: number;
  readonly mode: Mode;
}

/** The world reaches 2^36 base voxels in each direction. */
export const WORLD_EDGE = 2 ** 36;

const between = (low: number, value: number, high: number) => Math.min(high, Math.max(low, value));

export const wrapDegrees = (degrees: number) => ((degrees % 360) + 360) % 360;
export const wrapHours = (hours: number) => ((hours % 24) + 24) % 24;

/** "12", "-3.5", "" -> number or null; anything else is undefined. */
function readNumber(text: string): number | null | undefined {
  const trimmed = text.trim();
  if (trimmed === '') return null;
  if (!/^[+-]?\d{1,12}(\.\d{1,6})?$/.test(trimmed)) return undefined;
  return Number(trimmed);
}

/** Parses a link's place. Missing or invalid parts are absent. */
export function readLink(hash: string): Partial<Place> {
  const said = new URLSearchParams(hash.replace(/^#/, ''));
  const place: { -readonly [K in keyof Place]?: Place[K] } = {};
  const at = (said.get('at') ?? '').split(',').map(readNumber);
  if (at.length === 3) {
    const [x, y, z] = at;
    if (typeof x === 'number' && typeof z === 'number' && y !== undefined) {
      place.x = between(-WORLD_EDGE, x, WORLD_EDGE - 1);
      place.y = y === null ? null : between(-WORLD_EDGE, y, WORLD_EDGE - 1);
      place.z = between(-WORLD_EDGE, z, WORLD_EDGE - 1);
    }
  }
  const [yaw, pitch] = (said.get('look') ?? '').split(',').map(readNumber);
  if (typeof yaw === 'number' && typeof pitch === 'number') {
    place.yaw = wrapDegrees(yaw);
    place.pitch = between(-90, pitch, 90);
  }
  const time = readNumber(said.get('time') ?? '');
  if (typeof time === 'number') place.time = wrapHours(time);
  const mode = said.get('mode');
  if (mode === 'walk' || mode === 'fly') place.mode = mode;
  return place;
}

const short = (value: number, digits: number) => String(Number(value.toFixed(digits)));

/** The link's part after '#'. Options that are not about the place are kept. */
export function writeLink(place: Place, hash = ''): string {
  const said = new URLSearchParams(hash.replace(/^#/, ''));
  said.set('at', [short(place.x, 2), place.y === null ? '' : short(place.y, 2), short(place.z, 2)].join(','));
  said.set('look', `${short(wrapDegrees(place.yaw), 1)},${short(place.pitch, 1)}`);
  said.set('time', short(wrapHours(place.time), 2));
  said.set('mode', place.mode);
  return '#' + said.toString().replaceAll('%2C', ',');
}

/** Parses a typed destination: "100 -200", "100, 64, -200", "x=1 z=2" or a whole link. */
export function readCoordinate(text: string): { x: number; y: number | null; z: number } | null {
  const hash = text.indexOf('#');
  if (hash >= 0) {
    const { x, y, z } = readLink(text.slice(hash));
    return x === undefined || z === undefined ? null : { x, y: y ?? null, z };
  }
  const words = text.replace(/[xyz]\s*[=:]/gi, ' ').split(/[\s,;]+/).filter((word) => word !== '');
  const numbers = words.map(readNumber);
  if (!numbers.every((n): n is number => typeof n === 'number' && Math.abs(n) <= WORLD_EDGE)) return null;
  if (numbers.length === 2) return { x: numbers[0]!, y: null, z: numbers[1]! };
  if (numbers.length === 3) return { x: numbers[0]!, y: numbers[1]!, z: numbers[2]! };
  return null;
}

const WINDS = ['north', 'north-east', 'east', 'south-east', 'south', 'south-west', 'west', 'north-west'];

export const windOf = (yaw: number) => WINDS[Math.round(wrapDegrees(yaw) / 45) % 8]!;

export function clock(time: number): string {
  const minutes = Math.floor(wrapHours(time) * 60 + 1e-6);
  return `${String(Math.floor(minutes / 60)).padStart(2, '0')}:${String(minutes % 60).padStart(2, '0')}`;
}
