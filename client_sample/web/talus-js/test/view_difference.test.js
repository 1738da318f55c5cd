// What enters and leaves from one View to the next: exactly what a walk through all chunks finds, each chunk once.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Tracker } from '../dist/client/tracker.js';
import { chunksOutside, countOf, forEachChunk } from '../dist/view_difference.js';
import { checkedView, ringsBetween, ViewShape } from '../dist/view_shape.js';
import { random as seeded } from './support/random.js';

const heights = { minY: -100, maxY: 700 };
const nameOf = ({ lod, x, y, z }) => `${lod}/${x}/${y}/${z}`;
const within = (next, least, most) => least + next(most - least + 1);
const chance = (next, percent) => next(100) < percent;

function randomView(next, near) {
  const horizontalRadius = within(next, 0, 4);
  const edge = chance(next, 10) ? 32 * 2 ** 31 - 64 : 0; // of the world
  const step = [2, 40, 200, 5_000][within(next, 0, 3)];
  const from = near?.centre ?? { x: edge, y: 300, z: -edge };
  return checkedView({
    centre: {
      x: from.x + within(next, -step, step),
      y: from.y + (chance(next, 30) ? within(next, -200, 200) : 0),
      z: from.z + within(next, -step, step),
    },
    // Often the shape stays, and moves alone.
    ...(near !== null && chance(next, 60)
      ? { horizontalRadius: near.horizontalRadius, verticalRadius: near.verticalRadius, rings: near.rings, horizon: near.horizon }
      : {
          horizontalRadius,
          verticalRadius: within(next, 0, 3),
          rings: ringsBetween(horizontalRadius, horizontalRadius + within(next, 0, 30)).filter(() => chance(next, 70)),
          horizon: chance(next, 50),
        }),
  });
}

function chunksOf(shape) {
  const names = new Set();
  shape?.forEach((key) => names.add(nameOf(key)));
  return names;
}

test('what one View has and the next has not, over random moves, radii and levels', () => {
  const next = seeded('views');
  let view = null;
  let shape = null;
  for (let move = 0; move < 400; ++move) {
    const moved = chance(next, 3) ? null : randomView(next, view);
    const nextShape = moved && new ViewShape(moved, heights);
    const [before, after] = [chunksOf(shape), chunksOf(nextShape)];
    for (const [from, other, has, hasNot] of [[shape, nextShape, before, after], [nextShape, shape, after, before]]) {
      if (from === null) continue;
      const boxes = chunksOutside(from, other);
      const visited = [];
      forEachChunk(boxes, (key) => visited.push(nameOf(key)));
      const expected = [...has].filter((name) => !hasNot.has(name));
      assert.deepEqual(visited.sort(), expected.sort(), `move ${move}`);
      assert.equal(countOf(boxes), expected.length);
    }
    view = moved;
    shape = nextShape;
  }
});

test('chunks that leave the tracker are those that were given and are in the View no more', () => {
  const next = seeded('tracker');
  const tracker = new Tracker();
  let view = null;
  const held = new Map();
  for (let move = 0; move < 300; ++move) {
    view = chance(next, 3) ? null : randomView(next, view);
    const left = tracker.replace(view, heights).map(nameOf);
    const expected = [...held].filter(([, key]) => !tracker.shape?.covers(key)).map(([name]) => name);
    assert.deepEqual(left.sort(), expected.sort(), `move ${move}`);
    for (const name of left) held.delete(name);
    const share = [0, 2, 50, 100][next(4)];
    tracker.shape?.forEach((key) => {
      if (!chance(next, share)) return;
      tracker.deliver({ key, revision: 1n, hash: null, payload: new Uint8Array(), material: 1 });
      held.set(nameOf(key), key);
    });
  }
});
