// Known edits in the regions of the View.
import type { ViewShape } from '../view_shape.js';
import { EditedColumns, type Region, regionName, regionOf } from './edits.js';

interface KnownRegion {
  readonly region: Region;
  edited: EditedColumns | null; // null: not known yet
}

export class EditedRegions {
  private regions = new Map<string, KnownRegion>();

  clear(): void {
    this.regions.clear();
  }

  /** Follows the View's regions; forgets all others. */
  follow(shape: ViewShape | null): void {
    const before = this.regions;
    this.regions = new Map();
    shape?.forEachColumn((lod, x, z) => {
      const region = regionOf(lod, x, z);
      const name = regionName(region);
      if (!this.regions.has(name)) this.regions.set(name, before.get(name) ?? { region, edited: null });
    });
  }

  has(region: Region): boolean {
    return this.regions.has(regionName(region));
  }

  /** Stores the result; returns false if the region left the View. */
  take(region: Region, edited: EditedColumns): boolean {
    const known = this.regions.get(regionName(region));
    if (known !== undefined) known.edited = edited;
    return known !== undefined;
  }

  /** Edited columns of a column's region; null: not known yet. */
  of(lod: number, x: number, z: number): EditedColumns | null {
    return this.regions.get(regionName(regionOf(lod, x, z)))?.edited ?? null;
  }

  /** Regions except these names; with `unknown`, only those without a result. */
  others(names: ReadonlySet<string>, unknown = false): Region[] {
    const found: Region[] = [];
    for (const [name, { region, edited }] of this.regions) {
      if (!names.has(name) && !(unknown && edited !== null)) found.push(region);
    }
    return found;
  }
}
