// Quads of all meshes on the GPU, in pages: textures of two words per texel, from which the vertex shader reads quads
// by index. One call draws a page, with any number of meshes (WEBGL_multi_draw).
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  Mesh,
  NearestFilter,
  RGIntegerFormat,
  UnsignedIntType,
  type RawShaderMaterial,
  type Texture,
  type WebGLRenderer,
} from 'three';
import { Ranges } from './ranges.js';

export const PAGE_WIDTH = 128;
const PAGE_ROWS = 2048;
const PAGE_QUADS = PAGE_WIDTH * PAGE_ROWS;
const PAGE_BYTES = PAGE_QUADS * 8;

/** Six indices per quad; the vertex shader derives quad and corner as index / 4 and index % 4. */
function makeIndex(): BufferAttribute {
  const index = new Uint32Array(PAGE_QUADS * 6);
  for (let quad = 0, i = 0; quad < PAGE_QUADS; quad++) {
    const first = quad * 4;
    index[i++] = first;
    index[i++] = first + 1;
    index[i++] = first + 2;
    index[i++] = first;
    index[i++] = first + 2;
    index[i++] = first + 3;
  }
  return new BufferAttribute(index, 1);
}

/** three draws an object that claims to be a BatchedMesh by the lists of starts and counts below. */
export class PageMesh extends Mesh {
  readonly isBatchedMesh = true;
  readonly _colorsTexture = null;
  readonly _multiDrawInstances = null;
  _multiDrawStarts = new Int32Array(1024);
  _multiDrawCounts = new Int32Array(1024);
  _multiDrawCount = 0;

  constructor(geometry: BufferGeometry, material: RawShaderMaterial) {
    super(geometry, material);
    this.frustumCulled = false;
    this.matrixAutoUpdate = false;
  }

  empty(): void {
    this._multiDrawCount = 0;
  }

  push(firstQuad: number, quads: number): void {
    const i = this._multiDrawCount;
    if (i > 0 && this._multiDrawStarts[i - 1]! / 24 + this._multiDrawCounts[i - 1]! / 6 === firstQuad) {
      this._multiDrawCounts[i - 1]! += quads * 6;
      return;
    }
    if (i === this._multiDrawStarts.length) {
      const starts = new Int32Array(i * 2);
      starts.set(this._multiDrawStarts);
      this._multiDrawStarts = starts;
      const counts = new Int32Array(i * 2);
      counts.set(this._multiDrawCounts);
      this._multiDrawCounts = counts;
    }
    this._multiDrawStarts[i] = firstQuad * 24;
    this._multiDrawCounts[i] = quads * 6;
    this._multiDrawCount = i + 1;
  }
}

export interface Page {
  readonly texture: DataTexture;
  readonly ranges: Ranges;
}

export interface Place {
  readonly page: number;
  readonly firstQuad: number;
  readonly rows: number;
}

export class Pages {
  readonly pages: Page[] = [];
  readonly geometry = new BufferGeometry();

  constructor(private readonly renderer: WebGLRenderer) {
    this.geometry.setIndex(makeIndex());
    this.addPage();
  }

  get bytes(): number {
    return this.pages.length * PAGE_BYTES + PAGE_QUADS * 24;
  }

  add(quads: Uint32Array): Place {
    const rows = Math.ceil(quads.length / 2 / PAGE_WIDTH);
    let page = 0;
    let first = -1;
    for (; page < this.pages.length; page++) {
      first = this.pages[page]!.ranges.take(rows);
      if (first >= 0) break;
    }
    if (first < 0) {
      page = this.pages.length;
      this.addPage();
      first = this.pages[page]!.ranges.take(rows);
    }
    this.upload(this.pages[page]!.texture, first, rows, quads);
    return { page, firstQuad: first * PAGE_WIDTH, rows };
  }

  remove(place: Place): void {
    this.pages[place.page]!.ranges.give(place.firstQuad / PAGE_WIDTH, place.rows);
  }

  dispose(): void {
    for (const page of this.pages) page.texture.dispose();
    this.geometry.dispose();
  }

  private addPage(): void {
    const texture = new DataTexture(null, PAGE_WIDTH, PAGE_ROWS, RGIntegerFormat, UnsignedIntType);
    texture.internalFormat = 'RG32UI';
    texture.minFilter = texture.magFilter = NearestFilter;
    texture.source.dataReady = false; // only allocates: parts are written as meshes arrive
    texture.needsUpdate = true;
    this.pages.push({ texture, ranges: new Ranges(PAGE_ROWS) });
  }

  private upload(texture: DataTexture, row: number, rows: number, quads: Uint32Array): void {
    const gl = bind(this.renderer, texture);
    const whole = Math.floor(quads.length / 2 / PAGE_WIDTH);
    const words = PAGE_WIDTH * 2;
    if (whole > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, PAGE_WIDTH, whole, gl.RG_INTEGER, gl.UNSIGNED_INT, quads, 0);
    const rest = quads.length / 2 - whole * PAGE_WIDTH;
    if (rows > whole) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row + whole, rest, 1, gl.RG_INTEGER, gl.UNSIGNED_INT, quads, whole * words);
  }
}

/** Binds the texture for texSubImage2D without three, which only uploads whole textures. */
export function bind(renderer: WebGLRenderer, texture: Texture, target = 0x0de1): WebGL2RenderingContext {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  renderer.initTexture(texture);
  const { __webglTexture: handle } = renderer.properties.get(texture) as { __webglTexture: WebGLTexture };
  renderer.state.activeTexture(gl.TEXTURE0);
  renderer.state.bindTexture(target, handle);
  // Through the renderer's record of the state, if it keeps one.
  const state = renderer.state as unknown as { pixelStorei?: (name: number, value: number | boolean) => void };
  const store = state.pixelStorei?.bind(state) ?? gl.pixelStorei.bind(gl);
  store(gl.UNPACK_FLIP_Y_WEBGL, false);
  store(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  store(gl.UNPACK_ALIGNMENT, 1);
  return gl;
}
