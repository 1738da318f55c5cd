// How long a client waits, whatever a server says.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Backoff } from '../dist/client/backoff.js';
import { Pace } from '../dist/stream/pace.js';

const rates = (requests, burstMs) => ({ chunks: 0, bytes: 0, requests, burstMs });
const MINUTE = 60_000;

/** How many may be sent at once. */
function burst(pace) {
  let count = 0;
  while (count < 1_000 && pace.wait(0) === 0) {
    pace.take();
    ++count;
  }
  return count;
}

for (const [name, session, address, together, next] of [
  ['of the session', rates(10, 2_000), null, 17, 50], // of 20, an eighth is left
  ['of the address', null, rates(100, 1_000), 87, 5],
  ['of both, the lower one', rates(100, 1_000), rates(10, 800), 7, 100],
  ['a rate of 0 is none', rates(0, 1_000), rates(10, 800), 7, 100],
  ['a burst of nothing still sends one', rates(10, 0), null, 1, 100],
]) {
  test(`rates: ${name}`, () => {
    const pace = new Pace();
    pace.begin({ sessionRates: session, addressRates: address }, 0);
    assert.equal(burst(pace), together);
    assert.equal(pace.wait(0), next);
  });
}

test('no rates: no wait', () => {
  const pace = new Pace();
  pace.begin({ sessionRates: null, addressRates: rates(0, 0) }, 0);
  assert.equal(burst(pace), 1_000);
});

test('no server makes a client wait for longer than a minute, or not at all', () => {
  for (const [asked, waited] of [[500, 500], [2 ** 32 - 16, MINUTE], [Infinity, MINUTE], [-5_000, 0]]) {
    const pace = new Pace();
    pace.begin({ sessionRates: null, addressRates: null }, 0);
    pace.refused(asked, 0);
    assert.equal(pace.wait(0), waited);
    assert.equal(new Backoff({ firstDelayMs: 0 }).next(asked), waited);
  }
});
