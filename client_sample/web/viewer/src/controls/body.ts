// The player's body: walks, swims and flies through voxels. Independent of screen and clock, except for its steps.
import { overlaps, sweep, type Box, type Vector } from './sweep';
import type { Intent } from './intent';
import type { Mode } from '../place/place';

/** 'unknown': not loaded yet. Stops a walker, who would otherwise fall through land that is still loading. */
export type Stuff = 'gas' | 'liquid' | 'solid' | 'unknown';
export type StuffAt = (x: number, y: number, z: number) => Stuff;

// A voxel counts as a metre; times are in seconds.
const HALF_WIDTH = 0.3;
const HEIGHT = 1.8;
export const EYE = 1.62;
const WALK_SPEED = 5;
const RUN_SPEED = 9;
const SWIM_SPEED = 3.2;
const GRAVITY = 27;
const JUMP_SPEED = 8.6;
const FALL_SPEED = 55;
const STEP_UP = 1.02;
const TURN_RATE = 120;
const TILT_RATE = 80;
const LONGEST_STEP = 1 / 60;

export const FLY_SPEEDS = { slowest: 2, usual: 24, fastest: 600 };

const radians = Math.PI / 180;
const towards = (from: number, to: number, share: number) => from + (to - from) * share;

export class Body {
  /** Centre of the soles. */
  readonly position: Vector = [0, 0, 0];
  readonly velocity: Vector = [0, 0, 0];
  yaw = 0;
  pitch = 0;
  mode: Mode = 'fly';
  flySpeed = FLY_SPEEDS.usual;
  onGround = false;
  swimming = false;
  /** The land around the feet is not loaded yet. */
  waiting = false;
  /** Height by which the eyes lag behind a step of the feet: steps are climbed smoothly. */
  #lag = 0;

  constructor(private readonly stuffAt: StuffAt) {}

  get eye(): Vector {
    return [this.position[0], this.position[1] + EYE - this.#lag, this.position[2]];
  }

  place(x: number, y: number, z: number): void {
    this.position[0] = x;
    this.position[1] = y;
    this.position[2] = z;
    this.velocity.fill(0);
    this.#lag = 0;
  }

  step(seconds: number, intent: Intent): void {
    this.yaw = (((this.yaw + intent.yaw + intent.turn * TURN_RATE * seconds) % 360) + 360) % 360;
    this.pitch = Math.min(89.9, Math.max(-89.9, this.pitch + intent.pitch + intent.tilt * TILT_RATE * seconds));
    if (this.mode === 'fly') return this.#fly(seconds, intent);
    // A long frame is walked in small steps, so that walls are not skipped and jumps keep their height.
    const steps = Math.max(1, Math.ceil(seconds / LONGEST_STEP));
    for (let i = 0; i < steps; ++i) this.#walk(seconds / steps, intent);
  }

  /** True if it is in a box of voxels, both corners included. */
  isIn(first: { x: number; y: number; z: number }, last: { x: number; y: number; z: number }): boolean {
    const { low, high } = this.#box();
    const meets = (axis: 0 | 1 | 2, from: number, to: number) => from < high[axis] && low[axis] < to + 1;
    return meets(0, first.x, last.x) && meets(1, first.y, last.y) && meets(2, first.z, last.z);
  }

  /** True if the eyes are in a solid voxel; undefined: not known yet. */
  get isBuried(): boolean | undefined {
    const [x, y, z] = this.eye;
    return this.#is('unknown', x, y, z) ? undefined : this.#is('solid', x, y, z);
  }

  get speed(): number {
    return Math.hypot(...this.velocity);
  }

  /** Moves to the first free place at or above the feet, at most `reach` up; false if none is known. */
  rise(reach: number): boolean {
    const start = this.position[1];
    for (let up = 0; up <= reach; ++up) {
      this.position[1] = up === 0 ? start : Math.floor(start) + up;
      if (!overlaps(this.#box(), this.#blocks)) return true;
    }
    this.position[1] = start;
    return false;
  }

  #wish(intent: Intent): { x: number; z: number } {
    const [sin, cos] = [Math.sin(this.yaw * radians), Math.cos(this.yaw * radians)];
    const x = sin * intent.forward + cos * intent.right;
    const z = -cos * intent.forward + sin * intent.right;
    const length = Math.max(1, Math.hypot(x, z));
    return { x: x / length, z: z / length };
  }

  #fly(seconds: number, intent: Intent): void {
    const speed = this.flySpeed * (intent.fast ? 4 : 1);
    const level = Math.cos(this.pitch * radians);
    const ahead = this.#wish({ ...intent, forward: intent.forward * level });
    const up = Math.sin(this.pitch * radians) * intent.forward + intent.up;
    const wish: Vector = [ahead.x * speed, Math.max(-1, Math.min(1, up)) * speed, ahead.z * speed];
    const share = 1 - Math.exp(-seconds * 9);
    for (const axis of [0, 1, 2] as const) {
      const v = towards(this.velocity[axis], wish[axis], share);
      this.velocity[axis] = Math.abs(v) < 1e-3 ? 0 : v;
      this.position[axis] += this.velocity[axis] * seconds;
    }
    this.onGround = this.swimming = this.waiting = false;
    this.#lag = 0;
  }

  #walk(seconds: number, intent: Intent): void {
    this.#lag *= Math.exp(-seconds * 14);
    this.waiting = this.#isUnknown();
    if (this.waiting) {
      this.velocity.fill(0);
      return;
    }
    // Loaded land, or a change of mode, may enclose the body.
    if (overlaps(this.#box(), this.#blocks) && !this.rise(64)) {
      this.velocity.fill(0);
      return;
    }
    const [x, y, z] = this.position;
    this.swimming = this.#is('liquid', x, y + 0.9, z);
    const wading = this.swimming || this.#is('liquid', x, y + 0.3, z);
    const wish = this.#wish(intent);
    const speed = this.swimming ? SWIM_SPEED * (intent.fast ? 1.6 : 1) : intent.fast ? RUN_SPEED : WALK_SPEED;
    // In the air the player steers only a little; on the ground it stops at once.
    const share = 1 - Math.exp(-seconds * (this.swimming ? 5 : this.onGround ? 16 : 4));
    this.velocity[0] = towards(this.velocity[0], wish.x * speed, share);
    this.velocity[2] = towards(this.velocity[2], wish.z * speed, share);
    if (this.swimming) this.#swim(seconds, intent);
    else {
      this.velocity[1] = Math.max(-FALL_SPEED, this.velocity[1] - GRAVITY * seconds);
      if (intent.up > 0 && this.onGround) this.velocity[1] = JUMP_SPEED;
      else if (intent.up > 0 && wading && this.velocity[1] < 3) this.velocity[1] = 3;
    }
    this.#move(seconds, wading, intent);
  }

  #swim(seconds: number, intent: Intent): void {
    const dive = intent.forward > 0 ? Math.sin(this.pitch * radians) * intent.forward : 0;
    const sink = -0.6;
    const wish = Math.max(-1, Math.min(1, intent.up + dive)) * SWIM_SPEED + (intent.up === 0 ? sink : 0);
    this.velocity[1] = towards(this.velocity[1], wish, 1 - Math.exp(-seconds * 5));
  }

