// Traverses voxels along a ray (Amanatides and Woo, 1987).
import type { Hit, Vector } from './api.js';

export function castRay(
  origin: Vector,
  direction: Vector,
  max: number,
  voxelAt: (x: number, y: number, z: number) => number | undefined,
  stops: (material: number) => boolean,
): Hit | null {
  const length = Math.hypot(direction.x, direction.y, direction.z);
  if (!(length > 0)) return null;
  const from = [origin.x, origin.y, origin.z];
  const along = [direction.x / length, direction.y / length, direction.z / length];
  const at = from.map(Math.floor);
  const step = along.map(Math.sign);
  const delta = along.map((d) => (d === 0 ? Infinity : Math.abs(1 / d)));
  const next = along.map((d, i) => (d === 0 ? Infinity : (d > 0 ? at[i]! + 1 - from[i]! : from[i]! - at[i]!) * delta[i]!));
  let distance = 0;
  let axis = -1;
  while (distance <= max) {
    const material = voxelAt(at[0]!, at[1]!, at[2]!);
    if (material === undefined) return null;
    if (stops(material)) {
      const normal = [0, 0, 0];
      if (axis >= 0) normal[axis] = -step[axis]!;
      return {
        x: at[0]!, y: at[1]!, z: at[2]!, material, distance,
        normal: { x: normal[0]!, y: normal[1]!, z: normal[2]! },
      };
    }
    axis = next[0]! < next[1]! ? (next[0]! < next[2]! ? 0 : 2) : next[1]! < next[2]! ? 1 : 2;
    distance = next[axis]!;
    next[axis]! += delta[axis]!;
    at[axis]! += step[axis]!;
  }
  return null;
}
