// Worlds made by WebAssembly; tests/golden/wasm.mjs compares their voxels with golden.txt.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { decodeChunk } from '../dist/decode.js';
import { hasSimd, World, WorldError } from '../wasm/world.js';

const spec = (name) => readFileSync(new URL(`../../../../core/worlds/${name}.toml`, import.meta.url), 'utf8');
const moduleBytes = (name) => readFileSync(new URL(`../wasm/${name}.wasm`, import.meta.url));

/** The WorldError of a call. */
async function refusal(call) {
  try {
    await call();
  } catch (error) {
    assert.ok(error instanceof WorldError, `${error.stack}`);
    assert.equal(error.message.split('\n').length, 1, error.message);
    return error;
  }
  return assert.fail('it was not refused');
}

test('the modules ask for memory and nothing else of a system', async () => {
  for (const name of ['talus-world', 'talus-world-simd']) {
    const module = await WebAssembly.compile(moduleBytes(name));
    const imports = WebAssembly.Module.imports(module).map(({ module, name, kind }) => `${module}.${name} ${kind}`);
    assert.deepEqual(imports.sort(), ['env.memory memory', 'talus.failed function'], name);
  }
});

test('chunks are the same with and without vectors, and the decoder in TypeScript reads them', async () => {
  assert.ok(hasSimd());
  const [scalar, vectors] = await Promise.all([false, true].map((simd) => World.open(spec('default'), { simd })));
  assert.deepEqual([scalar.instructionSet, vectors.instructionSet], ['scalar', 'wasm128']);
  assert.match(vectors.fingerprint, /^[0-9a-f]{32}$/);
  assert.equal(vectors.materials[0].name, 'air');
  const { first, last, below } = vectors.rows({ x: -1, z: 2 });
  for (let y = first - 1; y <= last + 1; ++y) {
    const key = { x: -1, y, z: 2 };
    const made = vectors.generate(key, { voxels: true, payload: true, hash: true });
    assert.deepEqual(scalar.generate(key, { voxels: true, payload: true, hash: true }), made);
    const decoded = decodeChunk(made.payload, { hash: made.hash });
    assert.deepEqual([decoded.voxels, decoded.uniform], [made.voxels, made.uniform]);
    assert.deepEqual(vectors.decode(made.payload, { voxels: true, payload: true, hash: true }), made);
  }
  assert.equal(vectors.generate({ x: -1, y: first - 1, z: 2 }).uniform, below);
  assert.equal(vectors.map({ zoom: 12, x: 0, z: 0 }).length, 256 * 256 * 3);
  const ground = vectors.heights({ x: -32, z: 64, width: 2, depth: 3 });
  assert.ok(ground.length === 6 && ground.every((h) => h >> 8 >= vectors.heightRange.low && h >> 8 < vectors.heightRange.high), `${ground}`);
});

test('edits happen at every level, whole or not at all', async () => {
  const world = await World.open(spec('classic'));
  const [height] = world.heights({ x: 40, z: 40, width: 1, depth: 1 });
  const y = (height >> 8) + 20;
  const box = { first: { x: 32, y, z: 32 }, last: { x: 63, y: y + 15, z: 63 }, material: 2 };
  const { changed, chunks } = world.edit({ guards: [{ voxel: box.first, material: 0 }], fills: [box] });
  assert.equal(changed, 32 * 32 * 16);
  assert.deepEqual([...new Set(chunks.map(({ lod }) => lod))].sort().slice(0, 4), [0, 1, 2, 3]);
  assert.equal(world.generate({ x: 1, y: y >> 5, z: 1 }).voxels[((y & 31) * 32 + 5) * 32 + 6], 2);
  const refused = await refusal(() => world.edit({ guards: [{ voxel: box.first, material: 0 }], fills: [{ ...box, material: 0 }] }));
  assert.equal(refused.kind, 'conflict');
  assert.equal((await refusal(() => world.edit({ writes: [{ voxel: box.first, material: 999 }] }))).kind, 'range');
  assert.equal((await refusal(() => world.edit({ writes: [{ voxel: { x: 0.5, y, z: 0 }, material: 2 }] }))).kind, 'range');
  assert.equal(world.edit({ fills: [{ ...box, material: 'generated' }] }).changed, changed);
  const plain = await World.open(spec('classic'));
  for (const key of chunks) assert.deepEqual(world.generate(key, { hash: true }), plain.generate(key, { hash: true }));
});

