// Talus in browsers and Node. README.md begins with an example.
import { TalusError } from './errors.js';
import { HttpClient } from './http/client.js';
import { StreamClient } from './stream/client.js';
import { type OpenTransport, takeTurns } from './stream/transport.js';
import { openWebSocket } from './stream/websocket.js';
import type { Client, ConnectOptions } from './types.js';
import { parsedUrl, shownUrl, urlsOf } from './url.js';

export { CHUNK_SIZE, CHUNK_VOLUME, decodeChunk, DecodeError, type DecodeFault } from './decode.js';
export { apronVolume, ChunkStore, MAX_APRON, neighbourBit } from './chunk_store.js';
export { encodeChunk } from './encode.js';
export { hashVoxels } from './hash.js';
export { TalusError, type TalusErrorKind } from './errors.js';
export type * from './types.js';
export { MAX_LOD, type Range, ringsBetween, ViewShape } from './view_shape.js';

/** Connects and joins; ConnectOptions.url selects the transport. There is nothing to await: calls made before the
 *  client has joined are kept. */
export function connect(options: ConnectOptions): Client {
  const urls = urlsOf(options?.url);
  const [first] = urls.map(parsedUrl);
  if (urls.length === 1 && (first!.protocol === 'http:' || first!.protocol === 'https:')) {
    return new HttpClient(options, first!);
  }
  return new StreamClient(options, takeTurns(urls.map((url) => openStream(url, options))));
}

function openStream(text: string, options: ConnectOptions): OpenTransport {
  const url = parsedUrl(text);
  if (url.protocol !== 'ws:' && url.protocol !== 'wss:') {
    throw new TalusError(
      'unreachable',
      `url ${shownUrl(text)}: ws:, wss:, and of one server http: and https: are known here; tcp: and tls: in talus-client/node`,
    );
  }
  if (!url.pathname.endsWith('/v1/stream')) url.pathname = `${url.pathname.replace(/\/$/, '')}/v1/stream`;
  return openWebSocket(url.href, options.WebSocket);
}
