// Opens the world that a server publishes, with the files that it names.
import { get, HttpError } from '../http/get.js';
import type { ConnectOptions, World as Facts } from '../types.js';
import { workersFor, World } from './world.js';

const MAX_TOML_BYTES = 1 << 20;
const MAX_NAME_BYTES = 1_024;
const MAX_FILES = 256;
/** Of all files together: the largest height map fits. */
const MAX_BYTES = (1 << 28) + (2 << 20);
/** Texts in a world file that may be names of files. */
const NAMES = /["']([^"'\n]+\.(?:vox|npy|png))["']/gi;

/** Rejects with an Error that says why not; an aborted `signal` ends what is fetched. `base`: the server's HTTP address. */
export async function openPublished(options: ConnectOptions, base: string, facts: Facts, signal: AbortSignal): Promise<World> {
  const getter = { fetch: options.fetch ?? globalThis.fetch.bind(globalThis), token: options.token };
  const fetched = async (path: string, most: number): Promise<Uint8Array | null> => {
    try {
      return (await get(getter, base + path, most, signal)).body;
    } catch (error) {
      if (error instanceof HttpError && error.status === 404) return null;
      throw error;
    }
  };
  const toml = await fetched(facts.worldFile, MAX_TOML_BYTES);
  if (toml === null) throw new Error(`${facts.worldFile}: the server has no such file`);
  const files: Record<string, Uint8Array> = {};
  let left = MAX_BYTES - toml.length;
  for (const name of namesIn(toml)) {
    const path = `/v1/${facts.fingerprint}/files/${name.split('/').map(encodeURIComponent).join('/')}`;
    const bytes = await fetched(path, left);
    if (bytes === null) continue;
    left -= bytes.length;
    files[name] = bytes;
  }
  const cores = (globalThis as { navigator?: { hardwareConcurrency?: number } }).navigator?.hardwareConcurrency ?? 2;
  const world = await World.open(toml, { files, workers: workersFor(cores) });
  if (world.fingerprint === facts.fingerprint) return world;
  world.close();
  throw new Error(`the published world is ${world.fingerprint} here, as by another version of the generator; the server's is ${facts.fingerprint}`);
}

function namesIn(toml: Uint8Array): ReadonlySet<string> {
  const names = new Set<string>();
  for (const [, name] of new TextDecoder().decode(toml).matchAll(NAMES)) {
    if (new TextEncoder().encode(name).length > MAX_NAME_BYTES) throw new Error(`the world names a file by more than ${MAX_NAME_BYTES} bytes`);
    if (names.add(name!).size > MAX_FILES) throw new Error(`the world names more than ${MAX_FILES} files`);
  }
  return names;
}
