// Digging and building: tools, targets, history and messages. The page's edit bar displays it.
import type { EditLimits, Material, TalusError } from 'talus';
import type { Body } from '../controls/body';
import type { Engine, Hit, Marker, Vector } from '../engine/engine';
import { History, pairsThatFit, undoing, type VoxelEdit } from './history';
import { aim, AIR, boxOf, eachVoxel, FILL_MAX, sidesOf, voxelOf, volumeOf, type Box, type Tool } from './target';

/** Blocks: near enough to see the result. */
export const REACH = 40;
/** Blocks per second: too fast to aim above this. */
const FASTEST = 12;
/** Maximum edits waiting for the server. */
const WAITING_MAX = 256;
const DIG_COLOUR = 0xff9d6a;
const WRONG_COLOUR = 0xff5548;

export interface Listener {
  /** Mode, tool, palette or material changed. */
  changed(): void;
  say(text: string, isBad: boolean): void;
}

const place = ({ x, y, z }: Vector) => `${x}, ${y}, ${z}`;
const sentence = (text: string) => text.charAt(0).toUpperCase() + text.slice(1) + (/[.!?]$/.test(text) ? '' : '.');

const refusal = (reason: string) =>
  /no right to edit/.test(reason) ? 'This server lets only invited players build.' : sentence(`You may look, but not dig and build here: ${reason}`);

export class Builder {
  isOn = false;
  tool: Tool = 'dig';
  material = AIR;
  palette: readonly Material[] = [];
  /** Unanswered edits. */
  waiting = 0;
  #engine: Engine | null = null;
  #limits: EditLimits | null = null;
  /** The server's reason why this player may not edit; null: it gave none. */
  #forbidden: string | null = null;
  #corner: Vector | null = null;
  #said = '';
  readonly #history = new History();

  constructor(
    private readonly body: Body,
    private readonly listener: Listener,
  ) {}

  /** Another engine, or none: edits of the previous one cannot be undone in it. */
  enter(engine: Engine | null): void {
    this.#engine = engine;
    this.#history.clear();
    this.waiting = 0;
    if (this.isOn) this.#off();
    if (engine === null) return;
    const rank = ({ id, phase }: Material) => (id === AIR ? 0 : phase === 'solid' ? 1 : 2);
    this.palette = engine.world.materials
      .filter(({ id, phase }) => id === AIR || phase !== 'gas')
      .sort((a, b) => rank(a) - rank(b) || a.id - b.id);
    if (!this.palette.some(({ id }) => id === this.material) || this.material === AIR) {
      this.material = this.palette[1]?.id ?? AIR;
    }
    void this.ask();
  }

  /** Reason why there are no tools; null: there may be tools. */
  get whyNot(): string | null {
    return this.#impossible ?? this.#forbidden;
  }

