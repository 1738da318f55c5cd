// Meshes of the land on the GPU, and their visibility to a camera.
import {
  DataTexture,
  FloatType,
  NearestFilter,
  RGBAFormat,
  RawShaderMaterial,
  Scene,
  type Matrix4,
  type WebGLRenderer,
} from 'three';
import type { ChunkMesh } from '../mesh/mesher.js';
import { GROUPS, SLOTS } from '../mesh/quad.js';
import type { Column, Drawable } from '../stream/column.js';
import type { Drawer } from '../stream/land.js';
import { sideOf } from '../stream/slice.js';
import type { SlicePlane } from '../stream/messages.js';
import { BOTTOM, COUNTS, FIRST_QUAD, MeshTable, PAGE, TOP } from './mesh_table.js';
import { PageMesh, Pages, bind, type Place } from './pages.js';

export interface TerrainMesh extends Drawable {
  readonly place: Place;
  readonly quads: number;
}

/** Columns, and for each its position: west end, north end, side. */
export interface ColumnList {
  readonly columns: readonly Column<TerrainMesh>[];
  readonly squares: Float64Array;
}

const SLOT_WIDTH = 256;
export const ANCHOR_STEP = 4096;

interface Slot {
  lod: number;
  x: number;
  y: number;
  z: number;
}

/** Planes of a frustum around the eye: 6 x (normal, distance). */
export function planesOf(matrix: Matrix4): Float64Array {
  const m = matrix.elements;
  const planes = new Float64Array(24);
  for (let i = 0; i < 6; i++) {
    const row = i >> 1;
    const sign = i & 1 ? -1 : 1;
    for (let k = 0; k < 4; k++) planes[i * 4 + k] = m[k * 4 + 3]! + sign * m[k * 4 + row]!;
  }
  return planes;
}

