// Where one arrives: at what the link names, or above the spawn.
import { EYE } from '../controls/body';
import type { Place } from './place';

export const SPAWN_PITCH = -8;
/** Above the ground, for one who flies. */
export const FLIGHT_RISE = 14;

export const riseOf = (mode: Place['mode']): number => (mode === 'fly' ? FLIGHT_RISE : 0);

export function startingPlace(link: Partial<Place>): Partial<Place> {
  return { pitch: SPAWN_PITCH, mode: 'fly', ...link };
}

/** Of the eye; degrees. null: the server must say first how high the ground is. */
export function firstEye(link: Partial<Place>, spawn: { x: number; y: number; z: number }): { x: number; y: number; z: number; yaw: number; pitch: number } | null {
  const { x, y, z, yaw = 0, pitch = 0, mode = 'fly' } = startingPlace(link);
  if (x === undefined || z === undefined) return { x: spawn.x + 0.5, y: spawn.y + riseOf(mode) + EYE, z: spawn.z + 0.5, yaw, pitch };
  return y === undefined || y === null ? null : { x, y: y + EYE, z, yaw, pitch };
}
