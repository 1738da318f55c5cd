// The repository's payload vectors: core/voxel/vectors/payloads.txt.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeChunk, DecodeError, hashVoxels } from '../dist/index.js';
import { payloads } from './support/repository.js';

for (const vector of payloads()) {
  test(`payload ${vector.name}`, () => {
    if (vector.kind === 'chunk') {
      assert.equal(hashVoxels(decodeChunk(vector.payload)), vector.value);
      decodeChunk(vector.payload, { hash: vector.value });
      assert.throws(() => decodeChunk(vector.payload, { hash: '0'.repeat(32) }), { fault: 'bad_hash' });
    } else {
      assert.throws(
        () => decodeChunk(vector.payload),
        (error) => error instanceof DecodeError && error.fault === vector.value,
      );
    }
  });
}
