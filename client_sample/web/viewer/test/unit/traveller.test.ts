// One who has just arrived is turned toward the best view, past what stands near; one who has looked around is not.
import { expect, test } from 'vitest';
import type { Server } from '../../src/connection/server';
import { Body, type Stuff } from '../../src/controls/body';
import type { Engine } from '../../src/engine/engine';
import { Traveller } from '../../src/place/traveller';

/** A tree in the north; `isHere`: the land has come. */
function arrival() {
  const land = { isHere: true };
  const engine = {
    world: { spawn: { x: 0, y: 10, z: 0 } },
    voxelAt: (x: number, _: number, z: number) => (!land.isHere ? undefined : Math.hypot(x, z + 20) < 3 ? 1 : 0),
    isSolid: (material: number) => material === 1,
  } as unknown as Engine;
  const body = new Body(() => 'gas');
  body.mode = 'fly';
  const server = { outlook: () => Promise.resolve(0) } as unknown as Server;
  const traveller = new Traveller(body, server, () => engine);
  [body.yaw, body.pitch] = [90, -8];
  traveller.toSpawn();
  return { body, traveller, engine, land };
}

test('the view is turned past a tree, once the land is here', async () => {
  const { body, traveller, engine, land } = arrival();
  land.isHere = false;
  await traveller.lookOut();
  traveller.turnFromWhatIsNear(engine);
  expect(body.yaw).toBe(0);
  land.isHere = true;
  traveller.turnFromWhatIsNear(engine);
  expect(body.yaw).toBe(15);
  // Once.
  body.yaw = 0;
  traveller.turnFromWhatIsNear(engine);
  expect(body.yaw).toBe(0);
});

test('who has looked around or moved keeps the view', async () => {
  const looked = arrival();
  const asked = looked.traveller.lookOut();
  looked.body.yaw = 3;
  await asked;
  looked.traveller.turnFromWhatIsNear(looked.engine);
  expect(looked.body.yaw).toBe(3);

  const moved = arrival();
  await moved.traveller.lookOut();
  moved.body.position[2] -= 1;
  moved.traveller.turnFromWhatIsNear(moved.engine);
  moved.body.position[2] += 1;
  moved.traveller.turnFromWhatIsNear(moved.engine);
  expect(moved.body.yaw).toBe(0);
});

/** Ground up to row 100, with a cave at 40 to 44; a server that knows the ground. */
function rock() {
  const land = { isHere: true, asked: 0 };
  const stuffAt = (_x: number, y: number): Stuff => (!land.isHere ? 'unknown' : y >= 100 || (y >= 40 && y < 45) ? 'gas' : 'solid');
  const body = new Body(stuffAt);
  body.mode = 'fly';
  const server = { ground: () => Promise.resolve((++land.asked, 100)) } as unknown as Server;
  return { body, land, traveller: new Traveller(body, server, () => null) };
}

test('a link into rock leads to the ground above it, once the land is here', async () => {
  const { body, land, traveller } = rock();
  land.isHere = false;
  await traveller.to(3.5, 60, 4.5);
  traveller.emerge();
  expect(body.position).toEqual([3.5, 60, 4.5]);
  land.isHere = true;
  traveller.emerge();
  await Promise.resolve();
  await Promise.resolve();
  expect(body.position).toEqual([3.5, 114, 4.5]);
  // Who flies into rock later wants to.
  body.place(3.5, 60, 4.5);
  traveller.emerge();
  await Promise.resolve();
  expect([body.position[1], land.asked]).toEqual([60, 1]);
});

test('a link into rock leads into the air close above; one into air leads there', async () => {
  const { body, land, traveller } = rock();
  for (const [from, to] of [[97, 100], [34, 40], [41, 41], [99, 99], [250, 250]] as const) {
    await traveller.to(0.5, from, 0.5);
    traveller.emerge();
    expect(body.position[1]).toBe(to);
  }
  expect(land.asked).toBe(0);
});
