// What a client may ask for in a second: PROTOCOL.md, "Rates". Requests, Views and Pings count one each.
import type { Rates } from '../types.js';

export class Pace {
  private tokens = Infinity;
  private most = Infinity;
  private perMs = 0;
  private at = 0;
  private heldUntil = 0; // as the server said

  /** By what Welcome tells. `now` in milliseconds. */
  begin(rates: Rates | null, now: number): void {
    const limited = rates !== null && rates.requests > 0;
    this.perMs = limited ? rates.requests / 1_000 : 0;
    this.tokens = this.most = limited ? Math.max(1, Math.floor((rates.requests * rates.burstMs) / 1_000)) : Infinity;
    this.at = now;
    this.heldUntil = 0;
  }

  /** The server refused something, for so long. */
  refused(retryAfterMs: number, now: number): void {
    this.heldUntil = Math.max(this.heldUntil, now + retryAfterMs);
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
