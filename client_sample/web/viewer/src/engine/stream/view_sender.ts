// When the server is told of another View: as the camera moves and turns.
import type { View } from 'talus';
import type { WorldInfo } from '../api.js';
import { viewFor } from './shape.js';

/** A View is sent when the camera has gone a chunk or turned by 30 degrees, and no more often than this. */
const VIEW_EVERY_MS = 250;
const TURN = Math.PI / 6;

export interface Camera {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly yaw: number;
  readonly pitch: number;
}

export class ViewSender {
  /** Names those of the View that was sent; empty: none was. */
  private chunks = '';
  private yaw = 0;
  private at = -Infinity;

  get hasSent(): boolean {
    return this.chunks !== '';
  }

  /** The next is sent at once, whatever was sent before. */
  reset(): void {
    this.chunks = '';
    this.at = -Infinity;
  }

  /** The View to send now; null: none. `moved`: it has other chunks than that before. `complete`: nothing is to come, so
   *  that no turn of the camera changes what comes first. */
  next(now: number, world: WorldInfo, eye: Camera, radius: number, horizon: number, complete: boolean): { view: View; moved: boolean } | null {
    if (now - this.at < VIEW_EVERY_MS) return null;
    const { yaw, pitch } = eye;
    const direction = { x: Math.sin(yaw) * Math.cos(pitch), y: Math.sin(pitch), z: -Math.cos(yaw) * Math.cos(pitch) };
    const view = viewFor(world, eye, direction, radius, horizon);
    const { x, y, z } = view.centre;
    const chunk = (v: number) => Math.floor(v / 32);
    const chunks = JSON.stringify([chunk(x), chunk(y), chunk(z), view.horizontalRadius, view.verticalRadius, view.rings]);
    const turned = Math.abs(Math.atan2(Math.sin(yaw - this.yaw), Math.cos(yaw - this.yaw))) > TURN;
    // Only another View has another end: one moves through rows of chunks without.
    const moved = chunks !== this.chunks;
    if (!moved && !(turned && !complete)) return null;
    this.chunks = chunks;
    this.yaw = yaw;
    this.at = now;
    return { view, moved };
  }
}
