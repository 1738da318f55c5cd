import type { ReconnectPolicy } from '../types.js';

/** No server makes a client wait longer. */
const LONGEST_RETRY_AFTER_MS = 60_000;

/** How long to wait, in milliseconds, where a server asks for `retryAfterMs`. */
export function boundedRetryAfter(retryAfterMs: number): number {
  return Math.max(0, Math.min(retryAfterMs, LONGEST_RETRY_AFTER_MS));
}

/** Exponential, with full jitter: clients of one server do not all return at once. */
export class Backoff {
  private failures = 0;

  constructor(private readonly policy: ReconnectPolicy = {}) {}

  /** The wait after one more failure; null: no attempt is left. `retryAfterMs` is what the server asked for. */
  next(retryAfterMs = 0): number | null {
    const { maxAttempts = Infinity, firstDelayMs = 500, maxDelayMs = 10_000 } = this.policy;
    if (++this.failures > maxAttempts) return null;
    const most = Math.min(maxDelayMs, firstDelayMs * 2 ** Math.min(this.failures - 1, 30));
    return Math.round(boundedRetryAfter(retryAfterMs) + Math.random() * most);
  }

  /** The connection was of use. */
  reset(): void {
    this.failures = 0;
  }
}
