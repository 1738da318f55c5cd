import { expect, test } from 'vitest';
import { Body, type StuffAt } from '../../src/controls/body';
import { rest, type Intent } from '../../src/controls/intent';

const FRAME = 1 / 60;

function walker(stuffAt: StuffAt, y = 0): Body {
  const body = new Body(stuffAt);
  body.mode = 'walk';
  body.place(0.5, y, 0.5);
  return body;
}

function go(body: Body, seconds: number, intent: Partial<Intent> = {}): void {
  for (let t = 0; t < seconds; t += FRAME) body.step(FRAME, { ...rest(), ...intent });
}

const plain: StuffAt = (_x, y) => (y < 0 ? 'solid' : 'gas');

test('a walker falls to the ground and stays there', () => {
  const body = walker(plain, 12);
  go(body, 3);
  expect(body.position[1]).toBeCloseTo(0, 3);
  expect(body.onGround).toBe(true);
});

test('walks north for yaw 0, east for yaw 90', () => {
  const body = walker(plain);
  go(body, 2, { forward: 1 });
  expect(body.position[2]).toBeLessThan(-7);
  body.yaw = 90;
  const [x] = body.position;
  go(body, 2, { forward: 1 });
  expect(body.position[0] - x).toBeGreaterThan(7);
});

test('steps up one voxel, and not two', () => {
  const stairs: StuffAt = (_x, y, z) => (y < (z < -6 ? 3 : z < -3 ? 1 : 0) ? 'solid' : 'gas');
  const body = walker(stairs);
  go(body, 4, { forward: 1 });
  expect(body.position[1]).toBeCloseTo(1, 3);
  expect(body.position[2]).toBeCloseTo(-5.7, 2);
});

test('does not step up where its head would hit', () => {
  const low: StuffAt = (_x, y, z) => (y < (z < -3 ? 1 : 0) || (z < -3 && y === 2) ? 'solid' : 'gas');
  const body = walker(low);
  go(body, 3, { forward: 1 });
  expect(body.position[1]).toBeCloseTo(0, 3);
  expect(body.position[2]).toBeGreaterThan(-2.8);
});

test('jumps over one voxel as high whatever the frame takes', () => {
  const heights = [1 / 144, 1 / 60, 1 / 15, 0.25].map((frame) => {
    const body = walker(plain);
    go(body, 0.2);
    let highest = 0;
    for (let t = 0; t < 0.5; t += frame) {
      body.step(frame, { ...rest(), up: t === 0 ? 1 : 0 });
      highest = Math.max(highest, body.position[1]);
    }
    return highest;
  });
  // A coarse frame may miss the top, never pass it.
  for (const height of heights) expect(height).toBeLessThan(1.6);
  expect(heights[0]).toBeGreaterThan(1.2);
  expect(heights[1]).toBeGreaterThan(1.2);
});

test('holds where the land is not here yet, and goes on when it comes', () => {
  let here = false;
  const body = walker((x, y, z) => (here ? plain(x, y, z) : 'unknown'), 40);
  go(body, 2, { forward: 1 });
  expect(body.position).toEqual([0.5, 40, 0.5]);
  expect(body.waiting).toBe(true);
  here = true;
  go(body, 4);
  expect(body.position[1]).toBeCloseTo(0, 3);
});

test('does not walk into land that is not here', () => {
  const edge: StuffAt = (x, y, z) => (z < -4 ? 'unknown' : plain(x, y, z));
  const body = walker(edge);
  go(body, 4, { forward: 1 });
  expect(body.position[2]).toBeCloseTo(-3.7, 2);
});

test('land that came around it lifts it to the top', () => {
  const hill: StuffAt = (_x, y) => (y < 9 ? 'solid' : 'gas');
  const body = walker(hill, 2);
  go(body, 1);
  expect(body.position[1]).toBeCloseTo(9, 3);
});

test('swims: sinks slowly, rises when asked, gets out at a bank of one voxel', () => {
  const pond: StuffAt = (_x, y, z) => (y < (z < -5 ? 1 : -9) ? 'solid' : y < 0 ? 'liquid' : 'gas');
  const body = walker(pond, -4);
  go(body, 1);
  expect(body.swimming).toBe(true);
  expect(body.position[1]).toBeGreaterThan(-5);
  expect(body.position[1]).toBeLessThan(-4.2);
  go(body, 5, { up: 1 });
  expect(body.position[1]).toBeGreaterThan(-1.5);
  go(body, 6, { up: 1, forward: 1 });
  expect(body.position[2]).toBeLessThan(-5);
  expect(body.position[1]).toBeGreaterThanOrEqual(1);
});

test('flies where it looks', () => {
  const body = new Body(plain);
  body.place(0, 100, 0);
  body.pitch = -45;
  go(body, 2, { forward: 1 });
  expect(body.position[1]).toBeLessThan(80);
  expect(body.position[2]).toBeLessThan(-20);
  expect(body.position[0]).toBeCloseTo(0, 6);
});

test('turning by keys: a second is 120 degrees', () => {
  const body = walker(plain);
  go(body, 1, { turn: 1 });
  expect(body.yaw).toBeCloseTo(120, -1);
});
