// Keeps an engine running: creates it, recreates it if the server, the token or the graphics fail, and reports errors.
import { Engine, type WorldInfo } from '../engine/engine';
import type { Settings } from '../place/settings';
import type { Obstacle, Server } from './server';
import type { TokenStore } from './token';

export type Trouble =
  | { kind: 'away'; text: string; retryAt: number | null }
  | { kind: 'token'; text: string }
  | { kind: 'refused'; text: string }
  | { kind: 'no-world'; text: string }
  | { kind: 'no-socket'; text: string }
  | { kind: 'no-webgl'; text: string }
  | { kind: 'graphics-lost' };

export interface Listener {
  /** An engine that knows its world is ready; `again`: it replaces an earlier one. */
  opened: (engine: Engine, again: boolean) => void;
  /** The engine is about to be discarded. */
  closing: () => void;
  trouble: (trouble: Trouble | null) => void;
  worldChanged: (world: WorldInfo) => void;
}

const FIRST_RETRY_MS = 500;
const LAST_RETRY_MS = 15_000;
/** A slower first answer is investigated. */
const PATIENCE_MS = 2_000;
/** Browsers usually restore lost graphics by themselves. */
const GRAPHICS_PATIENCE_MS = 6_000;

const asksForToken = (reason: string) => /token|unauthori[sz]ed/i.test(reason);

export class Session {
  engine: Engine | null = null;
  /** When the engine was requested, as performance.now(): the origin of its own times. */
  began = 0;
  #attempt = 0;
  #failures = 0;
  #silences = 0;
  #retry: ReturnType<typeof setTimeout> | undefined;
  #patience: ReturnType<typeof setTimeout> | undefined;
  #fingerprint: string | null = null;
  #wasOpen = false;

  constructor(
    private readonly stage: HTMLElement,
    private readonly settings: Settings,
    private readonly server: Server,
    private readonly tokens: TokenStore,
    private readonly isReduced: () => boolean,
    private readonly listener: Listener,
  ) {
    // A tab that slept, or a machine that was offline, reconnects at once.
    addEventListener('online', () => this.hurry());
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'visible') this.hurry();
    });
  }

  async open(): Promise<void> {
    this.#close();
    this.#silences = 0;
    const attempt = ++this.#attempt;
    // Checked first, as a connecting engine retries for ever without reporting why.
    const obstacle = await this.server.obstacle();
    if (attempt !== this.#attempt) return;
    if (obstacle !== null) return this.#blocked(obstacle);
    const canvas = document.createElement('canvas');
    canvas.id = 'view';
    this.stage.querySelector('canvas')?.remove();
    this.stage.prepend(canvas);
    const { token } = this.tokens;
    let engine: Engine;
    this.#patience = setTimeout(() => void this.#lookInto(attempt), PATIENCE_MS);
    this.began = performance.now();
    try {
      engine = await Engine.create({
        canvas,
        url: this.server.base.replace(/\/$/, ''),
        transport: this.settings.transport,
        ...(this.server.source === null ? {} : { source: this.server.source }),
        ...(token === null ? {} : { token }),
        radius: this.settings.radius,
        horizon: this.settings.horizon,
        quality: this.settings.quality,
        reducedMotion: this.isReduced(),
      });
    } catch (error) {
      if (attempt === this.#attempt) await this.#failed(attempt, error instanceof Error ? error.message : String(error));
      return;
    }
    if (attempt !== this.#attempt) {
      engine.dispose();
      return;
    }
    clearTimeout(this.#patience);
    this.#failures = 0;
    this.#adopt(engine);
  }

  /** Makes the next attempt at once. */
  hurry(): void {
    if (this.#retry !== undefined) void this.open();
    else if (this.engine?.stats().state === 'lost') this.engine.hurry();
  }

  /** After a refusal, and after a new token. */
  again(): void {
    if (this.engine === null) return void this.open();
    const { token } = this.tokens;
    if (token !== null) this.engine.setToken(token);
    this.engine.reconnect();
  }

  #adopt(engine: Engine): void {
    this.engine = engine;
    engine.on('state', (state, reason) => {
      if (state === 'lost') this.#trouble({ kind: 'away', text: reason, retryAt: null });
      else if (state === 'refused')
        this.#trouble(asksForToken(reason) ? { kind: 'token', text: reason } : { kind: 'refused', text: reason });
      else if (state !== 'connecting') this.#trouble(null);
    });
    engine.on('world', (world) => this.#meet(world));
    engine.on('contextLost', () => {
      this.#trouble({ kind: 'graphics-lost' });
      this.#patience = setTimeout(() => void this.open(), GRAPHICS_PATIENCE_MS);
    });
    engine.on('contextRestored', () => {
      clearTimeout(this.#patience);
      this.#trouble(null);
    });
    this.listener.opened(engine, this.#wasOpen);
    this.#wasOpen = true;
    this.#trouble(null);
    this.#meet(engine.world);
  }

  #meet(world: WorldInfo): void {
    const isOther = this.#fingerprint !== null && this.#fingerprint !== world.fingerprint;
    this.#fingerprint = world.fingerprint;
    if (isOther) this.listener.worldChanged(world);
  }

  /** No engine after a while, although the server answers: its stream is blocked, or the server just went away. */
  async #lookInto(attempt: number): Promise<void> {
    const obstacle = await this.server.obstacle();
    if (attempt !== this.#attempt || this.engine !== null) return;
    if (obstacle?.kind === 'away') this.#trouble({ kind: 'away', text: obstacle.text, retryAt: null });
    else if (this.settings.transport === 'websocket' && ++this.#silences > 1)
      this.#trouble({ kind: 'no-socket', text: 'The server answers, but its WebSocket does not open.' });
    this.#patience = setTimeout(() => void this.#lookInto(attempt), PATIENCE_MS);
  }

  async #failed(attempt: number, reason: string): Promise<void> {
    clearTimeout(this.#patience);
    if (document.createElement('canvas').getContext('webgl2') === null)
      return this.#trouble({ kind: 'no-webgl', text: reason });
    const obstacle = await this.server.obstacle();
    if (attempt === this.#attempt)
      this.#blocked(obstacle ?? { kind: asksForToken(reason) ? 'token' : 'away', text: reason });
  }

  #blocked({ kind, text }: Obstacle): void {
    if (kind === 'token' || kind === 'no-world') return this.#trouble({ kind, text });
    if (kind !== 'away') return this.#trouble({ kind: 'refused', text });
    const delay = Math.min(LAST_RETRY_MS, FIRST_RETRY_MS * 2 ** this.#failures++);
    this.#retry = setTimeout(() => void this.open(), delay);
    this.#trouble({ kind, text, retryAt: performance.now() + delay });
  }

  #trouble(trouble: Trouble | null): void {
    this.listener.trouble(trouble);
  }

  #close(): void {
    clearTimeout(this.#retry);
    clearTimeout(this.#patience);
    this.#retry = undefined;
    if (this.engine === null) return;
    this.listener.closing();
    this.engine.dispose();
    this.engine = null;
  }
}
