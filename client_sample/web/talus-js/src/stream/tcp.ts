// Frames over TCP or TLS, in Node.
import type net from 'node:net';
import { TalusError } from '../errors.js';
import type { OpenTransport } from './transport.js';

/** `connect` begins to connect; `ready` is the event that reports success. */
export function openSocket(
  where: string,
  connect: () => net.Socket,
  ready: 'connect' | 'secureConnect',
): OpenTransport {
  return (events) => {
    const socket = connect();
    socket.setNoDelay(true);
    let opened = false;
    let failure: Error | undefined;
    socket.on(ready, () => {
      opened = true;
      events.opened();
    });
    socket.on('data', (bytes) => events.received(bytes));
    socket.on('error', (error) => {
      failure = error;
    });
    socket.on('close', () => {
      const why = failure === undefined ? 'the server closed it' : failure.message;
      events.ended(
        opened
          ? new TalusError('disconnected', `the connection to ${where} ended: ${why}`)
          : new TalusError('unreachable', `${where} cannot be reached: ${why}`),
      );
    });
    return {
      send: (bytes) => {
        if (!socket.destroyed) socket.write(bytes);
      },
      close: () => {
        socket.removeAllListeners();
        socket.on('error', () => {});
        socket.destroy();
      },
    };
  };
}
