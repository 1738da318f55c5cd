// The player: a body in the engine's voxels, moved by keys, mouse and fingers.
import type { Engine } from '../engine/engine';
import { Body, FLY_SPEEDS, type Stuff } from './body';
import { rest, type Device } from './intent';

const radians = Math.PI / 180;

export class Player {
  readonly body = new Body((x, y, z) => this.stuffAt(x, y, z));
  readonly #devices: Device[] = [];
  #engine: Engine | null = null;
  /** The player moved or turned by hand since the page was opened. */
  hasMoved = false;

  add(device: Device): void {
    this.#devices.push(device);
  }

  enter(engine: Engine | null): void {
    this.#engine = engine;
  }

  step(seconds: number): void {
    const intent = rest();
    for (const device of this.#devices) device.read(intent);
    this.hasMoved ||= intent.forward !== 0 || intent.right !== 0 || intent.up !== 0 || intent.turn !== 0 || intent.tilt !== 0 || intent.yaw !== 0; // prettier-ignore
    this.body.step(seconds, intent);
  }

  release(): void {
    for (const device of this.#devices) device.release();
  }

  look(engine: Engine): void {
    const [x, y, z] = this.body.eye;
    engine.setCamera(x, y, z, this.body.yaw * radians, this.body.pitch * radians);
  }

  toggleMode(): void {
    const { body } = this;
    body.mode = body.mode === 'walk' ? 'fly' : 'walk';
    body.velocity.fill(0);
  }

  changeSpeed(notches: number): void {
    const speed = this.body.flySpeed * 1.25 ** notches;
    this.body.flySpeed = Math.min(FLY_SPEEDS.fastest, Math.max(FLY_SPEEDS.slowest, speed));
  }

  /** Material class of a base voxel. */
  stuffAt(x: number, y: number, z: number): Stuff {
    const engine = this.#engine;
    if (engine === null) return 'unknown';
    const material = engine.voxelAt(x, y, z);
    if (material === undefined) return y < engine.world.minY ? 'solid' : 'unknown';
    return engine.isSolid(material) ? 'solid' : engine.isLiquid(material) ? 'liquid' : 'gas';
  }
}
