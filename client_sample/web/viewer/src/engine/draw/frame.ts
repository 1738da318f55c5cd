// Draws one picture: shadows, land, sky, water.
import {
  DataTexture,
  DepthTexture,
  DoubleSide,
  FrontSide,
  GLSL3,
  LessEqualCompare,
  LinearFilter,
  Matrix3,
  Matrix4,
  Mesh,
  BufferAttribute,
  BufferGeometry,
  PerspectiveCamera,
  RawShaderMaterial,
  Scene,
  UnsignedIntType,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderTarget,
  WebGLRenderer,
  type IUniform,
  type Object3D,
  type Texture,
} from 'three';
import type { Column } from '../stream/column.js';
import type { SlicePlane } from '../stream/messages.js';
import { skyFragment, skyVertex } from '../shaders/sky.js';
import { shadowFragment, shadowVertex, terrainFragment, terrainVertex } from '../shaders/terrain.js';
import { waterFragment, waterVertex } from '../shaders/water.js';
import { Ground } from './ground.js';
import type { Marker } from '../api.js';
import { MarkerBox } from './marker.js';
import { lightAt, type Light } from './sun.js';
import { ANCHOR_STEP, Terrain, type ColumnList, type TerrainMesh } from './terrain.js';

export interface Eye {
  x: number;
  y: number;
  z: number;
  yaw: number;
  pitch: number;
}

const FAR_AWAY = new Vector3(1e9, 1e9, 1e9);
// Near plane in blocks: the nearer, the less depth precision is left for distant land.
const NEAR = 0.12;
// A farther near plane would cut a hole into water close to the eye.
const NEAR_WATER = 0.03;

export class Frame {
  readonly renderer: WebGLRenderer;
  readonly terrain: Terrain;
  ground: Ground | null = null;
  light: Light = lightAt(10);
  triangles = 0;
  drawCalls = 0;
  private readonly camera = new PerspectiveCamera(70, 1, NEAR, 8000);
  private readonly viewProjection = new Matrix4();
  private readonly sky = new Scene();
  private readonly uniforms: Record<string, IUniform>;
  private readonly shadowUniforms: Record<string, IUniform>;
  private shadowTarget: WebGLRenderTarget | null = null;
  private readonly shadowCentre = new Vector3(Infinity, 0, 0);
  private readonly shadowDirection = new Vector3();
  private readonly shadowMatrix = new Matrix4();
  private shadowAt = -Infinity;
  private shadowStale = true;
  private shadowReach = 0;
  private readonly skyMaterial: RawShaderMaterial;
  private readonly marker: MarkerBox;
  private disposed = false;

