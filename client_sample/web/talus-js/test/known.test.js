// What a View says that the client still holds: of what it brings back, and no more.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { encodeChunk } from '../dist/encode.js';
import { hashVoxels } from '../dist/hash.js';
import { chunk, script, welcome } from './support/scripted.js';

const voxels = new Uint16Array(32_768).map((_, i) => (i % 7 === 0 ? 1 : 0));
const payload = encodeChunk({ uniform: null, voxels });
const hash = hashVoxels({ uniform: null, voxels });

test('a View names what it brings back; the first of a connection all that is kept', async (t) => {
  const { client, accept } = script();
  t.after(() => client.close());
  const at = (x, direction) => ({ centre: { x: 32 * x + 16, y: 16, z: 16 }, horizontalRadius: 1, verticalRadius: 0, direction });
  client.setView(at(0));
  const side = await accept(welcome());
  assert.deepEqual((await side.next('View')).known, []);
  for (const x of [-1, 0, 1]) side.say(chunk({ key: { lod: 0, x, y: 0, z: 0 }, revision: 1, hash, payload }));

  client.setView(at(0, { x: 1, y: 0, z: 0 }));
  assert.deepEqual((await side.next('View')).known, [], 'it turned alone');
  client.setView(at(2));
  assert.deepEqual((await side.next('View')).known, [], 'nothing of it was here before');
  client.setView(at(1));
  assert.deepEqual((await side.next('View')).known, ['0/0/0/0']);
  client.setView(at(-1));
  assert.deepEqual((await side.next('View')).known, ['0/-1/0/0']);

  side.breakOff(new Error('cut'));
  const again = await accept(welcome());
  assert.deepEqual((await again.next('View')).known.sort(), ['0/-1/0/0', '0/0/0/0']);
});
