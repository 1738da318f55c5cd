// Decides when to send a View, as the camera moves and turns.
import type { View } from 'talus';
import type { WorldInfo } from '../api.js';
import { viewFor } from './shape.js';

/** Minimum interval of Views, which are sent when the camera has moved by a chunk or turned by 30 degrees. */
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
  /** Identifies the chunks of the View sent; empty: none was sent. */
  private chunks = '';
  private yaw = 0;
  private at = -Infinity;

  get hasSent(): boolean {
    return this.chunks !== '';
  }

  /** Sends the next View at once, whatever was sent before. */
  reset(): void {
    this.chunks = '';
    this.at = -Infinity;
  }

  /** The View to send now; null: no View. `moved`: its chunks differ from the previous View's. `complete`: nothing is
   *  missing, so turning the camera does not change the order of arrival. */
  next(now: number, world: WorldInfo, eye: Camera, radius: number, horizon: number, complete: boolean): { view: View; moved: boolean } | null {
    if (now - this.at < VIEW_EVERY_MS) return null;
    const { yaw, pitch } = eye;
    const direction = { x: Math.sin(yaw) * Math.cos(pitch), y: Math.sin(pitch), z: -Math.cos(yaw) * Math.cos(pitch) };
    const view = viewFor(world, eye, direction, radius, horizon);
    const { x, y, z } = view.centre;
    const chunk = (v: number) => Math.floor(v / 32);
    const chunks = JSON.stringify([chunk(x), chunk(y), chunk(z), view.horizontalRadius, view.verticalRadius, view.rings]);
    const turned = Math.abs(Math.atan2(Math.sin(yaw - this.yaw), Math.cos(yaw - this.yaw))) > TURN;
    // Only another View has another end; movement within a row of chunks does not change it.
    const moved = chunks !== this.chunks;
    if (!moved && !(turned && !complete)) return null;
    this.chunks = chunks;
    this.yaw = yaw;
    this.at = now;
    return { view, moved };
  }
}
