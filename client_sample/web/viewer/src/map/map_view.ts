// The map on a canvas: draws tiles and markers, pans and zooms by mouse, fingers and keys.
import {
  blocksPerTile, parentOf, pixelsPerBlock, scaleBar, toBlocks, toScreen, visibleTiles, zoomAbout, ZOOM,
  type Camera, type TileKey,
} from './projection'; // prettier-ignore
import type { TileStore } from './tile_store';

export interface Marker {
  readonly x: number;
  readonly z: number;
  /** Degrees: an arrow; null: a pin. */
  readonly yaw: number | null;
  readonly name: string;
}

export interface MapEvents {
  /** The pointer, or with keys the centre of the map, is over these base voxels. */
  hover: (x: number, z: number) => void;
  go: (x: number, z: number) => void;
  moved: (camera: Camera) => void;
}

const CLICK_SLACK = 5;
const KEY_PIXELS = 80;
/** Maximum difference in zoom of a tile that replaces a missing one. */
const COARSER = 6;

export class MapView {
  camera: Camera;
  #markers: readonly Marker[] = [];
  #isDrawn = true;
  readonly #pointers = new Map<number, { x: number; y: number }>();
  #strayed = 0;
  #byKeys = false;
  readonly #ends = new AbortController();
  readonly #watch: ResizeObserver;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly tiles: () => TileStore | null,
    camera: Camera,
    private readonly events: MapEvents,
  ) {
    this.camera = camera;
    this.#watch = new ResizeObserver(() => this.redraw());
    this.#watch.observe(canvas);
    this.#listen();
  }

  dispose(): void {
    this.#ends.abort();
    this.#watch.disconnect();
  }

  mark(markers: readonly Marker[]): void {
    this.#markers = markers;
    this.redraw();
  }

  look(camera: Camera): void {
    this.camera = camera;
    this.events.moved(camera);
    this.redraw();
  }

  zoomBy(by: number, px = this.#size.width / 2, py = this.#size.height / 2): void {
    this.look(zoomAbout(this.camera, this.#size, px, py, by));
  }

  redraw(): void {
    if (!this.#isDrawn) return;
    this.#isDrawn = false;
    requestAnimationFrame(() => {
      this.#isDrawn = true;
      if (!this.#ends.signal.aborted) this.#draw();
    });
  }

  get #size() {
    return { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
  }

  #listen(): void {
    const { canvas } = this;
    const options = { signal: this.#ends.signal };
    canvas.addEventListener('pointerdown', (event) => this.#down(event), options);
    canvas.addEventListener('pointermove', (event) => this.#move(event), options);
    canvas.addEventListener('pointerup', (event) => this.#up(event, true), options);
    canvas.addEventListener('pointercancel', (event) => this.#up(event, false), options);
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? event.deltaY * 30 : event.deltaY;
        this.zoomBy(Math.max(-1, Math.min(1, -lines / 240)), event.offsetX, event.offsetY);
      },
      { ...options, passive: false },
    );
    canvas.addEventListener('keydown', (event) => this.#key(event), options);
  }

  #down(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.#byKeys = false;
    this.canvas.setPointerCapture(event.pointerId);
    if (this.#pointers.size === 0) this.#strayed = 0;
    this.#pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  }

  #move(event: PointerEvent): void {
    const { offsetX: x, offsetY: y } = event;
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) {
      this.#byKeys = false;
      const at = toBlocks(this.camera, this.#size, x, y);
      return this.events.hover(at.x, at.z);
    }
    const other = [...this.#pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.#strayed += Math.hypot(x - before.x, y - before.y) + (other === undefined ? 0 : CLICK_SLACK);
    this.#pointers.set(event.pointerId, { x, y });
    if (this.#strayed <= CLICK_SLACK) return;
    const scale = pixelsPerBlock(this.camera.zoom);
    const share = other === undefined ? 1 : 0.5;
    let camera: Camera = {
      ...this.camera,
      x: this.camera.x - ((x - before.x) * share) / scale,
      z: this.camera.z - ((y - before.y) * share) / scale,
    };
    if (other !== undefined) {
      const wide = Math.hypot(x - other.x, y - other.y) / Math.max(1, Math.hypot(before.x - other.x, before.y - other.y));
      camera = zoomAbout(camera, this.#size, (x + other.x) / 2, (y + other.y) / 2, Math.log2(Math.max(0.2, wide)));
    }
    this.look(camera);
  }

  #up(event: PointerEvent, ended: boolean): void {
    if (!this.#pointers.delete(event.pointerId) || this.#pointers.size > 0) return;
    if (!ended || this.#strayed > CLICK_SLACK) return;
    const at = toBlocks(this.camera, this.#size, event.offsetX, event.offsetY);
    this.events.go(at.x, at.z);
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = (KEY_PIXELS * (event.shiftKey ? 4 : 1)) / pixelsPerBlock(this.camera.zoom);
    const pan: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }; // prettier-ignore
    const by = pan[event.key];
    if (by !== undefined) this.look({ ...this.camera, x: this.camera.x + by[0] * step, z: this.camera.z + by[1] * step });
    else if (event.key === '+' || event.key === '=') this.zoomBy(0.5);
    else if (event.key === '-') this.zoomBy(-0.5);
    else if (event.key === 'Enter') return this.events.go(this.camera.x, this.camera.z);
    else return;
    event.preventDefault();
    this.#byKeys = true;
    this.events.hover(this.camera.x, this.camera.z);
  }

  #draw(): void {
    const size = this.#size;
    const pixels = devicePixelRatio;
    const [width, height] = [Math.round(size.width * pixels), Math.round(size.height * pixels)];
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    const context = this.canvas.getContext('2d')!;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = '#1b2630';
    context.fillRect(0, 0, width, height);
    // Whole device pixels, so that no seams show between tiles.
    const edge = (x: number, z: number) => toScreen(this.camera, size, x, z).map((n) => Math.round(n * pixels)) as [number, number];
    const wanted = visibleTiles(this.camera, size, pixels);
    const store = this.tiles();
    if (store !== null) {
      context.imageSmoothingEnabled = this.camera.zoom < ZOOM.most - 3;
      context.imageSmoothingQuality = 'high';
      for (const tile of wanted) this.#drawTile(context, store, tile, edge);
      store.want(wanted);
    }
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    const at = this.#markers.map((marker) => ({ marker, place: toScreen(this.camera, size, marker.x, marker.z) }));
    for (const { marker, place } of at) this.#drawMarker(context, marker, ...place);
    // The last marker's name is the most important: names that would overlap it are hidden.
    const isCovered = (x: number, y: number, by: typeof at) =>
      by.some(({ place: [nx, ny] }) => Math.abs(nx - x) < 60 && Math.abs(ny - y) < 40);
    at.forEach(({ marker, place }, i) => {
      if (!isCovered(...place, at.slice(i + 1))) this.#drawName(context, marker, ...place);
    });
    if (this.#byKeys) this.#drawCross(context);
    this.#drawScale(context);
  }

  #drawTile(context: CanvasRenderingContext2D, store: TileStore, tile: TileKey, edge: (x: number, z: number) => [number, number]): void {
    const span = blocksPerTile(tile.zoom);
    const [left, top] = edge(tile.x * span, tile.z * span);
    const [right, bottom] = edge((tile.x + 1) * span, (tile.z + 1) * span);
    let from = tile;
    for (let coarser = 0; coarser <= COARSER && from.zoom >= 0; ++coarser, from = parentOf(from)) {
      const picture = store.get(from);
      if (picture === null) continue;
      const part = picture.width / 2 ** coarser;
      const [x, y] = [(tile.x - from.x * 2 ** coarser) * part, (tile.z - from.z * 2 ** coarser) * part];
      context.drawImage(picture, x, y, part, part, left, top, right - left, bottom - top);
      return;
    }
  }

  #drawMarker(context: CanvasRenderingContext2D, marker: Marker, x: number, y: number): void {
    context.save();
    context.translate(x, y);
    context.lineWidth = 2;
    context.strokeStyle = '#10161d';
    context.beginPath();
    if (marker.yaw === null) {
      context.fillStyle = '#f1f4f7';
      context.arc(0, -14, 7, Math.PI * 0.85, Math.PI * 0.15);
      context.lineTo(0, 0);
      context.closePath();
    } else {
      context.fillStyle = '#f0b765';
      context.rotate((marker.yaw * Math.PI) / 180);
      for (const [px, py] of [[0, -12], [8, 9], [0, 5], [-8, 9]] as const) context.lineTo(px, py); // prettier-ignore
      context.closePath();
    }
    context.fill();
    context.stroke();
    context.restore();
  }

  #drawName(context: CanvasRenderingContext2D, marker: Marker, x: number, y: number): void {
    context.font = '600 12px system-ui, sans-serif';
    context.textAlign = 'center';
    context.lineWidth = 3.5;
    context.strokeStyle = 'rgb(16 22 29 / 0.9)';
    context.fillStyle = '#f1f4f7';
    context.strokeText(marker.name, x, y + (marker.yaw === null ? 16 : 27));
    context.fillText(marker.name, x, y + (marker.yaw === null ? 16 : 27));
  }

  #drawCross(context: CanvasRenderingContext2D): void {
    const { width, height } = this.#size;
    for (const [colour, line] of [['#10161d', 4], ['#f1f4f7', 2]] as const) { // prettier-ignore
      context.strokeStyle = colour;
      context.lineWidth = line;
      context.beginPath();
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) { // prettier-ignore
        context.moveTo(width / 2 + dx * 5, height / 2 + dy * 5);
        context.lineTo(width / 2 + dx * 14, height / 2 + dy * 14);
      }
      context.stroke();
    }
  }

  #drawScale(context: CanvasRenderingContext2D): void {
    const { blocks, pixels } = scaleBar(this.camera.zoom, 130);
    const text = blocks >= 1000 ? `${blocks / 1000} km` : `${blocks} blocks`;
    const [x, y] = [16, this.#size.height - 22];
    for (const [colour, line] of [['rgb(16 22 29 / 0.85)', 5], ['#f1f4f7', 2]] as const) { // prettier-ignore
      context.strokeStyle = colour;
      context.lineWidth = line;
      context.beginPath();
      context.moveTo(x, y - 6);
      context.lineTo(x, y);
      context.lineTo(x + pixels, y);
      context.lineTo(x + pixels, y - 6);
      context.stroke();
    }
    context.textAlign = 'left';
    context.lineWidth = 3.5;
    context.strokeStyle = 'rgb(16 22 29 / 0.9)';
    context.fillStyle = '#f1f4f7';
    context.strokeText(text, x + 4, y - 9);
    context.fillText(text, x + 4, y - 9);
  }
}
