// Opens the world that a server publishes, with the files that it names.
import type { ConnectOptions, World as Facts } from '../types.js';
import { World } from './world.js';

const MAX_TOML_BYTES = 1 << 20;
const MAX_FILE_BYTES = 64 << 20;
/** Texts in a world file that may be names of files. */
const NAMES = /["']([^"'\n]+\.(?:vox|npy|png))["']/gi;

const workersFor = (cores: number): number => Math.min(4, Math.max(1, cores >> 1));

/** Rejects with an Error that says why not. `base`: the server's HTTP address. */
export async function openPublished({ token, fetch = globalThis.fetch }: ConnectOptions, base: string, facts: Facts): Promise<World> {
  const headers: Record<string, string> = token === undefined ? {} : { Authorization: `Bearer ${token}` };
  const get = async (path: string, most: number): Promise<Uint8Array | null> => {
    const answer = await fetch(base + path, { headers });
    if (answer.status === 404) return null;
    if (!answer.ok) throw new Error(`${path}: the server answers ${answer.status}`);
    return bounded(answer, path, most);
  };
  const toml = await get(facts.worldFile, MAX_TOML_BYTES);
  if (toml === null) throw new Error(`${facts.worldFile}: the server has no such file`);
  const files: Record<string, Uint8Array> = {};
  for (const [, name] of new TextDecoder().decode(toml).matchAll(NAMES)) {
    if (name! in files) continue;
    const path = `/v1/${facts.fingerprint}/files/${name!.split('/').map(encodeURIComponent).join('/')}`;
    const bytes = await get(path, MAX_FILE_BYTES);
    if (bytes !== null) files[name!] = bytes;
  }
  const cores = (globalThis as { navigator?: { hardwareConcurrency?: number } }).navigator?.hardwareConcurrency ?? 2;
  const world = await World.open(toml, { files, workers: workersFor(cores) });
  if (world.fingerprint === facts.fingerprint) return world;
  world.close();
  throw new Error(`the published world is ${world.fingerprint} here, as by another version of the generator; the server's is ${facts.fingerprint}`);
}

async function bounded(answer: Response, path: string, most: number): Promise<Uint8Array> {
  const parts: Uint8Array[] = [];
  let size = 0;
  const reader = answer.body!.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) {
      void reader.cancel().catch(() => {});
      throw new Error(`${path} is larger than ${most} bytes`);
    }
    parts.push(value);
  }
  const whole = new Uint8Array(size);
  parts.reduce((at, part) => (whole.set(part, at), at + part.length), 0);
  return whole;
}
