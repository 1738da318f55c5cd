// The trained tables are those of core/voxel/FORMAT.md, number by number.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OTHER_START, SAME_END, UP_SPLIT, WEIGHTS } from '../dist/codec/plane_weights.js';
import { CLASSES, ENDS, GAP_SIZES } from '../dist/codec/volume_tables.js';
import { read } from './support/repository.js';

const format = read('core/voxel/FORMAT.md');
const words = (text) => text.trim().split(/\s+/);
const blocks = (name) => [...format.matchAll(new RegExp(`^\`\`\`${name}\n([^]*?)^\`\`\``, 'gm'))].map(([, text]) => words(text));

test('layers: weights and intervals', () => {
  const kinds = ['level', 'carried', 'first'].flatMap((kind) => [`${kind}-even`, `${kind}-odd`]);
  assert.deepEqual(WEIGHTS.map(words), kinds.map((kind) => blocks(`weights-${kind}`)[0]));
  assert.deepEqual([...SAME_END, ...OTHER_START, ...UP_SPLIT], blocks('intervals')[0].map(Number));
});

test('volume: ends, classes and gaps', () => {
  assert.deepEqual(words(ENDS), blocks('volume-ends')[0]);
  assert.deepEqual(CLASSES.map(words), blocks('volume-classes'));
  assert.deepEqual(GAP_SIZES, blocks('gap-sizes')[0].map(Number));
});
