// The voxel in view, or selected: material, coordinates, and its frame in the world.
import type { Engine, Hit, Vector } from '../engine/engine';
import { find, say } from './dom';

const REACH = 256;
export const FIELD_OF_VIEW = 70;

const radians = Math.PI / 180;

/** Direction of a point on the screen, relative to its centre in units of half its height (right and up). */
export function rayThrough(yaw: number, pitch: number, right: number, up: number): Vector {
  const slope = Math.tan((FIELD_OF_VIEW / 2) * radians);
  const [sinYaw, cosYaw] = [Math.sin(yaw * radians), Math.cos(yaw * radians)];
  const [sinPitch, cosPitch] = [Math.sin(pitch * radians), Math.cos(pitch * radians)];
  const [r, u] = [right * slope, up * slope];
  const level = cosPitch - u * sinPitch;
  const [x, y, z] = [sinYaw * level + cosYaw * r, sinPitch + u * cosPitch, -cosYaw * level + sinYaw * r];
  const length = Math.hypot(x, y, z);
  return { x: x / length, y: y / length, z: z / length };
}

export class VoxelCard {
  readonly #card = find('voxel');
  readonly #close = find<HTMLButtonElement>('voxel-close');
  #held: Hit | null = null;
  #shown: Hit | null = null;

  constructor() {
    this.#close.addEventListener('click', () => this.letGo());
  }

  get held(): Hit | null {
    return this.#held;
  }

  get shown(): Hit | null {
    return this.#shown;
  }

  /** Shows the voxel at the crosshair, unless one is selected. */
  look(engine: Engine, eye: Vector, yaw: number, pitch: number): void {
    if (this.#held === null) this.#show(engine, engine.raycast(eye, rayThrough(yaw, pitch, 0, 0), REACH, true));
  }

  /** Selects the voxel at a point of the screen; deselects at the sky. */
  hold(engine: Engine, eye: Vector, direction: Vector): void {
    this.#held = engine.raycast(eye, direction, REACH, true);
    this.#close.hidden = this.#held === null;
    this.#show(engine, this.#held);
  }

  /** False if none was selected. */
  letGo(): boolean {
    const had = this.#held !== null;
    this.#held = null;
    this.#close.hidden = true;
    return had;
  }

  clear(): void {
    this.letGo();
    this.#shown = null;
    this.#card.hidden = true;
  }

  #show(engine: Engine, hit: Hit | null): void {
    const same = hit !== null && this.#shown !== null && hit.x === this.#shown.x && hit.y === this.#shown.y &&
      hit.z === this.#shown.z && hit.material === this.#shown.material; // prettier-ignore
    if (!same && (hit !== null || this.#shown !== null)) engine.setSelection(hit);
    if (same) return;
    this.#shown = hit;
    this.#card.hidden = hit === null;
    if (hit === null) return;
    const material = engine.world.materials.find(({ id }) => id === hit.material);
    say(find('voxel-name'), material?.name ?? `material ${hit.material}`);
    say(find('voxel-at'), `${hit.x}, ${hit.y}, ${hit.z}`);
    find('voxel-colour').style.background = '#' + (material?.colour ?? 0).toString(16).padStart(6, '0');
    this.#card.dataset.material = String(hit.material);
  }
}
