// Serves the built viewer, with talusd behind it: for a talusd without --web, and for tests that put something between.
import { createReadStream, statSync } from 'node:fs';
import { createServer, request } from 'node:http';
import { request as secureRequest } from 'node:https';
import { connect } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { connect as secureConnect } from 'node:tls';

export const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.wasm': 'application/wasm' };

export const POLICY =
  "default-src 'self'; connect-src 'self' ws: wss:; img-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; frame-ancestors 'none'";

/** `target()` is HOST:PORT of talusd's HTTP; it may be another one with every request. `tls`: talusd speaks it. */
export async function serve(folder, target, { port = 0, tls = false } = {}) {
  const whoever = { rejectUnauthorized: false };
  const headersFor = (incoming) => ({ ...incoming.headers, host: target() });
  const server = createServer((incoming, answer) => {
    const path = new URL(incoming.url, 'http://site').pathname;
    if (path.startsWith('/v1/')) {
      const [host, to] = target().split(':');
      const asked = { host, port: to, path: incoming.url, method: incoming.method, headers: headersFor(incoming), ...whoever };
      const onward = (tls ? secureRequest : request)(asked, (got) => {
        answer.writeHead(got.statusCode, got.headers);
        got.pipe(answer);
      });
      onward.on('error', () => {
        if (!answer.headersSent) answer.writeHead(502);
        answer.end();
      });
      incoming.on('close', () => onward.destroy());
      return onward.end();
    }
    const file = join(folder, normalize(path === '/' ? '/index.html' : path));
    let size;
    try {
      size = statSync(file).size;
    } catch {
      return answer.writeHead(404).end();
    }
    answer.writeHead(200, { 'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream', 'Content-Length': size, 'Content-Security-Policy': POLICY });
    createReadStream(file).pipe(answer);
  });
  server.on('upgrade', (incoming, socket, head) => {
    const [host, to] = target().split(':');
    const onward = (tls ? secureConnect : connect)({ host, port: Number(to), ...whoever }, () => {
      const headers = { ...headersFor(incoming), origin: `${tls ? 'https' : 'http'}://${target()}` };
      onward.write(`GET ${incoming.url} HTTP/1.1\r\n` + Object.entries(headers).map(([k, v]) => `${k}: ${v}\r\n`).join('') + '\r\n');
      onward.write(head);
      onward.pipe(socket).pipe(onward);
    });
    for (const [one, other] of [[onward, socket], [socket, onward]]) { // prettier-ignore
      one.on('error', () => other.destroy());
      one.on('close', () => other.destroy());
    }
  });
  await new Promise((resolve, reject) => server.once('error', reject).listen(port, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    close: () => new Promise((resolve) => (server.closeAllConnections(), server.close(resolve))),
  };
}
