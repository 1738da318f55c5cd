// Edits shown before the server's answer: overlaid on the received chunks, and removed when a chunk with the edit
// arrives, or when they are refused. No I/O.
import { encodeChunk } from 'talus';
import { decodeChunk } from '../stream/decode.js';

/** A chunk of level 0. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** A chunk as held by the land. */
export interface Content {
  readonly payload: Uint8Array | null;
  readonly material: number | null;
  /** The server's hash of the voxels; null: unknown. */
  readonly hash: string | null;
}

/** A base voxel and its new material. */
export interface VoxelChange extends Place {
  readonly material: number;
}

export interface Host {
  /** The held chunk; null: not loaded. */
  held(place: Place): Content | null;
  show(place: Place, content: Content): void;
}

type Layer = Map<number, number>; // for a chunk: voxel index -> material

/** One edit. */
export class Prediction {
  readonly layers = new Map<string, Layer>();
  /** Revision of the applied edit; null: not answered. */
  revision: bigint | null = null;
}

interface CoveredChunk {
  readonly place: Place;
  /** Revision of the chunk beneath; -1: unknown, as it arrived before. */
  revision: bigint;
  base: Content;
  voxels: Uint16Array; // voxels of `base`
  shown: Uint16Array;
  predictions: Prediction[];
}

const VOLUME = 32_768;
const nameOf = ({ x, y, z }: Place) => `${x}/${y}/${z}`;

function voxelsOf({ payload, material }: Content): Uint16Array {
  const decoded = material ?? decodeChunk(payload!);
  return typeof decoded === 'number' ? new Uint16Array(VOLUME).fill(decoded) : decoded;
}

const isSame = (a: Uint16Array, b: Uint16Array) => a.every((material, i) => material === b[i]);

export class Predictions {
  private readonly covered = new Map<string, CoveredChunk>();

  constructor(private readonly host: Host) {}

  /** Number of chunks that are shown differently from the received ones. */
  get size(): number {
    return this.covered.size;
  }

  /** Shows the changes, except in chunks that are not loaded. */
  begin(changes: readonly VoxelChange[]): Prediction {
    const prediction = new Prediction();
    const places = new Map<string, Place>();
    for (const { x, y, z, material } of changes) {
      const place = { x: Math.floor(x / 32), y: Math.floor(y / 32), z: Math.floor(z / 32) };
      const name = nameOf(place);
      let layer = prediction.layers.get(name);
      if (layer === undefined) {
        prediction.layers.set(name, (layer = new Map()));
        places.set(name, place);
      }
      layer.set(((y - place.y * 32) * 32 + z - place.z * 32) * 32 + x - place.x * 32, material);
    }
    for (const [name, place] of places) {
      const covered = this.cover(name, place);
      if (covered === null) {
        prediction.layers.delete(name);
        continue;
      }
      covered.predictions.push(prediction);
      this.refresh(name, covered);
    }
    return prediction;
  }

  /** The edit was applied, with or without changes; its chunks may have arrived, or are in flight. */
  settled(prediction: Prediction, revision: bigint, changed: boolean): void {
    prediction.revision = changed ? revision : 0n;
    this.eachOf(prediction, (covered) => {
      const layer = prediction.layers.get(nameOf(covered.place))!;
      const agrees = [...layer].every(([index, material]) => covered.voxels[index] === material);
      return agrees || (changed && covered.revision >= revision);
    });
  }

  /** The edit was not applied, or its outcome is unknown. */
  refused(prediction: Prediction): void {
    this.eachOf(prediction, () => true);
  }

  /** A chunk arrived; returns the content to show, or null if that is shown already. */
  arrived(place: Place, revision: bigint, content: Content): Content | null {
    const name = nameOf(place);
    const covered = this.covered.get(name);
    if (covered === undefined) return content;
    this.put(covered, revision, content);
    return this.compose(name, covered);
  }

  /** Chunks that still show an applied edit. Most arrive soon; a chunk that the edit did not change, as loose material
   *  slid into a dug hole, never does: request it after the answer, and pass it to resolved(). */
  behind(prediction: Prediction): Place[] {
    if (prediction.revision === null) return [];
    return [...this.covered.values()].filter(({ predictions }) => predictions.includes(prediction)).map(({ place }) => place);
  }

  /** A chunk's state on the server after the edit. */
  resolved(prediction: Prediction, place: Place, revision: bigint, content: Content): void {
    const name = nameOf(place);
    const covered = this.covered.get(name);
    if (covered === undefined) return;
    covered.predictions = covered.predictions.filter((each) => each !== prediction);
    if (revision >= covered.revision) this.put(covered, revision, content);
    this.refresh(name, covered);
  }

  /** A chunk was unloaded. */
  left(place: Place): void {
    this.covered.delete(nameOf(place));
  }

  clear(): void {
    this.covered.clear();
  }

  private cover(name: string, place: Place): CoveredChunk | null {
    const already = this.covered.get(name);
    if (already !== undefined) return already;
    const held = this.host.held(place);
    if (held === null) return null;
    const base = { payload: held.payload, material: held.material, hash: held.hash }; // `held` will show the prediction
    const voxels = voxelsOf(base);
    const covered: CoveredChunk = { place, revision: -1n, base, voxels, shown: voxels, predictions: [] };
    this.covered.set(name, covered);
    return covered;
  }

  private put(covered: CoveredChunk, revision: bigint, content: Content): void {
    covered.revision = revision;
    covered.base = content;
    covered.voxels = voxelsOf(content);
    covered.predictions = covered.predictions.filter((each) => each.revision === null || each.revision > revision);
  }

  /** Removes the prediction from those of its chunks for which `isOver` is true. */
  private eachOf(prediction: Prediction, isOver: (covered: CoveredChunk) => boolean): void {
    for (const name of prediction.layers.keys()) {
      const covered = this.covered.get(name);
      if (covered === undefined || !covered.predictions.includes(prediction) || !isOver(covered)) continue;
      covered.predictions = covered.predictions.filter((each) => each !== prediction);
      this.refresh(name, covered);
    }
  }

  private refresh(name: string, covered: CoveredChunk): void {
    const content = this.compose(name, covered);
    if (content !== null) this.host.show(covered.place, content);
  }

  /** null: the shown content is correct. */
  private compose(name: string, covered: CoveredChunk): Content | null {
    const { predictions, base, voxels } = covered;
    if (predictions.length === 0) this.covered.delete(name);
    let wanted = voxels;
    if (predictions.length > 0) {
      wanted = voxels.slice();
      for (const { layers } of predictions) for (const [index, material] of layers.get(name)!) wanted[index] = material;
    }
    const same = isSame(wanted, covered.shown);
    covered.shown = wanted;
    if (same) return null;
    if (predictions.length === 0) return base;
    return { payload: encodeChunk({ uniform: null, voxels: wanted as Uint16Array<ArrayBuffer> }), material: null, hash: null };
  }
}