  constructor(canvas: HTMLCanvasElement, quality: 'low' | 'high') {
    this.renderer = new WebGLRenderer({ canvas, antialias: quality === 'high', powerPreference: 'high-performance', stencil: false, alpha: false });
    this.renderer.autoClear = false;
    this.renderer.sortObjects = false;
    this.renderer.info.autoReset = false;
    this.renderer.debug.checkShaderErrors = false; // checking blocks; a failure is reported when the program is used
    this.uniforms = {
      eye: { value: new Vector3() },
      viewProjection: { value: this.viewProjection },
      pixel: { value: 0.001 },
      inverseViewProjection: { value: new Matrix4() },
      anchor: { value: new Vector2() },
      materials: { value: null },
      ground: { value: null },
      viewCentre: { value: new Vector2() },
      level0Reach: { value: 400 },
      levels: { value: 1 },
      groundBase: { value: 0 },
      shadowMap: { value: null },
      shadowMatrix: { value: new Matrix4() },
      shadowReach: { value: 0 },
      marchSteps: { value: 12 },
      slice: { value: new Vector4() },
      time: { value: 0 },
      detail: { value: 1 },
      borders: { value: 0 },
      selected: { value: FAR_AWAY.clone() },
      sunDirection: { value: new Vector3() },
      sunLight: { value: new Vector3() },
      skyLight: { value: new Vector3() },
      groundLight: { value: new Vector3() },
      zenith: { value: new Vector3() },
      horizon: { value: new Vector3() },
      glow: { value: new Vector3() },
      glowDirection: { value: new Vector3() },
      moonDirection: { value: new Vector3() },
      horizonBlocks: { value: 4096 },
      fogDensity: { value: 1 },
      mist: { value: 0 },
      seaLevel: { value: 0 },
      waterFog: { value: new Vector4() },
      cloudCover: { value: 0.5 },
      cloudShift: { value: new Vector2() },
      exposure: { value: 1 },
      nightly: { value: 0 },
      stars: { value: 0 },
      starTurn: { value: new Matrix3() },
      sunDisc: { value: 1 },
    };
    this.marker = new MarkerBox(this.uniforms.viewProjection!);
    this.shadowUniforms = { eye: { value: new Vector3() }, viewProjection: { value: new Matrix4() } };
    this.terrain = new Terrain(this.renderer, (pass) => this.makeMaterial(pass));
    this.skyMaterial = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: skyVertex, fragmentShader: skyFragment, uniforms: this.uniforms, depthWrite: false,
    });
    const triangle = new BufferGeometry();
    triangle.setAttribute('position', new BufferAttribute(new Float32Array(9), 3));
    const sky = new Mesh(triangle, this.skyMaterial);
    sky.frustumCulled = false;
    this.sky.add(sky);
    this.setQuality(quality);
    void this.warmUp();
  }

  /** Compiles the programs while the first chunks arrive, and queries their uniforms at once: during the first picture,
   *  the query would wait for everything submitted to the GPU before. */
  private async warmUp(): Promise<void> {
    const scenes = [this.terrain.solid, this.sky, this.terrain.liquid];
    const made = scenes.map((scene) => this.renderer.compileAsync(scene, this.camera));
    if (this.shadowReach > 0) {
      // For three, another render target is another program.
      this.renderer.setRenderTarget(this.shadowTarget);
      scenes.push(this.terrain.shadow);
      made.push(this.renderer.compileAsync(this.terrain.shadow, this.camera));
      this.renderer.setRenderTarget(null);
    }
    await Promise.all(made);
    if (this.disposed || this.renderer.getContext().isContextLost()) return;
    for (const scene of scenes) scene.traverse((object) => this.readProgram(object));
  }

  private readProgram(object: Object3D): void {
    const material = (object as Partial<Mesh>).material;
    if (material === undefined) return;
    const { currentProgram } = this.renderer.properties.get(material) as { currentProgram?: { getUniforms(): unknown } };
    currentProgram?.getUniforms();
  }

  get gpuBytes(): number {
    const shadow = this.shadowTarget === null ? 0 : this.shadowTarget.width ** 2 * 8;
    return this.terrain.bytes + (this.ground?.bytes ?? 0) + shadow;
  }

  setQuality(quality: 'low' | 'high'): void {
    this.set('detail', quality === 'high' ? 1 : 0);
    this.set('marchSteps', quality === 'high' ? 14 : 8);
    this.shadowTarget?.depthTexture?.dispose();
    this.shadowTarget?.dispose();
    this.shadowTarget = null;
    this.shadowReach = quality === 'high' ? 120 : 0;
    const size = quality === 'high' ? 2048 : 1;
    const depth = new DepthTexture(size, size, UnsignedIntType);
    depth.compareFunction = LessEqualCompare;
    depth.minFilter = depth.magFilter = LinearFilter;
    this.shadowTarget = new WebGLRenderTarget(size, size, { depthTexture: depth, depthBuffer: true, stencilBuffer: false });
    this.set('shadowMap', depth);
    this.set('shadowReach', this.shadowReach);
    this.shadowStale = true;
  }

  setMaterials(texture: DataTexture): void {
    (this.uniforms.materials!.value as Texture | null)?.dispose();
    this.set('materials', texture);
  }

  setGround(ground: Ground | null): void {
    this.ground?.dispose();
    this.ground = ground;
    this.set('ground', ground?.texture ?? null);
    this.set('levels', ground?.levels ?? 1);
  }

  setReach(centreX: number, centreZ: number, level0Reach: number, horizon: number): void {
    this.viewCentre.set(centreX, centreZ);
    this.set('level0Reach', level0Reach);
    this.set('horizonBlocks', horizon);
    this.camera.far = horizon * 1.6 + 1000;
    this.camera.updateProjectionMatrix();
  }
  private readonly viewCentre = new Vector2();

  setTimeOfDay(hours: number): void {
    this.light = lightAt(hours);
    this.shadowStale = true;
  }

  setBorders(on: boolean): void {
    this.set('borders', on ? 1 : 0);
  }

  setFov(degrees: number): void {
    this.camera.fov = degrees;
    this.camera.updateProjectionMatrix();
    this.measurePixel();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
    this.measurePixel();
  }

  private measurePixel(): void {
    this.set('pixel', (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / Math.max(this.renderer.domElement.height, 1));
  }

  /** Partially filled textures lost their contents; three refills the others. */
  contextRestored(): void {
    this.terrain.slots.needsUpdate = true;
    this.ground = null; // its texture was lost with the context
    this.shadowStale = true;
    this.shadowAt = -Infinity;
  }

  /** The drawn land changed. */
  landChanged(): void {
    this.shadowStale = true;
  }

  /** Returns true if it drew. */
  draw(options: {
    eye: Eye;
    columns: ColumnList;
    seconds: number;
    now: number;
    slice: SlicePlane | null;
    selected: { x: number; y: number; z: number } | null;
    marker: Marker | null;
    seaLevel: number | null;
    underWater: boolean;
    closeToWater: boolean;
    hideBuried: boolean;
    groundBase: number;
    /** Draws nothing if no land is in sight. */
    onlyWithLand: boolean;
  }): boolean {
    const { eye, columns, slice } = options;
    this.moveAnchor(eye);
    const anchor = this.terrain.anchor;
    const u = this.uniforms;
    const relative = u.eye!.value as Vector3;
    relative.set(eye.x - anchor.x, eye.y - anchor.y, eye.z - anchor.z);
    (u.anchor!.value as Vector2).set(anchor.x % 2 ** 30, anchor.z % 2 ** 30);
    (u.viewCentre!.value as Vector2).set(this.viewCentre.x - anchor.x, this.viewCentre.y - anchor.z);
    this.set('groundBase', options.groundBase - anchor.y);
    this.set('seaLevel', (options.seaLevel ?? -1e6) - anchor.y);
    this.set('time', options.seconds % 3600);
    (u.cloudShift!.value as Vector2).set((options.seconds * 2.2) % 131072, (options.seconds * 0.9) % 131072);
    (u.selected!.value as Vector3).copy(FAR_AWAY);
    if (options.selected) {
      const { x, y, z } = options.selected;
      (u.selected!.value as Vector3).set(x - anchor.x, y - anchor.y, z - anchor.z);
    }
    (u.slice!.value as Vector4).set(slice?.nx ?? 0, slice?.nz ?? 0, slice === null ? 0 : (slice.x - eye.x) * slice.nx + (slice.z - eye.z) * slice.nz, slice === null ? 0 : 1);
    this.applyLight(options.underWater);

    const near = options.closeToWater ? NEAR_WATER : NEAR;
    if (this.camera.near !== near) {
      this.camera.near = near;
      this.camera.updateProjectionMatrix();
    }
    this.camera.rotation.set(eye.pitch, -eye.yaw, 0, 'YXZ');
    this.camera.updateMatrixWorld(true);
    this.viewProjection.multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    (u.inverseViewProjection!.value as Matrix4).copy(this.viewProjection).invert();

    const { renderer, terrain } = this;
    terrain.list(columns, eye, this.viewProjection, slice, options.hideBuried);
    if (options.onlyWithLand && !terrain.isListed) return false;
    renderer.info.reset();
    terrain.uploadSlots();
    this.castShadows(eye, columns.columns, options.now, slice);
    renderer.setRenderTarget(null);
    renderer.clear(true, true, false);
    renderer.render(terrain.solid, this.camera);
    renderer.render(this.sky, this.camera);
    renderer.render(terrain.liquid, this.camera);
    if (options.marker !== null) this.marker.draw(renderer, this.camera, options.marker, eye);
    this.triangles = renderer.info.render.triangles;
    this.drawCalls = renderer.info.render.calls;
    return true;
  }

  dispose(): void {
    this.disposed = true;
    this.terrain.dispose();
    this.setGround(null);
    this.skyMaterial.dispose();
    this.marker.dispose();
    (this.uniforms.materials!.value as Texture | null)?.dispose();
    this.shadowTarget?.depthTexture?.dispose();
    this.shadowTarget?.dispose();
    this.renderer.dispose();
  }

  private set(name: string, value: unknown): void {
    this.uniforms[name]!.value = value;
  }

  private makeMaterial(pass: 'solid' | 'liquid' | 'shadow'): RawShaderMaterial {
    if (pass === 'shadow') {
      return new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader: shadowVertex, fragmentShader: shadowFragment, uniforms: { ...this.shadowUniforms },
        side: FrontSide, colorWrite: false, polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2,
      });
    }
    if (pass === 'liquid') {
      return new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader: waterVertex, fragmentShader: waterFragment, uniforms: { ...this.uniforms },
        side: DoubleSide, transparent: true, forceSinglePass: true,
      });
    }
    return new RawShaderMaterial({ glslVersion: GLSL3, vertexShader: terrainVertex, fragmentShader: terrainFragment, uniforms: { ...this.uniforms } });
  }

  private moveAnchor(eye: Eye): void {
    const anchor = this.terrain.anchor;
    const far = Math.max(Math.abs(eye.x - anchor.x), Math.abs(eye.z - anchor.z), Math.abs(eye.y - anchor.y));
    if (far <= ANCHOR_STEP) return;
    const snapped = (v: number) => Math.round(v / ANCHOR_STEP) * ANCHOR_STEP;
    this.terrain.setAnchor(snapped(eye.x), snapped(eye.y), snapped(eye.z));
  }

  private applyLight(underWater: boolean): void {
    const light = this.light;
    for (const name of ['sunLight', 'skyLight', 'groundLight', 'zenith', 'horizon', 'glow'] as const) (this.uniforms[name]!.value as Vector3).copy(light[name]);
    (this.uniforms.sunDirection!.value as Vector3).copy(light.direction);
    (this.uniforms.glowDirection!.value as Vector3).copy(light.sun);
    (this.uniforms.moonDirection!.value as Vector3).copy(light.moon);
    (this.uniforms.starTurn!.value as Matrix3).copy(light.starTurn);
    this.set('exposure', light.exposure);
    this.set('nightly', light.night);
    this.set('stars', light.stars);
    this.set('sunDisc', light.sun.y > -0.05 ? 1 : 0);
    this.set('mist', light.mist);
    const water = this.uniforms.waterFog!.value as Vector4;
    const bright = 0.52 * (light.sunLight.y * 0.3 + light.skyLight.y);
    water.set(0.05 * bright, 0.42 * bright, 0.5 * bright, underWater ? 1 : 0);
  }

  /** A map around the eye, in steps of its texels so that edges do not crawl; redrawn only if necessary. */
  private castShadows(eye: Eye, columns: Iterable<Column<TerrainMesh>>, now: number, slice: SlicePlane | null): void {
    const target = this.shadowTarget;
    if (target === null) return;
    if (this.shadowReach === 0) {
      // Nothing is drawn into it, but shaders need a depth texture.
      if (this.shadowStale) this.renderer.initRenderTarget(target);
      this.shadowStale = false;
      return;
    }
    const direction = this.light.direction;
    const moved = Math.hypot(eye.x - this.shadowCentre.x, eye.y - this.shadowCentre.y, eye.z - this.shadowCentre.z);
    const must = !(moved < 24) || direction.distanceToSquared(this.shadowDirection) > 1e-6;
    if (must || (this.shadowStale && now - this.shadowAt > 400)) {
      this.shadowStale = false;
      this.shadowAt = now;
      this.shadowDirection.copy(direction);
      this.shadowCentre.set(Math.floor(eye.x), Math.floor(eye.y), Math.floor(eye.z));
      const reach = this.shadowReach + 28;
      const view = new Matrix4().lookAt(direction, new Vector3(), new Vector3(0, 1, 0.001)).setPosition(0, 0, 0).invert();
      const depth = 420;
      const project = new Matrix4().makeOrthographic(-reach, reach, reach, -reach, -depth, depth);
      this.shadowMatrix.multiplyMatrices(project, view);
      const anchor = this.terrain.anchor;
      (this.shadowUniforms.eye!.value as Vector3).set(this.shadowCentre.x - anchor.x, this.shadowCentre.y - anchor.y, this.shadowCentre.z - anchor.z);
      (this.shadowUniforms.viewProjection!.value as Matrix4).copy(this.shadowMatrix);
      this.terrain.listShadow(columns, this.shadowCentre, this.shadowMatrix, direction, slice);
      this.renderer.setRenderTarget(target);
      this.renderer.clear(false, true, false);
      this.renderer.render(this.terrain.shadow, this.camera);
    }
    const toMap = new Matrix4().makeScale(0.5, 0.5, 0.5).setPosition(0.5, 0.5, 0.5).multiply(this.shadowMatrix);
    const shift = new Matrix4().makeTranslation(eye.x - this.shadowCentre.x, eye.y - this.shadowCentre.y, eye.z - this.shadowCentre.z);
    (this.uniforms.shadowMatrix!.value as Matrix4).multiplyMatrices(toMap, shift);
  }
}

