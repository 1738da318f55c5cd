// Frames in a WebSocket: PROTOCOL.md, "WebSocket".
import { originHint, TalusError } from '../errors.js';
import type { OpenTransport } from './transport.js';

/** Required interface of an implementation: browsers', Node 22's, or the package ws. */
interface Socket {
  binaryType: string;
  readonly readyState: number;
  onopen: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  onerror: (() => void) | null;
  send(bytes: Uint8Array): void;
  close(): void;
}
type SocketClass = new (url: string) => Socket;

const OPEN = 1;

export function openWebSocket(url: string, implementation: unknown): OpenTransport {
  const WebSocket = (implementation ?? (globalThis as { WebSocket?: unknown }).WebSocket) as SocketClass | undefined;
  if (WebSocket === undefined) {
    throw new TalusError(
      'unreachable',
      'there is no WebSocket here: pass one as the option WebSocket, or connect by tcp:// with talus-client/node',
    );
  }
  return (events) => {
    const socket = new WebSocket(url);
    socket.binaryType = 'arraybuffer';
    let opened = false;
    const end = (error: TalusError) => {
      socket.onopen = socket.onmessage = socket.onclose = null;
      socket.onerror = () => {}; // ws emits errors that must be handled
      events.ended(error);
    };
    socket.onopen = () => {
      opened = true;
      events.opened();
    };
    socket.onmessage = ({ data }) => {
      if (data instanceof ArrayBuffer) {
        events.received(new Uint8Array(data));
        return;
      }
      end(new TalusError('broken_protocol', 'the server sent text, where the protocol has bytes only'));
      socket.close();
    };
    socket.onerror = () => {}; // onclose follows, and reports it
    socket.onclose = ({ code, reason }) => {
      const why = reason === '' ? `code ${code}` : `${reason} (code ${code})`;
      end(
        opened
          ? new TalusError('disconnected', `the connection to ${url} ended: ${why}`)
          : new TalusError('unreachable', `nobody answers at ${url}${originHint(url)}`),
      );
    };
    return {
      send: (bytes) => {
        if (socket.readyState === OPEN) socket.send(bytes);
      },
      close: () => {
        socket.onopen = socket.onmessage = socket.onclose = null;
        socket.onerror = () => {};
        socket.close();
      },
    };
  };
}
