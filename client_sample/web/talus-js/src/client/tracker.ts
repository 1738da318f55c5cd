// The View, and the chunks of it that were delivered to the application.
import { keyName } from '../keys.js';
import type { Chunk, ChunkKey, View } from '../types.js';
import { chunksOutside, countOf, forEachChunk } from '../view_difference.js';
import type { Heights, ViewShape } from '../view_shape.js';
import { ViewShape as Shape } from '../view_shape.js';

export interface DeliveredChunk {
  readonly key: ChunkKey;
  readonly revision: bigint;
  readonly hash: string | null;
  readonly material: number | null;
}

export class Tracker {
  view: View | null = null;
  shape: ViewShape | null = null;
  private readonly delivered = new Map<string, DeliveredChunk>();

  /** Replaces the View; returns the chunks that left. */
  replace(view: View | null, heights: Heights): ChunkKey[] {
    const before = this.shape;
    this.view = view;
    this.shape = view === null ? null : new Shape(view, heights);
    const left: ChunkKey[] = [];
    if (before === null) return left; // nothing was delivered
    const outside = chunksOutside(before, this.shape);
    if (countOf(outside) > this.delivered.size) {
      for (const [name, { key }] of this.delivered) {
        if (this.shape?.covers(key)) continue;
        this.delivered.delete(name);
        left.push(key);
      }
    } else {
      forEachChunk(outside, (key) => {
        if (this.delivered.delete(keyName(key))) left.push(key);
      });
    }
    return left;
  }

  /** All chunks leave. */
  forget(): ChunkKey[] {
    const left = [...this.delivered.values()].map(({ key }) => key);
    this.delivered.clear();
    return left;
  }

  /** Revisions of another store are not comparable with the held ones. What is as generated is so with any store. */
  forgetRevisions(): void {
    for (const [name, chunk] of this.delivered) if (chunk.revision !== 0n) this.delivered.set(name, { ...chunk, revision: -1n });
  }

  /** The chunks with edits of another store. */
  outdated(): ChunkKey[] {
    return [...this.delivered.values()].filter(({ revision }) => revision < 0n).map(({ key }) => key);
  }

  /** True if the chunk must be delivered: it is in the View, and new or newer. */
  deliver(chunk: Chunk): boolean {
    if (!this.shape?.covers(chunk.key)) return false;
    const name = keyName(chunk.key);
    const before = this.delivered.get(name);
    const { key, revision, hash, material } = chunk;
    if (before !== undefined) {
      if (before.revision > revision) return false;
      const same = hash !== null && before.hash !== null ? hash === before.hash : sameUniform(material, before.material);
      this.delivered.set(name, { key, revision, hash: hash ?? (same ? before.hash : null), material });
      if (same) return false;
    } else {
      this.delivered.set(name, { key, revision, hash, material });
    }
    return true;
  }

  has(key: ChunkKey): boolean {
    return this.delivered.has(keyName(key));
  }

  /** True unless it is missing, or outdated(). */
  hasCurrent(key: ChunkKey): boolean {
    return (this.find(key)?.revision ?? -1n) >= 0n;
  }

  find(key: ChunkKey): DeliveredChunk | undefined {
    return this.delivered.get(keyName(key));
  }

  /** The chunk that the application holds is also current at a newer revision. */
  confirm(held: DeliveredChunk, revision: bigint): void {
    this.delivered.set(keyName(held.key), { ...held, revision });
  }

  isWhole(): boolean {
    return this.delivered.size === (this.shape?.count ?? 0);
  }

  missing(): ChunkKey[] {
    const missing: ChunkKey[] = [];
    if (this.isWhole()) return missing;
    this.shape?.forEach((key) => {
      if (!this.has(key)) missing.push(key);
    });
    return missing;
  }
}

function sameUniform(a: number | null, b: number | null): boolean {
  return a !== null && a === b;
}
