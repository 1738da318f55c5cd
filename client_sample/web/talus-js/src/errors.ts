// All errors of this package are TalusErrors.

export type TalusErrorKind =
  | 'unreachable' // nothing answers at the address
  | 'refused' // the server rejects this client (version, token) or its edits, or it is not a Talus server
  | 'disconnected' // the connection broke, or the server closed it
  | 'timed_out'
  | 'broken_protocol' // the server violated the protocol
  | 'bad_chunk' // a payload failed to decode, or does not match its hash
  | 'out_of_range' // a wrong argument, or outside the world or the server's limits
  | 'overloaded' // the server asks for a retry after retryAfterMs
  | 'cancelled'
  | 'conflict' // a guard of the edit does not hold: nothing was applied
  | 'not_applied' // the edit was not applied
  | 'outcome_unknown' // it can no longer be known whether the edit was applied
  | 'cannot_generate' // chunks of a published world are streamed, not made here
  | 'not_kept' // of a world made here: the edits last until the page is closed
  | 'server_failed' // the server could not answer; a retry may succeed
  | 'closed'; // called on a closed client

export class TalusError extends Error {
  override readonly name = 'TalusError';

  constructor(
    readonly kind: TalusErrorKind,
    message: string,
    /** Delay before a retry; 0: no hint. */
    readonly retryAfterMs = 0,
  ) {
    super(message);
  }
}

/** Runs a check of the application's arguments, so that those of a wrong type are TalusErrors, too. */
export function checking<T>(what: string, check: () => T): T {
  try {
    return check();
  } catch (error) {
    if (error instanceof TalusError) throw error;
    throw new TalusError('out_of_range', `${what}: ${(error as Error).message}`);
  }
}

/** In a page of another host than `url`: the reason that browsers keep from scripts. Otherwise empty. */
export function originHint(url: string): string {
  const page = (globalThis as { location?: { origin?: string; host?: string } }).location;
  if (page?.origin === undefined || page.host === new URL(url).host) return '';
  return `, or the server refuses pages of ${page.origin}: its setting http.origins lists the origins that may connect`;
}
