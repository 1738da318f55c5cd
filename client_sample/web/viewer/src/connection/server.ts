// The page's own HTTP requests: server status, heights, map tiles.
import type { Client } from 'talus';
import { bestHeading, outlookRequest } from '../place/outlook';

export interface ServerWorld {
  readonly server: string;
  readonly fingerprint: string;
  readonly spawn: readonly [number, number, number];
}

/** Reason for a missing answer, in words for users. */
export type Obstacle = { kind: 'away' | 'token' | 'blocked' | 'no-world' | 'other'; text: string };

export class Server {
  /** The page's own folder, so that a proxy may serve everything below a path. */
  readonly base: string;
  /** Makes the world's chunks; null: the server sends them. */
  readonly source: (() => Client) | null = null;

  constructor(
    page: string,
    private readonly token: () => string | null,
  ) {
    this.base = new URL('./', page).href;
  }

  fetch(path: string, init: RequestInit = {}): Promise<Response> {
    const token = this.token();
    const headers = new Headers(init.headers);
    if (token !== null) headers.set('Authorization', `Bearer ${token}`);
    return fetch(this.base + path, { ...init, headers });
  }

  async world(signal?: AbortSignal): Promise<ServerWorld> {
    const answer = await this.fetch('v1/world', { signal: signal ?? null });
    if (!answer.ok) throw new Error(await reasonOf(answer));
    return (await answer.json()) as ServerWorld;
  }

  /** The first free row above the ground of a column. */
  async ground(x: number, z: number): Promise<number> {
    const answer = await this.fetch(`v1/heights?columns=${Math.floor(x)},${Math.floor(z)}`);
    if (!answer.ok) throw new Error(await reasonOf(answer));
    const { heights } = (await answer.json()) as { heights: number[] };
    return (heights[0]! + 127) >> 8;
  }

  /** Heading in degrees over open ground to high land. */
  async outlook(x: number, z: number): Promise<number> {
    const answer = await this.fetch(outlookRequest(x, z));
    if (!answer.ok) throw new Error(await reasonOf(answer));
    return bestHeading(((await answer.json()) as { heights: number[] }).heights);
  }

  /** False if the page's host is certainly no Talus server, but a folder of files. */
  async isThere(): Promise<boolean> {
    try {
      const answer = await this.fetch('v1/world', { signal: AbortSignal.timeout(10_000), cache: 'no-store' });
      if (answer.status === 401 || answer.status === 429 || answer.status >= 500) return true;
      const said = (await answer.json()) as object;
      return 'fingerprint' in said || 'error' in said;
    } catch (error) {
      return !(error instanceof SyntaxError);
    }
  }

  /** Called after a failure: the obstacle between this page and the world; null: none any more. */
  async obstacle(): Promise<Obstacle | null> {
    let answer: Response;
    try {
      answer = await this.fetch('v1/world', { signal: AbortSignal.timeout(10_000), cache: 'no-store' });
    } catch {
      return { kind: 'away', text: 'Nobody answers there.' };
    }
    if (answer.ok) return null;
    const text = await reasonOf(answer);
    if (answer.status === 401) return { kind: 'token', text };
    if (answer.status === 403) return { kind: 'blocked', text };
    // 502 to 504: a proxy whose server is away; 429, 503: the server is full.
    return { kind: answer.status === 429 || answer.status >= 500 ? 'away' : 'other', text };
  }
}

async function reasonOf(answer: Response): Promise<string> {
  try {
    const { error } = (await answer.json()) as { error: { text: string } };
    if (typeof error.text === 'string') return error.text;
  } catch {
    // Not talusd's answer.
  }
  return `the server answers ${answer.status}`;
}
