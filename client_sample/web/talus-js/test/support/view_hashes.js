// node view_hashes.js URL: the chunks of a small View at the spawn, and what they decode to, as JSON. A program of its own, as
// Node reads whom it trusts (NODE_EXTRA_CA_CERTS) when it starts.
import WebSocket from 'ws';
import { connect, decodeChunk, hashVoxels } from '../../dist/node.js';

const client = connect({ url: process.argv[2], WebSocket, reconnect: { maxAttempts: 0 } });
const hashes = {};
client.on('chunk', ({ key: { lod, x, y, z }, payload, hash }) => {
  hashes[`${lod}/${x}/${y}/${z}`] = hashVoxels(decodeChunk(payload, { hash }));
});
client.on('viewComplete', () => {
  client.close();
  process.stdout.write(JSON.stringify(Object.fromEntries(Object.entries(hashes).sort())));
});
try {
  const { spawn } = await client.ready();
  client.setView({ centre: spawn, horizontalRadius: 2, verticalRadius: 2, rings: [{ lod: 1, radius: 6 }] });
} catch (error) {
  process.stdout.write(`${error.kind}: ${error.message}`);
}
