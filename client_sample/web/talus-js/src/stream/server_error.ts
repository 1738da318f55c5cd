// Converts a server's Error for the application.
import { TalusError } from '../errors.js';
import type { ServerMessage } from '../wire/messages.js';

export function errorOf({ code, text, retryAfterMs }: Extract<ServerMessage, { kind: 'error' }>): TalusError {
  const said = `the server says: ${text}`;
  switch (code) {
    case 'version':
    case 'unauthorized':
    case 'forbidden':
    case 'unsupported':
      return new TalusError('refused', said);
    case 'malformed':
    case 'unexpected':
      return new TalusError('broken_protocol', said);
    case 'too_large':
    case 'too_many_requests':
    case 'out_of_range':
      return new TalusError('out_of_range', said);
    case 'overloaded':
      return new TalusError('overloaded', said, retryAfterMs);
    case 'cancelled':
      return new TalusError('cancelled', said);
    case 'conflict':
    case 'not_applied':
      return new TalusError(code, said);
    case 'timeout':
      return new TalusError('timed_out', said);
    default:
      return new TalusError('server_failed', said, retryAfterMs);
  }
}
