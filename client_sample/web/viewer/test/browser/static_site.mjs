// A plain host of files, as any is, with a strict policy: no server of Talus is behind it.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { TYPES } from './site.mjs';

export const STRICT = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; worker-src 'self'; connect-src 'self'; img-src 'self' blob: data:";

/** `folder` at the path /talus/, as on a page of somebody's. */
export async function serveFiles(t, folder) {
  const server = createServer(({ url }, answer) => {
    const path = new URL(url, 'http://site').pathname.replace(/^\/talus\//, '/');
    const file = join(folder, normalize(path === '/' ? '/index.html' : path));
    const found = statSync(file, { throwIfNoEntry: false });
    if (!found?.isFile()) return answer.writeHead(404, { 'Content-Type': 'text/html' }).end('<h1>404</h1>');
    answer.writeHead(200, { 'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream', 'Content-Security-Policy': STRICT });
    createReadStream(file).pipe(answer);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => (server.closeAllConnections(), server.close()));
  return `http://127.0.0.1:${server.address().port}/talus/`;
}