  #move(seconds: number, wading: boolean, intent: Intent): void {
    const fall = this.velocity[1] * seconds;
    const fell = this.#sweep(1, fall);
    const wasOnGround = this.onGround;
    this.onGround = fall < 0 && fell > fall;
    if (fell !== fall) this.velocity[1] = 0;
    for (const axis of [0, 2] as const) {
      const wanted = this.velocity[axis] * seconds;
      const gone = this.#sweep(axis, wanted);
      if (gone === wanted) continue;
      if ((this.onGround || wasOnGround) && this.#stepUp(axis, wanted - gone)) continue;
      this.velocity[axis] = 0;
      // Climbs out of the water at a bank.
      if (wading && intent.up > 0) this.velocity[1] = JUMP_SPEED;
    }
  }

  /** Climbs an edge of one voxel: up, forwards, and down to the ground. */
  #stepUp(axis: 0 | 2, rest: number): boolean {
    const before: Vector = [...this.position];
    const up = this.#sweep(1, STEP_UP);
    const on = this.#sweep(axis, rest);
    this.#sweep(1, -up);
    const risen = this.position[1] - before[1];
    if (Math.abs(on) < Math.abs(rest) * 0.5 || risen < 0.01 || this.#isUnknown()) {
      for (const i of [0, 1, 2] as const) this.position[i] = before[i];
      return false;
    }
    this.#lag += risen;
    this.onGround = true;
    if (this.velocity[1] < 0) this.velocity[1] = 0;
    return true;
  }

  #sweep(axis: 0 | 1 | 2, distance: number): number {
    const gone = sweep(this.#box(), axis, distance, this.#blocks);
    this.position[axis] += gone;
    return gone;
  }

  #box(): Box {
    const [x, y, z] = this.position;
    return { low: [x - HALF_WIDTH, y, z - HALF_WIDTH], high: [x + HALF_WIDTH, y + HEIGHT, z + HALF_WIDTH] };
  }

  readonly #blocks = (x: number, y: number, z: number) => {
    const stuff = this.stuffAt(x, y, z);
    return stuff === 'solid' || stuff === 'unknown';
  };

  #is(stuff: Stuff, x: number, y: number, z: number): boolean {
    return this.stuffAt(Math.floor(x), Math.floor(y), Math.floor(z)) === stuff;
  }

  #isUnknown(): boolean {
    const [x, y, z] = this.position;
    return this.#is('unknown', x, y, z) || this.#is('unknown', x, y + EYE, z) || this.#is('unknown', x, y - 0.5, z);
  }
}
