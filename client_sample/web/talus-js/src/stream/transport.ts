// Carries frames: a WebSocket, or a TCP connection in Node.
import type { TalusError } from '../errors.js';

export interface TransportEvents {
  opened(): void;
  received(bytes: Uint8Array): void;
  /** The connection ended; called once, and not after close(). */
  ended(error: TalusError): void;
}

export interface Transport {
  send(bytes: Uint8Array): void;
  /** Emits no event. */
  close(): void;
}

/** Begins to connect. Calls events later, not at once. */
export type OpenTransport = (events: TransportEvents) => Transport;

/** Starts with the first, and uses the next for each further attempt. */
export function takeTurns(servers: readonly OpenTransport[]): OpenTransport {
  let attempts = 0;
  return (events) => servers[attempts++ % servers.length]!(events);
}
