// What carries frames: a WebSocket, or a TCP connection in Node.
import type { TalusError } from '../errors.js';

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
