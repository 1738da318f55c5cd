// Brings the player somewhere: to a coordinate, to what a link names, to the spawn.
import type { Server } from '../connection/server';
import type { Body } from '../controls/body';
import type { Engine } from '../engine/engine';
import { clearHeading } from './outlook';
import type { Place } from './place';

const SPAWN_RISE = 14;
/** Blocks above a place in rock within which air is nearer than the ground. */
const NEAR_AIR = 16;

export class Traveller {
  /** The player is somewhere; before, the engine is not to be looked through. */
  isPlaced = false;
  /** Whether one is to be lifted out of water, once it is known whether there is any. */
  #surfaces = false;
  /** Whether one is to be lifted out of rock, once it is known whether there is any. */
  #emerges = false;
  /** Where one who has just arrived stands and looks, until it is known whether something near hides the view. */
  #arrival: Place | null = null;

  constructor(
    private readonly body: Body,
    private readonly server: Server,
    private readonly engine: () => Engine | null,
  ) {}

  place(time: number): Place {
    const [x, y, z] = this.body.position;
    const { yaw, pitch, mode } = this.body;
    return { x, y, z, yaw, pitch, time, mode };
  }

  /** To the ground of a column where y is null. */
  async to(x: number, y: number | null, z: number): Promise<void> {
    this.#put(x, y ?? (await this.#onGround(x, z)), z, y === null);
  }

  async #onGround(x: number, z: number): Promise<number> {
    const ground = Math.max(await this.server.ground(x, z), this.engine()?.world.seaLevel ?? -Infinity);
    return ground + this.#rise;
  }

  #put(x: number, y: number, z: number, byGround: boolean): void {
    this.body.place(x, y, z);
    this.#surfaces = byGround;
    this.#emerges = !byGround;
    this.isPlaced = true;
  }

  toSpawn(): void {
    const engine = this.engine();
    if (engine === null) return;
    const { x, y, z } = engine.world.spawn;
    this.body.place(x + 0.5, y + this.#rise, z + 0.5);
    this.#surfaces = this.#emerges = false;
    this.#arrival = null;
    this.isPlaced = true;
  }

  /** Turns one who has just arrived, and has not looked around yet, toward the best view. */
  async lookOut(): Promise<void> {
    const start = this.place(0);
    let best = start.yaw;
    try {
      best = await this.server.outlook(start.x, start.z);
    } catch {
      // A server that gives no heights: north is as good.
    }
    if (!this.#isStillAt(start)) return;
    this.body.yaw = best;
    this.#arrival = this.place(0);
  }

  /** For each step. The outlook is by heights, which know no trees. */
  turnFromWhatIsNear(engine: Engine): void {
    const arrival = this.#arrival;
    if (arrival === null) return;
    if (this.#isStillAt(arrival)) {
      const at = (x: number, y: number, z: number) => engine.voxelAt(x, y, z);
      const heading = clearHeading(this.body.eye, arrival.yaw, arrival.pitch, at, (material) => engine.isSolid(material));
      if (heading === undefined) return;
      this.body.yaw = heading;
    }
    this.#arrival = null;
  }

  #isStillAt(then: Place): boolean {
    const now = this.place(0);
    return (['x', 'y', 'z', 'yaw', 'pitch'] as const).every((key) => now[key] === then[key]);
  }

  /** For each step. Heights are those of the ground: water may stand on it. */
  surface(engine: Engine): void {
    if (!this.#surfaces) return;
    const [x, y, z] = this.body.position;
    const at = (row: number) => engine.voxelAt(Math.floor(x), row, Math.floor(z));
    let row = Math.floor(y);
    while (engine.isLiquid(at(row) ?? 0)) ++row;
    if (at(row) === undefined) return;
    this.#surfaces = false;
    if (row > y) this.body.place(x, row + this.#rise, z);
  }

  /** For each step. A link may lead into rock, where one would see the land from inside: to air close above, else to the ground. */
  emerge(): void {
    if (!this.#emerges) return;
    const { isBuried, position } = this.body;
    if (isBuried === undefined) return;
    this.#emerges = false;
    if (!isBuried || this.body.rise(NEAR_AIR)) return;
    // Without heights one stays: flying leads out.
    const [x, y, z] = position;
    this.#onGround(x, z)
      .then((row) => {
        const now = this.body.position;
        // Who went elsewhere meanwhile stays there.
        if (now[0] === x && now[1] === y && now[2] === z) this.#put(x, row, z, true);
      })
      .catch(() => {});
  }

  get #rise(): number {
    return this.body.mode === 'fly' ? SPAWN_RISE : 0;
  }
}