export class Terrain implements Drawer<TerrainMesh> {
  readonly solid = new Scene();
  readonly liquid = new Scene();
  readonly shadow = new Scene();
  readonly slots: DataTexture;
  anchor = { x: 0, y: 0, z: 0 };
  meshes = 0;
  quads = 0;
  /** Bounds of all chunks so far, in blocks of the world. */
  private lowest = Infinity;
  private highest = -Infinity;
  private readonly pages: Pages;
  private readonly slotData = new Float32Array(SLOTS * 4);
  private readonly staleSlotRows = new Set<number>();
  private readonly table = new MeshTable();
  private readonly used: (Slot | null)[] = [];
  private readonly freeSlots: number[] = [];
  private readonly sets: { solid: PageMesh; liquid: PageMesh; shadow: PageMesh }[] = [];

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly makeMaterial: (pass: 'solid' | 'liquid' | 'shadow') => RawShaderMaterial,
  ) {
    this.pages = new Pages(renderer);
    this.slots = new DataTexture(this.slotData, SLOT_WIDTH, SLOTS / SLOT_WIDTH, RGBAFormat, FloatType);
    this.slots.minFilter = this.slots.magFilter = NearestFilter;
    this.slots.needsUpdate = true;
    for (const scene of [this.solid, this.liquid, this.shadow]) scene.matrixWorldAutoUpdate = false;
    this.addPage();
  }

  get bytes(): number {
    return this.pages.bytes + SLOTS * 16;
  }

  takeSlot(lod: number, x: number, y: number, z: number): number {
    const slot = this.freeSlots.pop() ?? this.used.length;
    if (slot >= SLOTS) throw new Error('the view has more meshes than there are slots; make it smaller');
    this.used[slot] = { lod, x, y, z };
    this.writeSlot(slot);
    this.staleSlotRows.add(Math.floor(slot / SLOT_WIDTH));
    return slot;
  }

  /** Uploads to the GPU, before a mesh with a new slot is drawn. */
  uploadSlots(): void {
    if (this.staleSlotRows.size === 0) return;
    const gl = bind(this.renderer, this.slots);
    for (const row of this.staleSlotRows) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, SLOT_WIDTH, 1, gl.RGBA, gl.FLOAT, this.slotData, row * SLOT_WIDTH * 4);
    }
    this.staleSlotRows.clear();
  }

  freeSlot(slot: number): void {
    this.used[slot] = null;
    this.freeSlots.push(slot);
  }

  add(slot: number, mesh: ChunkMesh): TerrainMesh {
    const place = this.pages.add(mesh.quads);
    while (this.sets.length <= place.page) this.addPage();
    const { lod, y } = this.used[slot]!;
    const scale = 2 ** lod;
    const quads = mesh.quads.length / 2;
    this.meshes++;
    this.quads += quads;
    const [bottom, top] = [(y * 32 + mesh.low) * scale, (y * 32 + mesh.high + 1) * scale];
    this.lowest = Math.min(this.lowest, bottom);
    this.highest = Math.max(this.highest, top);
    this.table.set(slot, place, mesh, bottom, top);
    return { slot, place, quads, bottom, top };
  }

  remove(mesh: TerrainMesh): void {
    this.pages.remove(mesh.place);
    this.freeSlot(mesh.slot);
    this.meshes--;
    this.quads -= mesh.quads;
  }

  setAnchor(x: number, y: number, z: number): void {
    this.anchor = { x, y, z };
    for (let slot = 0; slot < this.used.length; slot++) if (this.used[slot]) this.writeSlot(slot);
    this.slots.needsUpdate = true;
  }

  /** Lists the columns' meshes that the camera at `eye` (blocks of the world) sees. */
  list({ columns, squares }: ColumnList, eye: { x: number; y: number; z: number }, matrix: Matrix4, slice: SlicePlane | null, hideBuried: boolean): void {
    for (const set of this.sets) {
      set.solid.empty();
      set.liquid.empty();
    }
    const planes = planesOf(matrix);
    const { values } = this.table;
    const [lowest, highest] = [this.lowest - eye.y, this.highest - eye.y];
    for (let i = 0; i < columns.length; i++) {
      const size = squares[3 * i + 2]!;
      const x = squares[3 * i]! - eye.x;
      const z = squares[3 * i + 1]! - eye.z;
      if (!isVisible(planes, x, lowest, z, size, highest)) continue; // mostly true, without reading the column
      const column = columns[i]!;
      if (slice !== null && sideOf(slice, column.x * size, column.z * size, size) === 'gone') continue;
      if (!isVisible(planes, x, column.bottom - eye.y, z, size, column.top - eye.y)) continue;
      // Caves deep below the land are invisible from far above it.
      const hides = hideBuried && column.ready && (column.lod > 0 || x * x + z * z > 25600);
      const buried = hides ? (column.lowest - 6) * 2 ** column.lod : -Infinity;
      for (const slot of column.slots) {
        const at = this.table.at(slot);
        const top = values[at + TOP]!;
        if (top < buried) continue;
        const low = values[at + BOTTOM]! - eye.y;
        const high = top - eye.y;
        if (!isVisible(planes, x, low, z, size, high)) continue;
        this.push(at, x, low, z, size, high, column.skirts);
      }
    }
  }

  /** Lists the shadow casters for the map of `matrix`. */
  listShadow(columns: Iterable<Column<TerrainMesh>>, eye: { x: number; y: number; z: number }, matrix: Matrix4, light: { x: number; z: number }, slice: SlicePlane | null): void {
    for (const set of this.sets) set.shadow.empty();
    const planes = planesOf(matrix);
    const { values } = this.table;
    for (const column of columns) {
      if (column.lod > 1) continue;
      const size = 32 * 2 ** column.lod;
      const x = column.x * size - eye.x;
      const z = column.z * size - eye.z;
      if (slice !== null && sideOf(slice, column.x * size, column.z * size, size) === 'gone') continue;
      if (!isVisible(planes, x, column.bottom - eye.y, z, size, column.top - eye.y)) continue;
      for (const slot of column.slots) {
        const at = this.table.at(slot);
        const [bottom, top] = [values[at + BOTTOM]!, values[at + TOP]!];
        if (column.ready && top < (column.lowest - 2) * 2 ** column.lod) continue;
        if (!isVisible(planes, x, bottom - eye.y, z, size, top - eye.y)) continue;
        // The faces towards the light suffice.
        const shadow = this.sets[values[at + PAGE]!]!.shadow;
        let first = values[at + FIRST_QUAD]!;
        for (let face = 0; face < 6; face++) {
          const seen = face === 0 ? light.x < 0 : face === 3 ? light.x > 0 : face === 1 ? light.z < 0 : face === 4 ? light.z > 0 : face === 2;
          const count = values[at + COUNTS + face]!;
          if (seen && count > 0) shadow.push(first, count);
          first += count;
        }
      }
    }
  }

  /** True if list() found anything. */
  get isListed(): boolean {
    return this.sets.some(({ solid, liquid }) => solid._multiDrawCount + liquid._multiDrawCount > 0);
  }

  dispose(): void {
    this.pages.dispose();
    this.slots.dispose();
    for (const { solid, liquid, shadow } of this.sets) for (const mesh of [solid, liquid, shadow]) (mesh.material as RawShaderMaterial).dispose();
  }

  /** `at`: position of the mesh's row in the table. */
  private push(at: number, x: number, low: number, z: number, size: number, high: number, skirts: number): void {
    const { values } = this.table;
    const set = this.sets[values[at + PAGE]!]!;
    let first = values[at + FIRST_QUAD]!;
    for (let group = 0; group < 10; group++) {
      const count = values[at + COUNTS + group]!;
      if (count > 0) {
        const face = group < 6 ? group : group - 6 < 2 ? group - 6 : group - 5; // skirts: west, north, east, south
        const seen =
          face === 0 ? x + size > 0 : face === 3 ? x < 0 : face === 1 ? z + size > 0 : face === 4 ? z < 0 : face === 2 ? low < 0 : high > 0;
        if (seen && (group < 6 || (skirts >> (group - 6)) & 1)) set.solid.push(first, count);
        first += count;
      }
    }
    const liquids = values[at + COUNTS + GROUPS]!;
    if (liquids > 0) set.liquid.push(first, liquids);
  }

  private addPage(): void {
    const page = this.sets.length;
    const make = (pass: 'solid' | 'liquid' | 'shadow', scene: Scene) => {
      const material = this.makeMaterial(pass);
      material.uniforms.quads = { value: this.pages.pages[page]!.texture };
      material.uniforms.slots = { value: this.slots };
      const mesh = new PageMesh(this.pages.geometry, material);
      scene.add(mesh);
      return mesh;
    };
    this.sets.push({ solid: make('solid', this.solid), liquid: make('liquid', this.liquid), shadow: make('shadow', this.shadow) });
  }

  private writeSlot(slot: number): void {
    const { lod, x, y, z } = this.used[slot]!;
    const scale = 2 ** lod;
    this.slotData[slot * 4] = x * 32 * scale - this.anchor.x;
    this.slotData[slot * 4 + 1] = y * 32 * scale - this.anchor.y;
    this.slotData[slot * 4 + 2] = z * 32 * scale - this.anchor.z;
    this.slotData[slot * 4 + 3] = scale;
  }
}

function isVisible(planes: Float64Array, x: number, low: number, z: number, size: number, high: number): boolean {
  for (let i = 0; i < 24; i += 4) {
    const a = planes[i]!;
    const b = planes[i + 1]!;
    const c = planes[i + 2]!;
    if (a * (a > 0 ? x + size : x) + b * (b > 0 ? high : low) + c * (c > 0 ? z + size : z) + planes[i + 3]! < 0) return false;
  }
  return true;
}