test('a world file that is wrong is refused in one line, with its place', async () => {
  const wrong = await refusal(() => World.open('resolution = 1\nseed   = "seven"\n'));
  assert.deepEqual([wrong.kind, wrong.line, wrong.column, wrong.key], ['spec', 2, 10, 'seed']);
  assert.equal(wrong.message, "2:10: seed: 'seven' is a string; an integer is needed");
  const torn = await refusal(() => World.open('seed = 1\nresolution = = 2\n'));
  assert.deepEqual([torn.kind, torn.line, torn.key], ['spec', 2, 'resolution']);
  for (const toml of ['', '\0', '[['.repeat(1000), `a = ${'['.repeat(100_000)}`, `a = ${'{ a = '.repeat(5000)}`, `${'a.'.repeat(50_000)}a = 1`,
    'seed = 99999999999999999999', 'x = "\xff', new Uint8Array(2 << 20).fill(97), Uint8Array.of(0xff, 0xfe, 0x00)]) // prettier-ignore
    assert.equal((await refusal(() => World.open(toml))).kind, 'spec');
});

test('no world file breaks the module', async () => {
  // Every byte of a world file changed, one at a time: it opens, or is refused.
  const text = new TextEncoder().encode(spec('classic'));
  const module = await WebAssembly.compile(moduleBytes('talus-world-simd'));
  let opened = 0;
  for (let at = 0; at < text.length; at += 7) {
    const changed = text.slice();
    changed[at] = changed[at] === 0x39 ? 0x2d : 0x39;
    try {
      const world = await World.open(changed, { module });
      ++opened;
      world.close();
    } catch (error) {
      assert.equal(error.kind, 'spec', `byte ${at}: ${error.stack}`);
    }
  }
  assert.ok(opened > 10, `${opened}`);
});

test('memory is bounded, and what needs more is an error', async () => {
  const hungry = `method = "erosion"\nerosion_steps = 64\n${spec('features')}`;
  const memoryBytes = 24 << 20;
  const world = await World.open(hungry, { memoryBytes });
  const error = await refusal(() => world.prepare({ x: 0, z: 0, width: 64, depth: 64 }));
  assert.equal(error.kind, 'out_of_memory');
  assert.match(error.message, /25165824 bytes/);
  // The world has ended, and its memory is free.
  assert.equal((await refusal(() => world.rows({ x: 0, z: 0 }))).kind, 'out_of_memory');
  assert.equal(world.memoryBytes, 0);
  const long = `a = [${'1,'.repeat(500_000)}]`;
  assert.equal((await refusal(() => World.open(long, { memoryBytes: 8 << 20 }))).kind, 'out_of_memory');
  assert.equal((await refusal(() => World.open(long))).kind, 'spec');
  assert.equal((await refusal(() => World.open(spec('default'), { memoryBytes: 1 }))).kind, 'range');

  // Moving through a world fills no more.
  const modest = await World.open(spec('classic'), { memoryBytes: 48 << 20, groundBytes: 4 << 20 });
  for (let x = -200; x < 200; x += 4) modest.generate({ x, y: 1, z: x }, { hash: true });
  assert.ok(modest.memoryBytes <= 48 << 20);
});

test('arguments out of range are refused, and the world goes on', async () => {
  const world = await World.open(spec('classic'));
  for (const call of [
    () => world.generate({ lod: 7, x: 0, y: 0, z: 0 }),
    () => world.generate({ lod: 6, x: 1 << 30, y: 0, z: 0 }),
    () => world.prepare({ x: 0, z: 0, width: 0, depth: 1 }),
    () => world.prepare({ lod: 1, x: 2 ** 30 - 1, z: 0, width: 2, depth: 1 }),
    () => world.heights({ x: 0.5, z: 0, width: 1, depth: 1 }),
    () => world.heights({ x: 2 ** 36, z: 0, width: 1, depth: 1 }),
    () => world.heights({ x: NaN, z: 0, width: 1, depth: 1 }),
    () => world.heights({ x: 0, z: 0, width: 1 << 20, depth: 1 << 20 }),
    () => world.map({ zoom: 13, x: 0, z: 0 }),
    () => world.map({ zoom: 12, x: 1e300, z: 0 }),
  ])
    assert.equal((await refusal(call)).kind, 'range', `${call}`);
  assert.equal((await refusal(() => world.decode(Uint8Array.of(4, 9, 9)))).kind, 'bad_chunk');
  assert.ok(world.generate({ x: 0, y: -1000, z: 0 }).uniform > 0);
  world.close();
  assert.equal((await refusal(() => world.generate({ x: 0, y: 0, z: 0 }))).kind, 'closed');
});
