import type { ReconnectPolicy } from '../types.js';

/** Upper bound of the delay that a server can ask for. */
const LONGEST_RETRY_AFTER_MS = 60_000;

/** Delay in milliseconds if a server asks for `retryAfterMs`. */
export function boundedRetryAfter(retryAfterMs: number): number {
  return Math.max(0, Math.min(retryAfterMs, LONGEST_RETRY_AFTER_MS));
}

/** Exponential with full jitter, so that the clients of one server do not return all at once. */
export class Backoff {
  private failures = 0;

  constructor(private readonly policy: ReconnectPolicy = {}) {}

  /** Delay after one more failure; null: no attempts are left. `retryAfterMs`: the delay that the server asked for. */
  next(retryAfterMs = 0): number | null {
    const { maxAttempts = Infinity, firstDelayMs = 500, maxDelayMs = 10_000 } = this.policy;
    if (++this.failures > maxAttempts) return null;
    const most = Math.min(maxDelayMs, firstDelayMs * 2 ** Math.min(this.failures - 1, 30));
    return Math.round(boundedRetryAfter(retryAfterMs) + Math.random() * most);
  }

  /** The connection was useful. */
  reset(): void {
    this.failures = 0;
  }
}
