// What is shown before the server answers, and how it gives way to what the server says.
import { beforeEach, describe, expect, it } from 'vitest';
import { encodeChunk } from 'talus';
import { Predictions, type Content, type Place } from '../../../src/engine/edit/predictions.js';
import { touchedNeighbours } from '../../../src/engine/edit/touched.js';
import { decodeChunk } from '../../../src/engine/stream/decode.js';

const here: Place = { x: -1, y: 0, z: 2 };
const VOXEL = { x: -32 + 3, y: 4, z: 64 + 5 };
const INDEX = (4 * 32 + 5) * 32 + 3;
const chunkWith = (...written: [number, number][]): Content => {
  const voxels = new Uint16Array(32_768).fill(1);
  for (const [index, material] of written) voxels[index] = material;
  return { payload: encodeChunk({ uniform: null, voxels }), material: null, hash: null };
};

describe('predictions', () => {
  let land: Map<string, Content>;
  let shows: number;
  let predictions: Predictions;
  const name = ({ x, y, z }: Place) => `${x} ${y} ${z}`;
  const shown = (index = INDEX) => {
    const { payload, material } = land.get(name(here))!;
    const voxels = material ?? decodeChunk(payload!);
    return typeof voxels === 'number' ? voxels : voxels[index];
  };
  const arrive = (revision: bigint, content: Content) => {
    const show = predictions.arrived(here, revision, content);
    if (show !== null) land.set(name(here), show);
    return show;
  };
  beforeEach(() => {
    land = new Map([[name(here), { payload: null, material: 1, hash: null }]]);
    shows = 0;
    predictions = new Predictions({
      held: (place) => land.get(name(place)) ?? null,
      show: (place, content) => {
        ++shows;
        Object.assign(land.get(name(place))!, { payload: content.payload, material: content.material }); // as the engine has it
      },
    });
  });

  it('are shown at once, and go when the chunk has come that holds them', () => {
    const edit = predictions.begin([{ ...VOXEL, material: 7 }]);
    expect(shown()).toBe(7);
    predictions.settled(edit, 5n, true);
    expect([shown(), predictions.size]).toEqual([7, 1]); // the result came first
    expect(arrive(5n, chunkWith([INDEX, 7]))).toBeNull(); // nothing new to see
    expect([shows, predictions.size]).toEqual([1, 0]);
  });
  it('stay while an older revision comes, and what else it has is seen', () => {
    const edit = predictions.begin([{ ...VOXEL, material: 7 }]);
    arrive(4n, chunkWith([9, 3]));
    expect([shown(), shown(9)]).toEqual([7, 3]);
    predictions.settled(edit, 5n, true);
    expect(shown()).toBe(7);
    arrive(6n, chunkWith([9, 3], [INDEX, 8])); // another was quick
    expect([shown(), predictions.size]).toEqual([8, 0]);
  });
  it('stay though they are answered, until the chunk has come that holds them', () => {
    predictions.settled(predictions.begin([{ ...VOXEL, material: 7 }]), 5n, true);
    arrive(4n, chunkWith([9, 3]));
    expect([shown(), shown(9), predictions.size]).toEqual([7, 3, 1]);
  });
  it('go at once where the chunk came before the result', () => {
    const edit = predictions.begin([{ ...VOXEL, material: 7 }]);
    arrive(5n, chunkWith([INDEX, 7]));
    expect(predictions.size).toBe(1);
    predictions.settled(edit, 5n, true);
    expect([shown(), predictions.size]).toEqual([7, 0]);
  });
  it('go where the edit left the chunk as it was, when that is asked for again', () => {
    const edit = predictions.begin([{ ...VOXEL, material: 0 }]);
    expect(predictions.behind(edit)).toEqual([]); // it is not answered
    predictions.settled(edit, 5n, true);
    expect(predictions.behind(edit)).toEqual([here]);
    predictions.resolved(edit, here, 3n, chunkWith()); // sand slid into it from the chunk beside
    expect([shown(), predictions.size]).toEqual([1, 0]);
    expect(predictions.behind(edit)).toEqual([]);
  });
  it('behind that stay, and what came meanwhile is not overwritten', () => {
    const first = predictions.begin([{ ...VOXEL, material: 0 }]);
    predictions.settled(first, 5n, true);
    predictions.begin([{ ...VOXEL, x: VOXEL.x + 1, material: 8 }]);
    arrive(4n, chunkWith([9, 3]));
    predictions.resolved(first, here, 3n, chunkWith());
    expect([shown(), shown(INDEX + 1), shown(9), predictions.size]).toEqual([1, 8, 3, 1]);
  });
  it('are taken back where the server refuses, and those behind them stay', () => {
    const first = predictions.begin([{ ...VOXEL, material: 7 }]);
    const second = predictions.begin([{ ...VOXEL, x: VOXEL.x + 1, material: 8 }]);
    predictions.refused(first);
    expect([shown(), shown(INDEX + 1)]).toEqual([1, 8]);
    predictions.refused(second);
    expect([shown(INDEX + 1), predictions.size]).toEqual([1, 0]);
  });
  it('of one voxel lie over each other in their order', () => {
    const first = predictions.begin([{ ...VOXEL, material: 7 }]);
    predictions.begin([{ ...VOXEL, material: 8 }]);
    expect(shown()).toBe(8);
    predictions.refused(first);
    expect(shown()).toBe(8);
  });
  it('that changed nothing go when what is here agrees', () => {
    const edit = predictions.begin([{ ...VOXEL, material: 1 }]);
    predictions.settled(edit, 9n, false);
    expect([shows, predictions.size]).toEqual([0, 0]);
  });
  it('leave out chunks that are not here, and forget those that leave', () => {
    const edit = predictions.begin([{ ...VOXEL, material: 7 }, { x: 500, y: 0, z: 0, material: 7 }]);
    expect(predictions.size).toBe(1);
    predictions.left(here);
    predictions.settled(edit, 5n, true);
    expect(predictions.size).toBe(0);
  });
});

describe('neighbours that are to be meshed again', () => {
  const bit = (dx: number, dy: number, dz: number) => 1 << ((dy + 1) * 9 + (dz + 1) * 3 + dx + 1);
  const after = (x: number, y: number, z: number) => new Uint16Array(32_768).fill(1).fill(2, (y * 32 + z) * 32 + x, (y * 32 + z) * 32 + x + 1);
  it('are none for a voxel inside, seven for a corner', () => {
    expect(touchedNeighbours(1, after(5, 6, 7))).toBe(bit(0, 0, 0));
    expect(touchedNeighbours(1, after(31, 6, 7))).toBe(bit(0, 0, 0) | bit(1, 0, 0));
    const corner = touchedNeighbours(1, after(0, 31, 0));
    expect(corner.toString(2).replaceAll('0', '').length).toBe(8);
    expect(corner & bit(-1, 1, -1)).not.toBe(0);
    expect(touchedNeighbours(1, 1)).toBe(0);
  });
});
