// Every error is a TalusError, none repeats a password, and one that cannot go away ends the client.
import assert from 'node:assert/strict';
import http from 'node:http';
import { test } from 'node:test';
import { decodeChunk, TalusError } from '../dist/index.js';
import { connect } from '../dist/node.js';
import { script, welcome } from './support/scripted.js';

class Silent {
  close() {}
  send() {}
}

test('a wrong url is a TalusError that repeats no password', () => {
  const wrong = [
    '127.0.0.1:4780', 'localhost:4780', '', 'ws://', 'tcp://', 'tcp://host:abc', 'ftp://host', undefined, null, 7, [], ['ws://a', 8],
    'http://me:hush@host', 'http://hush@host:99999/', 'ws://me:hush@host/#hush', 'tcp://me:hush@host', 'wss://me:hu/sh@host', 'ftp://host/?t=hush',
    ['ws://a', 'ws://me:hush@host'], ['tcp://a', 'ws://host?hush'],
  ];
  for (const url of wrong) {
    assert.throws(() => connect({ url, WebSocket: Silent }), (error) => {
      assert(error instanceof TalusError, `${url}: ${error}`);
      assert.equal(error.kind, 'unreachable');
      assert(!/hu\/?sh/.test(error.message), error.message);
      return true;
    });
  }
  assert.throws(() => connect(), TalusError);
});

test('a server that does not answer is named without its query', async (t) => {
  const client = connect({ url: 'ws://127.0.0.1:1/?hush', WebSocket: Silent, connectTimeoutMs: 1, reconnect: { maxAttempts: 0 } });
  await assert.rejects(client.ready(), (error) => error.kind === 'timed_out' && error.message.includes('ws://127.0.0.1:1/') && !error.message.includes('hush'));
});

test('wrong arguments are TalusErrors', async (t) => {
  const { client, accept } = script();
  t.after(() => client.close());
  await accept(welcome());
  const wrong = { name: 'TalusError', kind: 'out_of_range' };
  for (const payload of [null, undefined, 'text', [3, 0, 1, 0], new Uint16Array(4), new DataView(new ArrayBuffer(4))]) {
    assert.throws(() => decodeChunk(payload), wrong);
  }
  assert.throws(() => decodeChunk(Uint8Array.of(3, 0, 1, 0), { into: new Uint16Array(5) }), wrong);
  for (const view of [undefined, {}, { centre: null }]) assert.throws(() => client.setView(view), wrong);
  for (const key of [undefined, null, {}, 'x']) await assert.rejects(client.getChunk(key), wrong);
  for (const columns of [undefined, [null], [{}], 5]) await assert.rejects(client.getPlaces(columns), wrong);
  for (const edit of [undefined, { writes: [{}] }, { fills: [null] }, { guards: 5 }]) await assert.rejects(client.edit(edit), wrong);
});

test('a transport that cannot be opened ends the client', async () => {
  class Forbidden {
    constructor() {
      throw new Error('a page by https may not');
    }
  }
  const client = connect({ url: 'ws://host', WebSocket: Forbidden });
  await assert.rejects(client.ready(), { kind: 'refused', message: /a page by https may not/ });
});

/** The kind of the error that ends a client whose server answers like that; null: it tries again. */
async function endOf(t, answer) {
  const server = http.createServer(answer);
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => server.close().closeAllConnections());
  const client = connect({ url: `http://127.0.0.1:${server.address().port}` });
  t.after(() => client.close());
  return new Promise((resolve) => client.on('disconnected', (error, wait) => resolve(wait === null ? error.kind : null)));
}

test('an address without a Talus server is not tried for ever', async (t) => {
  for (const status of [400, 404, 410]) {
    assert.equal(await endOf(t, (_, response) => response.writeHead(status).end()), 'refused');
  }
  for (const status of [408, 429, 500, 503]) {
    assert.equal(await endOf(t, (_, response) => response.writeHead(status).end()), null);
  }
  assert.equal(await endOf(t, (_, response) => response.end('<!doctype html>')), 'broken_protocol');
});
