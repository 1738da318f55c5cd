// Edited columns of chunks: PROTOCOL.md, "Edited land". Input is not trusted.
import { broken } from '../wire/table.js';
import type { Got } from './get.js';
import type { Tile } from './tiles.js';

const REGION = 32; // columns along each side
export const MAX_REGION_BYTES = 4 + 10 * REGION * REGION;

/** 32 x 32 columns of a level; x and z count regions. */
export interface Region {
  readonly lod: number;
  readonly x: number;
  readonly z: number;
}

export function regionOf(lod: number, x: number, z: number): Region {
  return { lod, x: Math.floor(x / REGION), z: Math.floor(z / REGION) };
}

export function regionName({ lod, x, z }: Region): string {
  return `${lod}/${x}/${z}`;
}

/** Revisions of the edited columns of a region. */
export class EditedColumns {
  static readonly none = new EditedColumns(new Map());
  private constructor(private readonly revisions: ReadonlyMap<number, bigint>) {}

  static read(body: Uint8Array): EditedColumns {
    const data = new DataView(body.buffer, body.byteOffset, body.byteLength);
    if (body.length < 4 || body[0] !== 1 || body[1] !== 0) throw broken('no edited columns of version 1');
    const count = data.getUint16(2, true);
    if (body.length !== 4 + 10 * count) throw broken(`${count} edited columns in ${body.length} bytes`);
    const revisions = new Map<number, bigint>();
    let before = -1;
    for (let at = 4; at < body.length; at += 10) {
      const place = data.getUint16(at, true);
      if (place <= before || place >= REGION * REGION) throw broken(`an edited column ${place} after ${before}`);
      revisions.set(place, data.getBigUint64(at + 2, true));
      before = place;
    }
    return new EditedColumns(revisions);
  }

  /** Revision of column (x, z), which must be in the region; 0n: never edited. */
  revision(x: number, z: number): bigint {
    return this.revisions.get((z & (REGION - 1)) * REGION + (x & (REGION - 1))) ?? 0n;
  }
}

/** The greatest revision of a square's columns, which lie in one region. */
export function revisionOf(tile: Tile, edited: EditedColumns): bigint {
  let greatest = 0n;
  for (let z = tile.z; z < tile.z + tile.n; ++z) {
    for (let x = tile.x; x < tile.x + tile.n; ++x) {
      const revision = edited.revision(x, z);
      if (revision > greatest) greatest = revision;
    }
  }
  return greatest;
}

/** Revision of an answer: its header; else its path, as a redirect may lead to a newer one; else `asked`. */
export function revisionOfAnswer({ url, revision }: Pick<Got, 'url' | 'revision'>, asked: bigint): bigint {
  if (revision === null) return revisionOfPath(url, asked);
  if (!/^[0-9]{1,20}$/.test(revision)) throw broken(`a revision ${revision.slice(0, 40)}`);
  return BigInt(revision);
}

/** The revision in a path; otherwise `asked`. */
export function revisionOfPath(url: string, asked: bigint): bigint {
  const mark = /@([0-9]{1,20})$/.exec(url);
  return mark === null ? asked : BigInt(mark[1]!);
}
