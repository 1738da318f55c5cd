// What carries frames: a WebSocket, or a TCP connection in Node.
import { TalusError } from '../errors.js';

export interface TransportEvents {
  opened(): void;
  received(bytes: Uint8Array): void;
  /** Nothing comes any more; once, and not after close(). */
  ended(error: TalusError): void;
}

export interface Transport {
  send(bytes: Uint8Array): void;
  /** Without an event. */
  close(): void;
}

/** Begins to connect. Calls events later, not at once. */
export type OpenTransport = (events: TransportEvents) => Transport;

/** The first at first, and the next at each attempt after. */
export function takeTurns(servers: readonly OpenTransport[]): OpenTransport {
  let attempts = 0;
  return (events) => servers[attempts++ % servers.length]!(events);
}

export function urlsOf(url: string | readonly string[]): readonly string[] {
  const urls = typeof url === 'string' ? [url] : url;
  if (urls.length === 0) throw new TalusError('unreachable', 'url: there is none');
  return urls;
}