  /** Reason that no permission can remove. */
  get #impossible(): string | null {
    return this.#engine === null ? 'The world is not here yet.' : this.#engine.whyNoEdits;
  }

  /** Asks the server whether this player may edit; returns the reason if not. */
  async ask(): Promise<string | null> {
    const engine = this.#engine;
    this.#forbidden = null;
    let wrong = this.#impossible;
    if (engine !== null && wrong === null) {
      try {
        const limits = await engine.editLimits();
        if (engine === this.#engine) this.#limits = limits;
      } catch (error) {
        const { kind, message } = error as TalusError;
        wrong = kind === 'refused' ? refusal(message.replace(/^the server says: /, '')) : sentence(message);
        if (engine === this.#engine && kind === 'refused') this.#forbidden = wrong;
      }
    }
    if (engine === this.#engine) this.listener.changed();
    return wrong;
  }

  async toggle(): Promise<void> {
    if (this.isOn) return this.#off();
    const engine = this.#engine;
    // Asked again, as permission may have been granted since.
    const wrong = await this.ask();
    if (engine !== this.#engine || this.isOn) return;
    if (wrong !== null) return this.#say(wrong, true);
    this.isOn = true;
    this.listener.changed();
  }

  #off(): void {
    this.isOn = false;
    this.#corner = null;
    this.#engine?.setMarker(null);
    this.listener.changed();
  }

  /** False if there was no corner. */
  cancel(): boolean {
    const had = this.#corner !== null;
    this.#corner = null;
    return had;
  }

  choose(tool: Tool): void {
    this.tool = tool;
    this.#corner = null;
    this.listener.changed();
  }

  nextTool(): void {
    const tools: Tool[] = ['dig', 'build', 'fill'];
    this.choose(tools[(tools.indexOf(this.tool) + 1) % tools.length]!);
  }

  chooseMaterial(id: number): void {
    if (!this.palette.some((material) => material.id === id)) return;
    this.material = id;
    if (this.tool === 'dig' && id !== AIR) this.tool = 'build';
    this.listener.changed();
  }

  /** By index in the palette, from 0. */
  chooseSwatch(index: number): void {
    const material = this.palette[index];
    if (material !== undefined) this.chooseMaterial(material.id);
  }

  turn(swatches: number): void {
    const { length } = this.palette;
    const at = this.palette.findIndex(({ id }) => id === this.material);
    if (length > 0) this.chooseSwatch((((at + swatches) % length) + length) % length);
  }

  /** Picks the material of the voxel in view. */
  sample(eye: Vector, direction: Vector): void {
    const hit = this.#engine?.raycast(eye, direction, REACH, true);
    if (hit) this.chooseMaterial(hit.material);
  }

  // ---- target

  /** Marks the voxels that an edit would change. */
  look(eye: Vector, direction: Vector): void {
    if (!this.isOn || this.#engine === null) return;
    const hit = this.#engine.raycast(eye, direction, REACH);
    const voxel = hit && aim(hit, this.tool, this.material);
    this.#engine.setMarker(voxel === null ? null : this.#markerOf(voxel));
  }

  #markerOf(voxel: Vector): Marker {
    const takes = this.tool === 'dig' || this.material === AIR;
    const box = boxOf(this.tool === 'fill' ? (this.#corner ?? voxel) : voxel, voxel);
    const fits = volumeOf(box) <= this.#fillMax && (takes || !this.body.isIn(box.first, box.last));
    const colour = takes ? DIG_COLOUR : (this.palette.find(({ id }) => id === this.material)?.colour ?? 0xffffff);
    if (!fits) return { ...box, colour: WRONG_COLOUR, edge: WRONG_COLOUR, veil: 0.3 };
    return { ...box, colour, edge: takes ? DIG_COLOUR : 0xffffff, veil: takes ? 0.14 : 0.55 };
  }

  get #fillMax(): number {
    const { voxels = 0 } = this.#limits ?? {};
    return voxels > 0 ? Math.min(voxels, FILL_MAX) : FILL_MAX;
  }

  // ---- actions

  /** Applies the tool along a ray; `other`: digs if the tool builds, and builds if it digs. */
  act(eye: Vector, direction: Vector, other = false): void {
    const engine = this.#engine;
    if (!this.isOn || engine === null) return;
    if (this.body.speed > FASTEST) return this.#say('Slow down to dig and build.', true);
    if (this.waiting >= WAITING_MAX) return this.#say('Much waits for the server already.', true);
    const hit = engine.raycast(eye, direction, REACH);
    if (hit === null) return this.#say('Nothing is near enough there.', false);
    const tool = !other ? this.tool : this.tool === 'dig' ? 'build' : 'dig';
    if (tool === 'fill') return this.#corners(engine, hit);
    const voxel = aim(hit, tool, this.material);
    if (voxel !== null) this.#change(engine, boxOf(voxel, voxel), tool === 'dig' ? AIR : this.material);
  }

  #corners(engine: Engine, hit: Hit): void {
    const voxel = aim(hit, 'fill', this.material);
    if (voxel === null) return;
    if (this.#corner === null) {
      this.#corner = voxelOf(voxel);
      return this.#say(`From ${place(voxel)}: now the other corner.`, false);
    }
    const box = boxOf(this.#corner, voxel);
    if (volumeOf(box) > this.#fillMax) {
      return this.#say(`${sidesOf(box).join(' × ')} voxels are too many: at most ${this.#fillMax} at once.`, true);
    }
    if (this.#change(engine, box, this.material)) this.#corner = null;
  }

  #change(engine: Engine, box: Box, material: number): boolean {
    if (material !== AIR && this.body.isIn(box.first, box.last)) {
      this.#say('You stand there yourself.', true);
      return false;
    }
    const made: VoxelEdit[] = [];
    let isHere = true;
    eachVoxel(box, (voxel) => {
      const before = engine.voxelAt(voxel.x, voxel.y, voxel.z);
      if (before === undefined) isHere = false;
      else if (before !== material) made.push({ voxel, before, after: material });
    });
    if (!isHere) {
      this.#say('The land there is not here yet.', true);
      return false;
    }
    if (made.length === 0) return true;
    const step = this.#history.push(made);
    // A single voxel is changed only if it is still the one seen.
    const edit =
      made.length === 1
        ? { guards: made.map(({ voxel, before }) => ({ voxel, material: before })), writes: [{ voxel: made[0]!.voxel, material }] }
        : { fills: [{ ...box, material }] };
    this.#send(engine, edit, made.map(({ voxel }) => ({ ...voxel, material })), (kind, text) => {
      this.#history.remove(step);
      this.listener.changed();
      this.#say(kind === 'conflict' ? 'Somebody changed that before you: it is as they left it.' : text, true);
    });
    this.listener.changed();
    return true;
  }

  undo(): void {
    const engine = this.#engine;
    if (!this.isOn || engine === null || this.waiting >= WAITING_MAX) return;
    const step = this.#history.pop();
    this.listener.changed();
    if (step === undefined) return this.#say('Nothing of yours is left to undo.', false);
    // Voxels visibly changed by others are kept; guards cover changes in flight.
    const mine = step.made.filter(({ voxel, after }) => engine.voxelAt(voxel.x, voxel.y, voxel.z) === after);
    const stayed = step.made.length - mine.length;
    if (mine.length === 0) return this.#say('Not undone: somebody has changed it since.', true);
    if (mine.some(({ voxel, before }) => engine.isSolid(before) && this.body.isIn(voxel, voxel))) {
      this.#history.push(step.made);
      return this.#say('You stand where it would come back: step aside.', true);
    }
    if (stayed > 0) this.#say(`Undone but for ${stayed} ${stayed === 1 ? 'voxel' : 'voxels'} that somebody has changed since.`, true);
    const most = pairsThatFit(engine.world.limits.frameBytes, this.#limits?.voxels ?? 0);
    for (const { edit, made } of undoing(mine, most)) {
      const changes = made.map(({ voxel, before }) => ({ ...voxel, material: before }));
      this.#send(engine, edit, changes, (kind, text) => {
        this.#say(kind === 'conflict' ? 'Not undone: somebody has changed it since.' : text, true);
      });
    }
  }

  get canUndo(): boolean {
    return !this.#history.isEmpty;
  }

  #send(engine: Engine, edit: Parameters<Engine['edit']>[0], changes: Parameters<Engine['edit']>[1], failed: (kind: TalusError['kind'], text: string) => void): void {
    ++this.waiting;
    engine
      .edit(edit, changes)
      .catch((error: TalusError) => {
        if (engine !== this.#engine) return;
        failed(error.kind, sentence(error.message.replace(/^the server says: /, '')));
        // The tools go only if editing is impossible.
        if (error.kind === 'refused') void this.ask().then((wrong) => wrong !== null && engine === this.#engine && this.isOn && this.#off());
      })
      .finally(() => {
        if (engine === this.#engine) --this.waiting;
      });
  }

  #say(text: string, isBad: boolean): void {
    this.#said = text;
    this.listener.say(text, isBad);
  }

  /** The last message. */
  get said(): string {
    return this.#said;
  }
}
