// Digging and building, with an engine that is a map of voxels and a server that the test plays.
import { beforeEach, describe, expect, it } from 'vitest';
import { Body } from '../../../src/controls/body.js';
import { Builder } from '../../../src/edit/builder.js';
import type { Engine, Hit, Marker } from '../../../src/engine/engine.js';

type Sent = { edit: Parameters<Engine['edit']>[0]; changes: Parameters<Engine['edit']>[1]; answer: (error?: object) => void };

const eye = { x: 0.5, y: 12.5, z: 0.5 };
const down = { x: 0, y: -1, z: 0 };
const flush = () => new Promise((resolve) => setTimeout(resolve));

describe('building', () => {
  let voxels: Map<string, number>;
  let sent: Sent[];
  let said: string[];
  let marker: Marker | null;
  let hit: Hit | null;
  let why: string | null;
  let limits: () => Promise<object>;
  let body: Body;
  let builder: Builder;
  const key = (x: number, y: number, z: number) => `${x} ${y} ${z}`;
  const at = (x: number, y: number, z: number) => voxels.get(key(x, y, z)) ?? (y < 5 ? 1 : 0);
  const look = (x: number, z: number) => {
    let y = 12;
    while (at(x, y, z) === 0) --y;
    hit = { x, y, z, material: at(x, y, z), distance: 1, normal: { x: 0, y: 1, z: 0 } };
  };
  const engine = {
    get whyNoEdits() {
      return why;
    },
    world: {
      limits: { frameBytes: 65_536 },
      materials: [
        { id: 2, name: 'sea', colour: 1, phase: 'liquid' },
        { id: 0, name: 'air', colour: 0, phase: 'gas' },
        { id: 1, name: 'rock', colour: 7, phase: 'solid' },
        { id: 3, name: 'planks', colour: 9, phase: 'solid' },
      ],
    },
    editLimits: () => limits(),
    raycast: () => hit,
    voxelAt: at,
    isSolid: (material: number) => material === 1 || material === 3,
    setMarker: (to: Marker | null) => (marker = to),
    edit: (edit: Sent['edit'], changes: Sent['changes']) => {
      const before = changes.map(({ x, y, z }) => [key(x, y, z), at(x, y, z)] as const);
      for (const { x, y, z, material } of changes) voxels.set(key(x, y, z), material);
      return new Promise((resolve, reject) =>
        sent.push({
          edit,
          changes,
          answer: (error) => {
            if (error === undefined) return resolve({ revision: 1n, changed: changes.length });
            for (const [name, material] of before) voxels.set(name, material);
            reject(error);
          },
        }),
      );
    },
  } as unknown as Engine;

  beforeEach(async () => {
    [voxels, sent, said, marker, hit, why] = [new Map(), [], [], null, null, null];
    limits = async () => ({ voxels: 65_536, chunks: 64, unanswered: 64, voxelsPerSecond: 0 });
    body = new Body(() => 'gas');
    body.place(0.5, 10, 0.5);
    builder = new Builder(body, { changed: () => {}, say: (text) => said.push(text) });
    builder.enter(engine);
    await builder.toggle();
  });

  it('has air first, then what is solid, then liquids', () => {
    expect(builder.palette.map(({ name }) => name)).toEqual(['air', 'rock', 'planks', 'sea']);
    expect(builder.material).toBe(1);
    builder.turn(-2);
    expect(builder.material).toBe(2);
  });
  it('digs what one sees, and nothing else', () => {
    look(4, 4);
    builder.act(eye, down);
    const voxel = { x: 4, y: 4, z: 4 };
    expect(sent[0]!.edit).toEqual({ guards: [{ voxel, material: 1 }], writes: [{ voxel, material: 0 }] });
    expect(at(4, 4, 4)).toBe(0);
  });
  it('builds before the face, by the right button while the tool digs', () => {
    look(4, 4);
    builder.chooseMaterial(3);
    builder.choose('dig');
    builder.act(eye, down, true);
    expect(sent[0]!.changes).toEqual([{ x: 4, y: 5, z: 4, material: 3 }]);
  });
  it('builds not into oneself, and neither digs nor builds in a hurry', () => {
    body.place(4.5, 5, 4.5);
    look(4, 4);
    builder.choose('build');
    builder.act(eye, down);
    builder.look(eye, down);
    expect([said.at(-1), marker!.edge]).toEqual(['You stand there yourself.', 0xff5548]);
    builder.choose('dig');
    body.velocity[0] = 30;
    builder.act(eye, down);
    expect(said.at(-1)).toMatch(/Slow down/);
    expect(sent).toEqual([]);
  });
  it('fills between two corners, and undoes that but for what is another\'s now', () => {
    look(2, 2);
    builder.choose('fill');
    builder.chooseMaterial(3);
    builder.act(eye, down);
    look(4, 6);
    builder.look(eye, down);
    expect([marker!.first, marker!.last]).toEqual([{ x: 2, y: 5, z: 2 }, { x: 4, y: 5, z: 6 }]);
    builder.act(eye, down);
    expect(sent[0]!.edit).toEqual({ fills: [{ first: { x: 2, y: 5, z: 2 }, last: { x: 4, y: 5, z: 6 }, material: 3 }] });
    voxels.set(key(3, 5, 3), 1);
    builder.undo();
    expect(sent[1]!.edit.guards).toHaveLength(14);
    expect(sent[1]!.edit.guards!.every(({ material }) => material === 3)).toBe(true);
    expect([at(3, 5, 3), at(2, 5, 2)]).toEqual([1, 0]);
    expect(said.at(-1)).toMatch(/but for 1 voxel/);
  });
  it('refuses fills of too much, and forgets a corner where told', () => {
    look(0, 0);
    builder.choose('fill');
    builder.act(eye, down);
    look(90, 90);
    builder.act(eye, down);
    expect(said.at(-1)).toMatch(/91 × 1 × 91 voxels are too many/);
    expect([builder.cancel(), builder.cancel(), sent.length]).toEqual([true, false, 0]);
  });
  it('says what the server refuses, and has nothing to undo then', async () => {
    look(4, 4);
    builder.act(eye, down);
    sent[0]!.answer({ kind: 'conflict', message: '' });
    await flush();
    expect([said.at(-1), builder.canUndo, builder.waiting, at(4, 4, 4)]).toEqual(['Somebody changed that before you: it is as they left it.', false, 0, 1]);
    builder.act(eye, down);
    sent[1]!.answer({ kind: 'refused', message: 'the server says: not in this box' });
    await flush();
    expect([said.at(-1), builder.isOn, at(4, 4, 4)]).toEqual(['Not in this box.', true, 1]);
    builder.act(eye, down);
    limits = () => Promise.reject({ kind: 'refused', message: 'the server says: no right any more' });
    sent[2]!.answer({ kind: 'refused', message: 'the server says: no right any more' });
    await flush();
    expect([said.at(-1), builder.isOn]).toEqual(['No right any more.', false]);
  });
  it('says that an undo was refused', async () => {
    look(4, 4);
    builder.act(eye, down);
    sent[0]!.answer();
    builder.undo();
    sent[1]!.answer({ kind: 'conflict', message: '' });
    await flush();
    expect(said.at(-1)).toBe('Not undone: somebody has changed it since.');
    builder.undo();
    expect(said.at(-1)).toMatch(/Nothing of yours/);
  });
  it('has no tools where nobody may edit, and says why', async () => {
    await builder.toggle();
    why = 'This server keeps no edits.';
    await builder.toggle();
    expect([builder.isOn, said.at(-1)]).toEqual([false, why]);
    why = null;
    limits = () => Promise.reject({ kind: 'refused', message: 'the server says: the token lacks the right edit' });
    await builder.toggle();
    expect([builder.isOn, said.at(-1)]).toEqual([false, 'You may look, but not dig and build here: the token lacks the right edit.']);
  });
  it('knows from the start that one has no right, and asks again when one tries', async () => {
    limits = () => Promise.reject({ kind: 'refused', message: 'the server says: this session has no right to edit: nothing gives it' });
    builder.enter(engine);
    expect(builder.whyNot).toBeNull();
    await flush();
    expect(builder.whyNot).toBe('This server lets only invited players build.');
    await builder.toggle();
    expect([builder.isOn, said.at(-1)]).toEqual([false, 'This server lets only invited players build.']);
    limits = async () => ({ voxels: 1 });
    await builder.toggle();
    expect([builder.isOn, builder.whyNot]).toEqual([true, null]);
  });
});
