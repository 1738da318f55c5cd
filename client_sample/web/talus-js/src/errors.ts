// Everything that goes wrong in this package is a TalusError.

export type TalusErrorKind =
  | 'unreachable' // nobody answers there
  | 'refused' // the server will not have this client: version, token; or its edits
  | 'disconnected' // the connection broke, or the server closed it
  | 'timed_out'
  | 'broken_protocol' // the server sent what the protocol does not allow
  | 'bad_chunk' // a payload that does not decode, or is not what its hash says
  | 'out_of_range' // beyond the world or the server's limits
  | 'overloaded' // the server asks to come back after retryAfterMs
  | 'cancelled'
  | 'conflict' // a guard of the edit does not hold: nothing happened
  | 'not_applied' // the edit did not happen
  | 'outcome_unknown' // nobody can say any more whether the edit happened
  | 'server_failed' // the server could not answer; repeating may help
  | 'closed'; // asked of a client that was closed

export class TalusError extends Error {
  override readonly name = 'TalusError';

  constructor(
    readonly kind: TalusErrorKind,
    message: string,
    /** When to try again; 0: no hint. */
    readonly retryAfterMs = 0,
  ) {
    super(message);
  }
}
