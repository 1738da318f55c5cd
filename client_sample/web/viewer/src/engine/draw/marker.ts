// A box that shows what an edit would change: edges and a coloured veil.
import { BufferAttribute, BufferGeometry, Color, GLSL3, Mesh, NoColorSpace, RawShaderMaterial, Scene, Vector3, type Camera, type IUniform, type WebGLRenderer } from 'three';
import type { Marker, Vector } from '../api.js';

const vertexShader = /* glsl */ `
precision highp float;
uniform mat4 viewProjection;
uniform vec3 low;
uniform vec3 size;
uniform float thickness;
in vec3 corner;
in vec3 offset;
void main() {
  // A little outside of the voxels' faces, so that both do not fight for the same pixels.
  vec3 outward = (corner * 2.0 - 1.0) * 0.004;
  gl_Position = viewProjection * vec4(low + corner * size + outward + offset * thickness, 1.0);
}
`;
const fragmentShader = /* glsl */ `
precision highp float;
uniform vec4 colour;
out vec4 result;
void main() { result = colour; }
`;

const cornersOf = (i: number) => [i & 1, (i >> 1) & 1, (i >> 2) & 1] as const;
const SIDES = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];

function geometryOf(corners: number[], offsets: number[], indices: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners.length), 3)); // three requires one
  geometry.setAttribute('corner', new BufferAttribute(new Float32Array(corners), 3));
  geometry.setAttribute('offset', new BufferAttribute(new Float32Array(offsets), 3));
  geometry.setIndex(indices);
  return geometry;
}

function veil(): BufferGeometry {
  const corners = Array.from({ length: 8 }, (_, i) => cornersOf(i)).flat();
  return geometryOf(corners, new Array<number>(24).fill(0), SIDES);
}

/** Twelve bars. */
function edges(): BufferGeometry {
  const [corners, offsets, indices]: [number[], number[], number[]] = [[], [], []];
  for (let axis = 0; axis < 3; axis++) {
    for (let edge = 0; edge < 4; edge++) {
      const first = corners.length / 3;
      for (let i = 0; i < 8; i++) {
        const [x, y, z] = cornersOf(i);
        const at = [edge & 1, edge >> 1];
        const corner = [x, y, z].map((v, a) => (a === axis ? v : at[a === (axis + 1) % 3 ? 0 : 1]!));
        corners.push(...corner);
        offsets.push(2 * x - 1, 2 * y - 1, 2 * z - 1);
      }
      indices.push(...SIDES.map((i) => first + i));
    }
  }
  return geometryOf(corners, offsets, indices);
}

export class MarkerBox {
  private readonly scene = new Scene();
  private readonly box: Record<string, IUniform>;
  private readonly colours = [new Color(), new Color()];
  private readonly parts: Mesh<BufferGeometry, RawShaderMaterial>[];

  constructor(viewProjection: IUniform) {
    this.box = { viewProjection, low: { value: new Vector3() }, size: { value: new Vector3() }, thickness: { value: 0.01 } };
    this.parts = [veil(), edges()].map((geometry) => {
      const uniforms = { ...this.box, colour: { value: [1, 1, 1, 1] } };
      const material = new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, transparent: true, depthWrite: false });
      const mesh = new Mesh(geometry, material);
      mesh.frustumCulled = false;
      this.scene.add(mesh);
      return mesh;
    });
  }

  draw(renderer: WebGLRenderer, camera: Camera, marker: Marker, eye: Vector): void {
    const { first, last } = marker;
    const low = this.box.low!.value as Vector3;
    const size = this.box.size!.value as Vector3;
    low.set(first.x - eye.x, first.y - eye.y, first.z - eye.z);
    size.set(last.x + 1 - first.x, last.y + 1 - first.y, last.z + 1 - first.z);
    this.box.thickness!.value = 0.006 + 0.0014 * Math.hypot(low.x + size.x / 2, low.y + size.y / 2, low.z + size.z / 2);
    [marker.colour, marker.edge].forEach((hex, i) => {
      // In the page's colour space, not linear: nothing converts them afterwards.
      const { r, g, b } = this.colours[i]!.setHex(hex, NoColorSpace);
      this.parts[i]!.material.uniforms.colour!.value = [r, g, b, i === 0 ? marker.veil : 0.95];
    });
    renderer.render(this.scene, camera);
  }

  dispose(): void {
    for (const { geometry, material } of this.parts) {
      geometry.dispose();
      material.dispose();
    }
  }
}
