// Squares of columns as generated, made here instead of fetched by HTTP, and some of their chunks compared.
import type { Tile } from '../http/tiles.js';
import { forEachColumn } from '../http/tiles.js';
import { keyName } from '../keys.js';
import type { Chunk, ChunkKey, ConnectOptions, World as Facts } from '../types.js';
import { uniformPayload } from '../uniform.js';
import type { Range, ViewShape } from '../view_shape.js';
import { sizeOf } from '../view_shape.js';
import { Proofs } from './proofs.js';
import { openPublished } from './published.js';
import type { World } from './world.js';

export interface MadeColumn {
  readonly x: number;
  readonly z: number;
  readonly rows: Range;
  readonly chunks: readonly Chunk[];
}

export interface TilesHost {
  /** Resolves with the server's chunk as generated. */
  compare(key: ChunkKey): Promise<Chunk>;
  failed(why: Error): void;
}

export class MadeTiles {
  private readonly proofs: Proofs;

  static async open(options: ConnectOptions, base: string, facts: Facts, host: TilesHost, signal: AbortSignal): Promise<MadeTiles> {
    return new MadeTiles(await openPublished(options, base, facts, signal), host);
  }

  private constructor(
    private readonly world: World,
    host: TilesHost,
  ) {
    this.proofs = new Proofs((key) => host.compare(key), (key) => host.failed(new Error(`chunk ${keyName(key)} differs from the server's`)));
    this.proofs.begin();
  }

  async make(tile: Tile, shape: ViewShape): Promise<readonly MadeColumn[]> {
    const { lod } = tile;
    const columns: { x: number; z: number; rows: Range }[] = [];
    forEachColumn(tile, (x, z) => {
      const rows = shape.rows(lod, x, z);
      if (sizeOf(rows) > 0) columns.push({ x, z, rows });
    });
    const { what, payloads } = await this.world.columns({ lod, columns: Int32Array.from(columns.flatMap(({ x, z, rows }) => [x, z, rows.first, rows.last])) });
    let i = 0;
    let at = 0;
    return columns.map(({ x, z, rows }) => {
      const chunks: Chunk[] = [];
      for (let y = rows.first; y <= rows.last; ++y) {
        const is = what[i++]!;
        const key = { lod, x, y, z };
        const payload = is < 0 ? payloads.slice(at, (at -= is)) : uniformPayload(is);
        if (is < 0) this.proofs.made(key, payload);
        chunks.push({ key, revision: 0n, hash: null, payload, material: is < 0 ? null : is });
      }
      return { x, z, rows, chunks };
    });
  }

  end(): void {
    this.world.close();
  }
}
