// Unanswered pings; a server answers them in order.
import type { TalusError } from '../errors.js';

interface OpenPing {
  readonly sent: number;
  resolve(milliseconds: number): void;
  reject(error: TalusError): void;
}

export class Pings {
  private readonly open = new Map<bigint, OpenPing>();
  private lastNonce = 0;

  get isEmpty(): boolean {
    return this.open.size === 0;
  }

  /** Returns the nonce to send. */
  add(now: number, resolve: (milliseconds: number) => void, reject: (error: TalusError) => void): number {
    this.open.set(BigInt(++this.lastNonce), { sent: now, resolve, reject });
    return this.lastNonce;
  }

  /** Returns the round-trip time in milliseconds; null if the Pong is unsolicited. */
  answered(nonce: bigint, now: number): number | null {
    const ping = this.open.get(nonce);
    if (ping === undefined) return null;
    this.open.delete(nonce);
    ping.resolve(now - ping.sent);
    return now - ping.sent;
  }

  refuseOldest(error: TalusError): void {
    const [oldest] = this.open.entries();
    if (oldest === undefined) return;
    this.open.delete(oldest[0]);
    oldest[1].reject(error);
  }

  failAll(error: TalusError): void {
    const all = [...this.open.values()];
    this.open.clear();
    for (const ping of all) ping.reject(error);
  }
}
