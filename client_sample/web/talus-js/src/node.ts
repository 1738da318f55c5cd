// For Node: everything in talus-client, plus plain TCP and TLS.
import net from 'node:net';
import tls from 'node:tls';
import { TalusError } from './errors.js';
import { connect as connectAnywhere } from './index.js';
import { StreamClient } from './stream/client.js';
import { openSocket } from './stream/tcp.js';
import { type OpenTransport, takeTurns } from './stream/transport.js';
import type { Client, ConnectOptions } from './types.js';
import { parsedUrl, shownUrl, urlsOf } from './url.js';

export * from './index.js';

const DEFAULT_PORT = 4780;

export interface NodeConnectOptions extends ConnectOptions {
  /** For tls://: options of node:tls, such as `ca` and `servername`. */
  readonly tls?: tls.ConnectionOptions;
}

/** Like connect() of talus-client, but a url may also be tcp://HOST:PORT or tls://HOST:PORT, by default with port 4780.
 *  Either all urls or none may use these schemes. */
export function connect(options: NodeConnectOptions): Client {
  const urls = urlsOf(options?.url);
  if (!urls.some(isSocket)) return connectAnywhere(options);
  return new StreamClient(options, takeTurns(urls.map((url) => openAny(url, options))));
}

const isSocket = (url: string) => /^(tcp|tls):/.test(url);

function openAny(text: string, options: NodeConnectOptions): OpenTransport {
  const shown = shownUrl(text);
  if (!isSocket(text)) throw new TalusError('unreachable', `url ${shown}: others are tcp: or tls:, so this must be, too`);
  const url = parsedUrl(text);
  const host = url.hostname.replace(/^\[|\]$/g, ''); // brackets of IPv6
  const port = url.port === '' ? DEFAULT_PORT : Number(url.port);
  if (url.protocol === 'tcp:') return openSocket(shown, () => net.connect({ host, port }), 'connect');
  const secure = { host, port, minVersion: 'TLSv1.3', ...(net.isIP(host) ? {} : { servername: host }) } as const;
  const open = () => tls.connect({ ...secure, ...options.tls });
  return openSocket(shown, open, 'secureConnect');
}
