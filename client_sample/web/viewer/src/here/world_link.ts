// Worlds in links: #world=NAME, or a world file as raw deflate in base64url.

/** As for talusd: "Bounds" in docs/DESIGN.md. */
export const MAX_TOML_BYTES = 1 << 20;
/** What deflate makes of the largest file at worst, in base64. */
const MAX_TEXT = 1_500_000;

export class LinkError extends Error {}

/** The link's world; null: it names none. */
export const worldIn = (hash: string): string | null => new URLSearchParams(hash.replace(/^#/, '')).get('world');

/** The same link to another world, or to the page's own: its place is left out. */
export function linkTo(world: string | null, hash: string): string {
  const said = new URLSearchParams(hash.replace(/^#/, ''));
  for (const key of ['at', 'look', 'mode', 'world']) said.delete(key);
  if (world !== null) said.set('world', world);
  return '#' + said.toString();
}

export async function packed(toml: Uint8Array<ArrayBuffer>): Promise<string> {
  const stream = new Blob([toml]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** Throws a LinkError in words for users. */
export async function unpacked(text: string): Promise<Uint8Array> {
  if (text === '') throw new LinkError('#world= is empty: it needs the name of a world or a world file, packed');
  if (text.length > MAX_TEXT) throw new LinkError(`its world has ${text.length} characters; at most ${MAX_TEXT} are read`);
  return inflated(bytesOf(text));
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const wrong = /[^A-Za-z0-9_-]/.exec(text.replace(/={1,2}$/, ''));
  if (wrong !== null) throw new LinkError(`its world is neither a known name nor base64url: character ${wrong.index + 1} is '${wrong[0]}'`);
  try {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
  } catch {
    throw new LinkError('its world is neither a known name nor whole base64url: the link was cut off or changed');
  }
}

/** Stops at the bound, so that a small link cannot fill the memory. */
async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    let part: ReadableStreamReadResult<Uint8Array>;
    try {
      part = await reader.read();
    } catch {
      throw new LinkError('its world is neither a known name nor a packed world file: the link was cut off or changed');
    }
    if (part.done) break;
    size += part.value.length;
    if (size > MAX_TOML_BYTES) {
      void reader.cancel().catch(() => {});
      throw new LinkError(`its world file is larger than ${MAX_TOML_BYTES} bytes`);
    }
    parts.push(part.value);
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
