// Changed voxels of a chunk and their materials: core/edits/FORMAT.md, "Runs".
import { broken } from '../wire/table.js';

const VOLUME = 32_768;

/** Calls `visit` for runs of voxels, `first` to `end` - 1 of the chunk, by ascending index. Throws a TalusError if the
 *  bytes are invalid, or not the unique form of a set of voxels; runs visited before must then be dropped. */
export function readRuns(bytes: Uint8Array, visit: (first: number, end: number, material: number) => void): void {
  let next = 0;
  const number = (maxValue: number): number => {
    let value = 0;
    for (let shift = 0; shift < 35; shift += 7) {
      const byte = bytes[next++];
      if (byte === undefined) throw broken('runs of voxels that end too early');
      value += (byte & 0x7f) * 2 ** shift;
      if (byte >= 0x80) continue;
      if ((byte === 0 && shift > 0) || value > maxValue) break;
      return value;
    }
    throw broken('runs of voxels with a number that is past its range, or longer than need be');
  };
  const ids: number[] = [];
  for (let left = number(VOLUME); left > 0; --left) {
    const id = number(0xffff);
    if (ids.length > 0 && id <= ids.at(-1)!) throw broken('runs of voxels whose materials do not rise');
    ids.push(id);
  }
  const used = new Set<number>();
  let end = 0;
  let before = -1; // list index of the previous run's material
  for (let left = number(VOLUME); left > 0; --left) {
    const gap = number(VOLUME - 1);
    if (ids.length === 0) throw broken('runs of voxels without a material');
    const coded = number(VOLUME * ids.length - 1);
    const place = coded % ids.length;
    if (gap === 0 && place === before) throw broken('runs of voxels that are one run');
    const first = end + gap;
    end = first + Math.floor(coded / ids.length) + 1;
    if (end > VOLUME) throw broken("runs of voxels past the chunk's end");
    used.add(place);
    before = place;
    visit(first, end, ids[place]!);
  }
  if (used.size !== ids.length) throw broken('runs of voxels with a material of no run');
  if (next !== bytes.length) throw broken('runs of voxels with bytes after the last');
}
