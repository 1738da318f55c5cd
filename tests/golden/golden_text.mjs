// The lines of golden.txt, made by talus-js/wasm in Node or a browser from what inputs.cpp prints.

/** `open(toml, files)` opens a world. */
export async function goldenText(open, { worlds, places, random, files: encoded }) {
  const files = Object.fromEntries(Object.entries(encoded).map(([name, hex]) => [name, Uint8Array.from(hex.match(/../g), (byte) => parseInt(byte, 16))]));
  let lines = '';
  let [generator, codec] = [0, 0];
  for (const { name, toml } of worlds) {
    const world = await open(toml, files);
    generator = Math.max(generator, world.generatorVersion);
    codec = world.codecVersion;
    lines += `${name} ${world.fingerprint}\n`;
    for (const place of places) {
      const made = new Made();
      made.add(world, place);
      lines += made.line(world, place.what);
    }
    world.close();
  }
  const made = new Made();
  let opened = 0;
  let any;
  for (const { toml, place } of random) {
    try {
      any = await open(toml, {});
    } catch (error) {
      if (error.kind !== 'spec') throw error;
      continue; // it asks for too many layers
    }
    ++opened;
    made.add(any, place);
  }
  lines += `random regions, ${opened} worlds\n${made.line(any, 'a tile of each')}`;
  return `generator ${generator} codec ${codec}\n${lines}`;
}

class Made {
  hashes = new Bytes();
  payloads = new Bytes();
  decodedOtherwise = 0;

  add(world, { lod, x, z, tiles }) {
    world.prepare({ lod, x, z, width: tiles, depth: tiles });
    for (let tz = z; tz < z + tiles; ++tz) {
      for (let tx = x; tx < x + tiles; ++tx) {
        const { first, last } = world.rows({ lod, x: tx, z: tz });
        for (let y = first - 1; y <= last + 1; ++y) {
          const { payload, hash } = world.generate({ lod, x: tx, y, z: tz }, { voxels: false, payload: true, hash: true });
          this.hashes.add(Uint8Array.from(hash.match(/../g).reverse(), (byte) => parseInt(byte, 16)));
          this.payloads.add(payload);
          if (world.decode(payload, { voxels: false, hash: true }).hash !== hash) ++this.decodedOtherwise;
        }
      }
    }
  }

  line(world, what) {
    const otherwise = this.decodedOtherwise === 0 ? '' : `, ${this.decodedOtherwise} payloads decoded otherwise`;
    return `  ${what}: voxels ${world.hash(this.hashes.all())} payloads ${world.hash(this.payloads.all())}${otherwise}\n`;
  }
}

class Bytes {
  #bytes = new Uint8Array(1 << 16);
  #size = 0;

  add(more) {
    if (this.#size + more.length > this.#bytes.length) {
      const larger = new Uint8Array(2 * (this.#size + more.length));
      larger.set(this.all());
      this.#bytes = larger;
    }
    this.#bytes.set(more, this.#size);
    this.#size += more.length;
  }

  all() {
    return this.#bytes.subarray(0, this.#size);
  }
}
