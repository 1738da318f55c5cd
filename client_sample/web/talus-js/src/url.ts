// URLs of servers, as the application gives them.
import { TalusError } from './errors.js';

/** Checks the option `url`, and returns the URLs in it. */
export function urlsOf(given: unknown): readonly string[] {
  const urls: readonly unknown[] = Array.isArray(given) ? given : [given];
  if (urls.length === 0) throw new TalusError('unreachable', 'url: there is none');
  for (const url of urls) {
    if (typeof url === 'string') continue;
    throw new TalusError('unreachable', `url: a string or a list of strings is needed, not ${url === null ? 'null' : typeof url}`);
  }
  return urls as readonly string[];
}

/** Without what may be secret: for messages. */
export function shownUrl(text: string): string {
  return text.replace(/[?#].*$/s, '').replace(/^([^/]*:?\/\/)?.*@/s, '$1');
}

/** Parses a URL, which may be relative to the page. Throws a TalusError if it cannot be connected to. */
export function parsedUrl(text: string): URL {
  const wrong = (why: string) => new TalusError('unreachable', `url ${shownUrl(text)}: ${why}`);
  let url: URL | undefined;
  try {
    const page = globalThis.location as Location | undefined;
    url = new URL(text, page?.host ? page.origin + page.pathname : undefined);
  } catch {
    // Its message repeats the URL.
  }
  if (url === undefined || url.hostname === '') throw wrong('it is not one of a server, as ws://127.0.0.1:4781 is');
  if (url.username !== '' || url.password !== '') {
    throw wrong('user and password in it are never sent; give the token as the option token');
  }
  url.search = url.hash = '';
  return url;
}
