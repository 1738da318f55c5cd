// Worlds made here, by WebAssembly: the other side of core/wasm. world.d.ts documents it.

const PAGE = 65_536;
const FIRST_PAGES = 128; // what core/wasm/CMakeLists.txt links
const VOXELS = 1;
const PAYLOAD = 2;
const HASH = 4;

export class WorldError extends Error {
  constructor(kind, message, { line = 0, column = 0, key = '', cause } = {}) {
    super(message, cause === undefined ? undefined : { cause });
    this.name = 'WorldError';
    Object.assign(this, { kind, line, column, key });
  }
}

// One function with a constant of 128 bits.
const WITH_SIMD = Uint8Array.of(
  0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, // "\0asm", version 1
  1, 4, 1, 0x60, 0, 0, // its type: () -> ()
  3, 2, 1, 0,
  10, 23, 1, 21, 0, 0xfd, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x1a, 11,
);

export const hasSimd = () => WebAssembly.validate(WITH_SIMD);

const compiled = new Map();

export async function compiledModule(simd = hasSimd()) {
  if (!compiled.has(simd)) {
    const url = simd ? new URL('./talus-world-simd.wasm', import.meta.url) : new URL('./talus-world.wasm', import.meta.url);
    const promise = load(url);
    compiled.set(simd, promise);
    promise.catch(() => compiled.delete(simd));
  }
  return compiled.get(simd);
}

