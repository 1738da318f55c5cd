// Limits requests per second: PROTOCOL.md, "Rates". Requests, Views and Pings count one each.
import { boundedRetryAfter } from '../client/backoff.js';
import type { Limits } from '../types.js';

/** An eighth is reserved, as the two clocks differ. */
const SHARE = 7 / 8;

export class Pace {
  private tokens = Infinity;
  private most = Infinity;
  private perMs = 0;
  private at = 0;
  private heldUntil = 0; // requested by the server

  /** Starts with the rates in Welcome: the lower of the session's and the address's. `now` in milliseconds. */
  begin({ sessionRates, addressRates }: Pick<Limits, 'sessionRates' | 'addressRates'>, now: number): void {
    this.perMs = 0;
    this.tokens = this.most = Infinity;
    for (const rates of [sessionRates, addressRates]) {
      if (rates === null || rates.requests === 0 || (this.perMs > 0 && rates.requests / 1_000 >= this.perMs)) continue;
      this.perMs = rates.requests / 1_000;
      this.tokens = this.most = Math.max(1, this.perMs * rates.burstMs * SHARE);
    }
    this.at = now;
    this.heldUntil = 0;
  }

  /** The server refused a request for this time. */
  refused(retryAfterMs: number, now: number): void {
    this.heldUntil = Math.max(this.heldUntil, now + boundedRetryAfter(retryAfterMs));
  }

  /** Milliseconds until one more may be sent; 0: now. */
  wait(now: number): number {
    this.tokens = Math.min(this.most, this.tokens + (now - this.at) * this.perMs);
    this.at = now;
    const forToken = this.tokens >= 1 ? 0 : (1 - this.tokens) / this.perMs;
    return Math.ceil(Math.max(forToken, this.heldUntil - now, 0));
  }

  take(): void {
    this.tokens -= 1;
  }
}
