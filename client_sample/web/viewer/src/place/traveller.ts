// Moves the player: to coordinates, to a link's place, to the spawn.
import type { Server } from '../connection/server';
import type { Body } from '../controls/body';
import type { Engine } from '../engine/engine';
import { clearHeading } from './outlook';
import type { Place } from './place';

const SPAWN_RISE = 14;
/** Height in blocks above a place in rock up to which air is preferred to the ground. */
const NEAR_AIR = 16;

export class Traveller {
  /** The player has a position; before that, the engine must not be used for views. */
  isPlaced = false;
  /** True if the player must be lifted out of water, once it is known whether there is any. */
  #surfaces = false;
  /** True if the player must be lifted out of rock, once it is known whether there is any. */
  #emerges = false;
  /** Position and view on arrival, until it is known whether something near hides the view. */
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

  /** To the ground of a column if y is null. */
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

  /** Turns a player who just arrived, and has not looked around yet, towards the best view. */
  async lookOut(): Promise<void> {
    const start = this.place(0);
    let best = start.yaw;
    try {
      best = await this.server.outlook(start.x, start.z);
    } catch {
      // Without heights, north is as good as any.
    }
    if (!this.#isStillAt(start)) return;
    this.body.yaw = best;
    this.#arrival = this.place(0);
  }

  /** Call for each step. The outlook uses heights, which do not include trees. */
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

  /** Call for each step. Heights are the ground's: there may be water above. */
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

  /** Call for each step. A link may lead into rock: moves to air close above, otherwise to the ground. */
  emerge(): void {
    if (!this.#emerges) return;
    const { isBuried, position } = this.body;
    if (isBuried === undefined) return;
    this.#emerges = false;
    if (!isBuried || this.body.rise(NEAR_AIR)) return;
    // Without heights the player stays: flying leads out.
    const [x, y, z] = position;
    this.#onGround(x, z)
      .then((row) => {
        const now = this.body.position;
        // Unless the player went elsewhere meanwhile.
        if (now[0] === x && now[1] === y && now[2] === z) this.#put(x, row, z, true);
      })
      .catch(() => {});
  }

  get #rise(): number {
    return this.body.mode === 'fly' ? SPAWN_RISE : 0;
  }
}