async function load(url) {
  if (url.protocol === 'file:') {
    const files = 'node:fs/promises'; // a name that bundlers for browsers do not follow
    const { readFile } = await import(/* @vite-ignore */ files);
    return WebAssembly.compile(await readFile(url));
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new WorldError('broken', `${url}: ${answer.status} ${answer.statusText}`);
  return WebAssembly.compile(await answer.arrayBuffer());
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

export class World {
  #memory;
  #exports;
  #ended = null;

  static async open(toml, { files = {}, module, simd = hasSimd(), memoryBytes = 1 << 30, groundBytes = 32 << 20 } = {}) {
    const pages = Math.floor(memoryBytes / PAGE);
    if (!(pages >= FIRST_PAGES && pages <= PAGE)) {
      throw new WorldError('range', `memoryBytes: ${memoryBytes} is out of range; ${FIRST_PAGES * PAGE} to ${PAGE * PAGE}`);
    }
    const code = module === undefined ? await compiledModule(simd) : module instanceof WebAssembly.Module ? module : await WebAssembly.compile(module);
    const world = new World();
    await world.#start(code, pages);
    world.#open(typeof toml === 'string' ? encoder.encode(toml) : toml, files, groundBytes);
    return world;
  }

  async #start(code, pages) {
    this.#memory = new WebAssembly.Memory({ initial: FIRST_PAGES, maximum: pages });
    const failed = (outOfMemory) => {
      throw outOfMemory
        ? new WorldError('out_of_memory', `the world needs more than ${pages * PAGE} bytes; memoryBytes allows no more`)
        : new WorldError('broken', 'the module gave up; this is a fault of Talus');
    };
    this.#exports = (await WebAssembly.instantiate(code, { env: { memory: this.#memory }, talus: { failed } })).exports;
    this.#call('_initialize');
    this.instructionSet = decoder.decode(this.#bytes(this.#call('talus_instruction_set')));
  }

  #open(toml, files, groundBytes) {
    for (const [name, bytes] of Object.entries(files)) {
      const named = this.#given(encoder.encode(name));
      const given = this.#given(bytes);
      this.#call('talus_add_file', named.at, named.size, given.at, given.size);
      this.#call('talus_release', named.at);
      this.#call('talus_release', given.at);
    }
    const { at, size } = this.#given(toml);
    const about = this.#answer('spec', 'talus_world_open', at, size, groundBytes);
    this.#call('talus_release', at);
    Object.assign(this, JSON.parse(decoder.decode(this.#bytes(about))));
  }

  get memoryBytes() {
    return this.#memory?.buffer.byteLength ?? 0;
  }

  prepare({ lod = 0, x, z, width, depth }) {
    this.#answer('range', 'talus_prepare', lod, x, z, width, depth);
  }

  rows({ lod = 0, x, z }) {
    const [first, last, below] = new Int32Array(this.#copy(this.#answer('range', 'talus_rows', lod, x, z)).buffer);
    return { first, last, below };
  }

  generate({ lod = 0, x, y, z }, what) {
    return this.#chunk(this.#answer('range', 'talus_generate', lod, x, y, z, flags(what)));
  }

  edit({ guards = [], writes = [], fills = [] }) {
    const place = ({ x, y, z }) => [x, y, z];
    const write = ({ voxel, material }) => [...place(voxel), material];
    const fill = ({ first, last, material, only }) => [...place(first), ...place(last), material === 'generated' ? -1 : material, only ?? -1];
    const numbers = [guards.length, writes.length, fills.length, ...guards.map(write), ...writes.map(write), ...fills.map(fill)].flat();
    const { at } = this.#given(new Uint8Array(Float64Array.from(numbers).buffer));
    const answer = this.#answer('range', 'talus_edit', at, numbers.length);
    const [conflict, changed, ...keys] = new Int32Array(this.#copy(answer).buffer);
    this.#call('talus_release', at);
    if (conflict >= 0) throw new WorldError('conflict', `guard ${conflict} does not hold; nothing was changed`);
    return { changed, chunks: keysOf(keys) };
  }

  overrides({ x, y, z }) {
    return this.#copy(this.#answer('range', 'talus_overrides', x, y, z));
  }

  restore({ x, y, z }, runs) {
    const { at, size } = this.#given(runs);
    const answer = this.#answer('range', 'talus_restore', x, y, z, at, size);
    const chunks = keysOf(new Int32Array(this.#copy(answer).buffer));
    this.#call('talus_release', at);
    return chunks;
  }

  spawn() {
    const [x, y, z] = new Float64Array(this.#copy(this.#answer('range', 'talus_spawn')).buffer);
    return { x, y, z };
  }

  decode(payload, what) {
    const { at, size } = this.#given(payload);
    const chunk = this.#chunk(this.#answer('bad_chunk', 'talus_decode', at, size, flags(what)));
    this.#call('talus_release', at);
    return chunk;
  }

  heights({ lod = 0, x, z, width, depth }) {
    return new Int32Array(this.#copy(this.#answer('range', 'talus_heights', lod, x, z, width, depth)).buffer);
  }

  map({ zoom, x, z }) {
    return this.#copy(this.#answer('range', 'talus_map', zoom, x, z));
  }

  hash(bytes) {
    const { at, size } = this.#given(bytes);
    const halves = this.#view(this.#call('talus_hash', at, size));
    const [data] = [halves.getUint32(0, true)];
    this.#call('talus_release', at);
    return hex(this.#view(data), 0);
  }

  close() {
    this.#end(new WorldError('closed', 'the world is closed'));
  }

  #end(why) {
    this.#ended ??= why;
    this.#memory = undefined;
    this.#exports = undefined;
  }

  #call(name, ...numbers) {
    if (this.#ended) throw this.#ended;
    try {
      return this.#exports[name](...numbers);
    } catch (cause) {
      // Nothing in its memory can be relied on now.
      this.#end(cause instanceof WorldError ? cause : new WorldError('broken', `the module failed: ${cause.message}`, { cause }));
      throw this.#ended;
    }
  }

  #answer(kind, name, ...numbers) {
    const at = this.#call(name, ...numbers);
    if (at !== 0) return at;
    const problem = this.#call('talus_problem');
    const view = this.#view(problem);
    const [line, column] = [view.getUint32(0, true), view.getUint32(4, true)];
    const [key, text] = [decoder.decode(this.#bytes(problem + 8)), decoder.decode(this.#bytes(problem + 16))];
    const place = line === 0 ? '' : `${line}:${column === 0 ? '' : `${column}:`} `;
    throw new WorldError(kind, `${place}${key === '' ? '' : `${key}: `}${text}`, { line, column, key });
  }

  #view(at) {
    return new DataView(this.#memory.buffer, at);
  }

  /** The bytes that an address and a size at `at` stand for, until the next call. */
  #bytes(at) {
    const view = this.#view(at);
    return new Uint8Array(this.#memory.buffer, view.getUint32(0, true), view.getUint32(4, true));
  }

  #copy(at) {
    return this.#bytes(at).slice();
  }

  #given(bytes) {
    const at = this.#call('talus_allocate', bytes.length);
    new Uint8Array(this.#memory.buffer, at, bytes.length).set(bytes);
    return { at, size: bytes.length };
  }

  #chunk(at) {
    const view = this.#view(at);
    const uniform = view.getUint32(0, true) === 1;
    const voxels = this.#copy(at + 8);
    const payload = this.#copy(at + 16);
    return {
      voxels: voxels.length === 0 ? null : new Uint16Array(voxels.buffer),
      uniform: uniform ? view.getUint32(4, true) : null,
      payload: payload.length === 0 ? null : payload,
      hash: hex(view, 24),
    };
  }
}

function keysOf(numbers) {
  const keys = [];
  for (let i = 0; i < numbers.length; i += 4) keys.push({ lod: numbers[i], x: numbers[i + 1], y: numbers[i + 2], z: numbers[i + 3] });
  return keys;
}

const flags = ({ voxels = true, payload = false, hash = false } = {}) => (voxels ? VOXELS : 0) | (payload ? PAYLOAD : 0) | (hash ? HASH : 0);

/** 128 bits, low half first in memory, as 32 digits, high half first. */
const hex = (view, at) => [8, 0].map((half) => view.getBigUint64(at + half, true).toString(16).padStart(16, '0')).join('');
