// node bench/collect.js URL FILE: payloads of a running talusd, each with its length (u32) in front. Uniform chunks, which
// need no decoder, are left out.
import { writeFileSync } from 'node:fs';
import { connect } from '../dist/node.js';

const [url, file] = process.argv.slice(2);
const client = connect({ url });
const world = await client.ready();
const parts = [];
client.on('chunk', ({ payload, material }) => {
  if (material !== null) return;
  const length = Buffer.alloc(4);
  length.writeUInt32LE(payload.length);
  parts.push(length, Buffer.from(payload));
});
for (const [x, z] of [[0, 0], [4_000, 0], [0, 9_000], [-7_000, 3_000]]) {
  const { spawn } = world;
  client.setView({
    centre: { x: spawn.x + x, y: spawn.y, z: spawn.z + z },
    horizontalRadius: 6,
    verticalRadius: 4,
    rings: [{ lod: 1, radius: 16 }, { lod: 3, radius: 40 }],
  });
  await new Promise((resolve) => {
    const done = () => resolve(client.off('viewComplete', done));
    client.on('viewComplete', done);
  });
}
client.close();
writeFileSync(file, Buffer.concat(parts));
console.log(`${parts.length / 2} payloads in ${file}`);
