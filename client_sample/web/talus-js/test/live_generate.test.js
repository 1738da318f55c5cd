// Chunks made beside a real talusd that publishes its world.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import WebSocket from 'ws';
import { connect, decodeChunk } from '../dist/node.js';
import { startTalusd, talusd } from './support/talusd.js';

const options = { timeout: 120_000, skip: talusd === undefined && 'no talusd is built: build the target talusd, or set TALUSD' };
const classic = fileURLToPath(new URL('../../../../core/worlds/classic.toml', import.meta.url));
const nameOf = ({ lod, x, y, z }) => `${lod}/${x}/${y}/${z}`;
const viewAt = (x) => ({ centre: { x, y: 100, z: 0 }, horizontalRadius: 3, verticalRadius: 3, rings: [{ lod: 1, radius: 6 }] });

async function start(t) {
  const data = mkdtempSync(join(tmpdir(), 'talus-js-generate-'));
  const env = { TALUS_ACCESS_WITHOUT_TOKEN: 'read,edit', TALUS_PUBLISH: 'public' };
  const server = await startTalusd({ args: ['--data', data, '--world', classic], env });
  t.after(async () => {
    await server.stop();
    rmSync(data, { recursive: true, force: true });
  });
  return server;
}

/** A client whose View is whole: what it has of it, and a way to move on. */
async function open(t, url, how = {}) {
  const client = connect({ url, WebSocket, editsIntervalMs: 50, ...how });
  t.after(() => client.close());
  const chunks = new Map();
  const errors = [];
  client.on('chunk', (chunk) => chunks.set(nameOf(chunk.key), chunk));
  client.on('chunkLeft', (key) => chunks.delete(nameOf(key)));
  client.on('error', (error) => errors.push(error.message));
  const move = (x) =>
    new Promise((resolve) => {
      const told = ({ centre }) => {
        if (centre.x !== x) return;
        client.off('viewComplete', told);
        resolve();
      };
      client.on('viewComplete', told);
      client.setView(viewAt(x));
    });
  await move(0);
  return { client, chunks, errors, move };
}

/** The chunk of that key whose voxel 0 has the material. */
const becomes = ({ client, chunks }, key, material) =>
  new Promise((resolve) => {
    const look = () => {
      const chunk = chunks.get(nameOf(key));
      if (chunk === undefined || voxels(chunk)[0] !== material) return;
      client.off('chunk', look);
      resolve();
    };
    client.on('chunk', look);
    look();
  });

function voxels({ payload }) {
  const { uniform, voxels } = decodeChunk(payload);
  return voxels ?? new Uint16Array(32_768).fill(uniform);
}

for (const transport of ['websocket', 'http']) {
  test(`by ${transport} what is made here is what a server sends, with its edits`, options, async (t) => {
    const { urls } = await start(t);
    const editor = await open(t, urls.websocket);
    const write = (x, material) => editor.client.edit({ writes: [{ voxel: { x, y: 96, z: 0 }, material }] });
    await write(96, 2); // in chunk 3, before any client makes it
    const maker = await open(t, urls[transport], { generate: 'auto' });
    // The world is opened after the first View: moves on until chunks are made here.
    let x = 0;
    while (maker.client.stats.madeChunks === 0) await maker.move((x += 32));
    assert.deepEqual(maker.errors, []);
    await editor.move(x);
    assert.equal(maker.chunks.size, editor.chunks.size);
    for (const [name, chunk] of editor.chunks) assert.deepEqual(voxels(maker.chunks.get(name)), voxels(chunk), name);

    // While it looks, and in chunks that come later.
    const here = { lod: 0, x: x / 32, y: 3, z: 0 };
    await write(x, 3);
    await becomes(maker, here, 3);
    await write(x, 4);
    await becomes(maker, here, 4);
    await write(x + 256, 5);
    await maker.move(x + 256);
    await becomes(maker, { ...here, x: x / 32 + 8 }, 5);
    await maker.move(x);
    await becomes(maker, here, 4);
    await editor.move(x + 256);
    await maker.move(x + 256);
    for (const [name, chunk] of editor.chunks) assert.deepEqual(voxels(maker.chunks.get(name)), voxels(chunk), name);
    assert.deepEqual(maker.errors, []);
    assert.ok(maker.client.stats.proofs >= 1, `${maker.client.stats.proofs} proofs`);
  });
}
