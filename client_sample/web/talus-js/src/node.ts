// For Node: everything of talus-client, and plain TCP and TLS.
import net from 'node:net';
import tls from 'node:tls';
import { connect as connectAnywhere } from './index.js';
import { StreamClient } from './stream/client.js';
import { openSocket } from './stream/tcp.js';
import type { Client, ConnectOptions } from './types.js';

export * from './index.js';

const DEFAULT_PORT = 4780;

export interface NodeConnectOptions extends ConnectOptions {
  /** Of tls://: what node:tls takes, such as `ca` and `servername`. */
  readonly tls?: tls.ConnectionOptions;
}

/** As connect() of talus-client; the url may also be tcp://HOST:PORT or tls://HOST:PORT, of port 4780 unless told. */
export function connect(options: NodeConnectOptions): Client {
  const url = new URL(options.url);
  if (url.protocol !== 'tcp:' && url.protocol !== 'tls:') return connectAnywhere(options);
  const host = url.hostname.replace(/^\[|\]$/g, ''); // of IPv6
  const port = url.port === '' ? DEFAULT_PORT : Number(url.port);
  if (url.protocol === 'tcp:') {
    return new StreamClient(options, openSocket(options.url, () => net.connect({ host, port }), 'connect'));
  }
  const secure = { host, port, minVersion: 'TLSv1.3', ...(net.isIP(host) ? {} : { servername: host }) } as const;
  const open = () => tls.connect({ ...secure, ...options.tls });
  return new StreamClient(options, openSocket(options.url, open, 'secureConnect'));
}
