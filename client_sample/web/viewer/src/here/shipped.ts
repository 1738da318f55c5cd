// The worlds that come with the page, and the models that they name.

type Urls = Record<string, string>;

const byName = (urls: Urls): ReadonlyMap<string, string> =>
  new Map(Object.entries(urls).map(([path, url]) => [path.slice(path.lastIndexOf('/') + 1), url]));

const worlds = byName(import.meta.glob('../../../../../core/worlds/*.toml', { query: '?url', import: 'default', eager: true }));
const models = byName(import.meta.glob('../../../../../core/worlds/*.vox', { query: '?url', import: 'default', eager: true }));

export const DEFAULT_WORLD = 'default';

/** In the order of a list for people. */
export const WORLD_NAMES: readonly string[] = [...worlds.keys()]
  .map((file) => file.replace(/\.toml$/, ''))
  .sort((a, b) => Number(b === DEFAULT_WORLD) - Number(a === DEFAULT_WORLD) || a.localeCompare(b, 'en'));

export async function shippedWorld(name: string): Promise<Uint8Array> {
  return load(worlds.get(`${name}.toml`)!);
}

/** Of the shipped models those that a world file mentions. */
export async function modelsOf(toml: Uint8Array): Promise<Record<string, Uint8Array>> {
  const text = new TextDecoder().decode(toml);
  const named = [...models].filter(([file]) => text.includes(file));
  return Object.fromEntries(await Promise.all(named.map(async ([file, url]) => [file, await load(url)] as const)));
}

async function load(url: string): Promise<Uint8Array> {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}`);
  return new Uint8Array(await answer.arrayBuffer());
}
