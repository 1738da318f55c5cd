// The part of a vertex shader that unpacks a quad (mesh/quad.ts).
export const QUAD = /* glsl */ `
uniform usampler2D quads;
uniform sampler2D slots;              // of each mesh: origin relative to the anchor, and blocks a voxel
uniform vec3 eye;                     // relative to the anchor
uniform mat4 viewProjection;          // from eye-relative positions

struct Corner { vec3 position; vec3 normal; float occlusion; uint face; uint material; bool cut; float scale; };

Corner unpackCorner(float widen) {
  uint quad = uint(gl_VertexID) >> 2;
  uint corner = uint(gl_VertexID) & 3u;
  uvec2 word = texelFetch(quads, ivec2(int(quad & 127u), int(quad >> 7)), 0).xy;
  uint slot = word.y & 0xffffu;
  vec4 origin = texelFetch(slots, ivec2(int(slot & 255u), int(slot >> 8)), 0);

  Corner c;
  c.face = (word.x >> 15) & 7u;
  uint axis = c.face == 0u || c.face == 3u ? 0u : c.face == 2u || c.face == 5u ? 1u : 2u;
  bool positive = c.face >= 2u && c.face <= 4u;
  corner = (corner + ((word.x >> 28) & 1u)) & 3u;
  // Front faces are counter-clockwise from outside.
  if ((axis == 2u) != positive) corner = (4u - corner) & 3u;
  vec2 at = vec2(corner == 1u || corner == 2u ? 1.0 : 0.0, corner >= 2u ? 1.0 : 0.0);
  vec2 size = vec2(float((word.x >> 18) & 31u) + 1.0, float((word.x >> 23) & 31u) + 1.0);

  vec3 local = vec3(float(word.x & 31u), float((word.x >> 5) & 31u), float((word.x >> 10) & 31u));
  vec3 along = axis == 0u ? vec3(0.0, at.y * size.y, at.x * size.x)
             : axis == 1u ? vec3(at.x * size.x, 0.0, at.y * size.y)
                          : vec3(at.x * size.x, at.y * size.y, 0.0);
  vec3 out_ = axis == 0u ? vec3(1.0, 0.0, 0.0) : axis == 1u ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  c.normal = positive ? out_ : -out_;
  c.scale = origin.w;
  c.position = origin.xyz - eye + (local + along + (positive ? out_ : vec3(0.0))) * origin.w;
  // Edges that meet in a T leave pixels open between them: each quad is wider by a fraction of a pixel.
  vec2 apart = (at * 2.0 - 1.0) * length(c.position) * widen;
  c.position += axis == 0u ? vec3(0.0, apart.y, apart.x) : axis == 1u ? vec3(apart.x, 0.0, apart.y) : vec3(apart.x, apart.y, 0.0);
  c.occlusion = float((word.y >> (16u + 2u * corner)) & 3u);
  c.material = (word.y >> 24) | ((word.x >> 30) << 8);
  c.cut = ((word.x >> 29) & 1u) == 1u;
  return c;
}
`;
