// Which chunks a View has, against the repository's vectors (core/voxel/vectors/views.json).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { checkedView, ViewShape } from '../dist/view_shape.js';
import { read } from './support/repository.js';

const { views } = JSON.parse(read('core/voxel/vectors/views.json'));

function range([first, last]) {
  return { first, last };
}
const isEmpty = ({ first, last }) => last < first;

for (const vector of views) {
  test(`view: ${vector.name}`, () => {
    const [x, y, z] = vector.centre.map(Number);
    const view = checkedView({
      centre: { x, y, z },
      horizontalRadius: vector.horizontal_radius,
      verticalRadius: vector.vertical_radius,
      rings: vector.rings,
      horizon: vector.horizon !== undefined,
    });
    const heights = vector.horizon && { minY: Number(vector.horizon.min_y), maxY: Number(vector.horizon.max_y) };
    const shape = new ViewShape(view, heights);
    assert.equal(shape.count, vector.chunks);
    assert.equal(shape.uncutCount, vector.chunks_without_edge);
    vector.levels.forEach((level, i) => {
      const box = shape.boxes[i];
      assert.equal(box.lod, level.lod);
      for (const [name, expected] of [['x', level.x], ['y', level.y], ['z', level.z], ['innerX', level.inner_x], ['innerZ', level.inner_z]]) {
        if (expected === null) assert(isEmpty(box[name]), `${name} of level ${level.lod} is empty`);
        else assert.deepEqual(box[name], range(expected), `${name} of level ${level.lod}`);
      }
    });
    for (const [lod, cx, cy, cz] of vector.inside) assert(shape.covers({ lod, x: cx, y: cy, z: cz }));
    for (const [lod, cx, cy, cz] of vector.outside) assert(!shape.covers({ lod, x: cx, y: cy, z: cz }));
    if (vector.chunks < 100_000) {
      let visited = 0;
      shape.forEach((key) => {
        assert(shape.covers(key));
        ++visited;
      });
      assert.equal(visited, vector.chunks);
    }
  });
}

test('views that a server would refuse are refused here', () => {
  const view = { centre: { x: 0, y: 0, z: 0 }, horizontalRadius: 4, verticalRadius: 2 };
  for (const wrong of [
    { horizontalRadius: -1 },
    { verticalRadius: 0.5 },
    { centre: { x: NaN, y: 0, z: 0 } },
    { rings: [{ lod: 1, radius: 4 }] },
    { rings: [{ lod: 0, radius: 8 }] },
    { rings: [{ lod: 7, radius: 8 }] },
    { rings: [{ lod: 2, radius: 8 }, { lod: 1, radius: 16 }] },
  ]) {
    assert.throws(() => checkedView({ ...view, ...wrong }), { name: 'TalusError', kind: 'out_of_range' });
  }
});
