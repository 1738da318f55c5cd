// The engine of the viewer: streams chunks, meshes them in workers and draws them.
import type { EngineEvents, EngineOptions, Hit, Slice, Stats, Vector, WorldInfo } from './api.js';

export type * from './api.js';

export declare class Engine {
  /** Resolves once the server has said what its world is; rejects with a TalusError, or an Error whose text says
   *  what the browser lacks (WebGL 2). */
  static create(options: EngineOptions): Promise<Engine>;

  readonly world: WorldInfo;

  setCamera(x: number, y: number, z: number, yaw: number, pitch: number): void;
  setFov(degrees: number): void;
  /** Draws. `now` as of requestAnimationFrame, in milliseconds. */
  frame(now: number): void;
  resize(width: number, height: number, devicePixelRatio: number): void;

  /** Material of the base voxel at integer coordinates; undefined: not here yet. */
  voxelAt(x: number, y: number, z: number): number | undefined;
  /** The first voxel that is not gas, nor liquid unless `liquids`. */
  raycast(origin: Vector, direction: Vector, max: number, liquids?: boolean): Hit | null;
  isSolid(material: number): boolean;
  isLiquid(material: number): boolean;

  /** 0 to 24; the sun rises at 6. */
  setTimeOfDay(hours: number): void;
  setSlice(slice: Slice | null): void;
  setChunkBorders(on: boolean): void;
  /** Frames a voxel; null: none. */
  setSelection(voxel: Vector | null): void;
  setRadius(radius: number, horizon: number): void;
  setQuality(quality: 'low' | 'high'): void;
  setReducedMotion(on: boolean): void;
  setToken(token: string): void;
  reconnect(): void;
  /** The next picture as a PNG. */
  screenshot(): Promise<Blob>;

  stats(): Stats;
  on<K extends keyof EngineEvents>(event: K, handler: EngineEvents[K]): () => void;
  dispose(): void;
}
