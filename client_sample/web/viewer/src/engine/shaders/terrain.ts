// Solid ground: materials from noise, light from sun and sky, with occlusion by the land.
import { GROUND, NOISE, OUTPUT, PRECISION, SHADOW, SKY } from './common.js';
import { QUAD } from './quads.js';

export const terrainVertex = /* glsl */ `${PRECISION}${QUAD}
out vec3 ray;
out float occlusion;
flat out vec3 normal;
flat out uvec2 about;                 // material, and bit 0: cut, bit 1: top, bit 2: along x
flat out float scale;
uniform float pixel;                  // its angle

void main() {
  Corner c = unpackCorner(0.4 * pixel);
  ray = c.position;
  normal = c.normal;
  occlusion = c.occlusion / 3.0;
  scale = c.scale;
  about = uvec2(c.material, (c.cut ? 1u : 0u));
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`;

export const terrainFragment = /* glsl */ `${PRECISION}${NOISE}${SKY}${OUTPUT}${GROUND}${SHADOW}
uniform vec3 eye;
uniform sampler2D materials;          // two texels each: colour and kind; colour below, and whether flowers grow
uniform vec4 slice;                   // normal x, z, distance; w: 1 where there is one
uniform float time;
uniform float detail;                 // 0: far taps are left out
uniform float borders;
uniform vec3 selected;                // voxel, relative to the anchor; far away: none

in vec3 ray;
in float occlusion;
flat in vec3 normal;
flat in uvec2 about;
flat in float scale;
out vec4 result;

const int ROCK = 0, TURF = 1, SAND = 2, SNOW = 3, LEAVES = 4, WOOD = 5, ICE = 6, ORE = 7, RUBBLE = 8, EARTH = 9;

vec2 onFace(vec3 p) { return abs(normal.x) > 0.5 ? p.zy : abs(normal.y) > 0.5 ? p.xz : p.xy; }

/** How much of the sky is open above a place: the land's own heights around it, near and farther. */
float openness(vec3 p, vec3 n, int level, out vec2 slope) {
  vec3 q = p + n * 0.55 * scale;
  float y = q.y;
  float roof = groundAt(q.xz, level) - y;
  // Under a tree or a ledge some light comes from the sides; deep in a cave none does.
  float open = 1.0 - smoothstep(0.0, 1.6 * scale, roof) * mix(0.5, 1.0, smoothstep(5.0, 26.0, roof));
  float near = 0.0, far = 0.0;
  slope = vec2(0.0);
  float r1 = 2.2 * scale, r2 = 7.0 * scale;
  vec2 d = vec2(0.7071, 0.7071);
  for (int i = 0; i < 4; i++) {
    float beside = groundAt(q.xz + d * r1, level) - y;
    slope += d * beside;
    near += clamp(beside / (r1 * 2.2), 0.0, 1.0);
    if (detail > 0.5) far += clamp((groundAt(q.xz + vec2(d.x - d.y, d.x + d.y) * 0.7071 * r2, level) - y) / (r2 * 1.8), 0.0, 1.0);
    d = vec2(-d.y, d.x);
  }
  near *= 0.25;
  far *= 0.25;
  slope /= 2.0 * r1;
  if (abs(roof) > 4.0 * scale || length(slope) > 3.0) slope = vec2(0.0, 1e6);
  float around = 1.0 - (detail > 0.5 ? near * 0.5 + far * 0.5 : near);
  return around * (0.25 + 0.75 * open) * mix(1.0, 0.35, (1.0 - open) * near);
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.02 && (about.y & 1u) == 0u) {
    // A staircase of faces stands out beyond the plane by up to a voxel.
    if (dot(ray.xz, slice.xy) > slice.z + 0.75 * scale) discard;
  }
  if (isBeyondHorizon(ray)) discard;
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  bool top = normal.y > 0.5;
  bool side = abs(normal.y) < 0.5;
  bool cut = (about.y & 1u) == 1u;

  vec4 first = texelFetch(materials, ivec2(0, int(about.x)), 0);
  vec4 second = texelFetch(materials, ivec2(1, int(about.x)), 0);
  int kind = int(first.a + 0.5);
  vec3 albedo = first.rgb;

  // Where this is: the voxel, and of its column the heights of ground and water.
  vec3 inside = p - normal * 0.5 * scale;
  ivec3 voxel = ivec3(floor(inside / scale));
  ivec3 worldVoxel = voxel + ivec3(anchor.x, 0, anchor.y) / int(scale);
  int level = int(log2(scale) + 0.5);
  vec2 column = groundVoxel(inside.xz, level);
  float depth = column.x - p.y;

  // Large areas are not flat: broad, slow changes of tint; and each voxel is itself.
  float broad = noise(p.xz, 8) * 0.55 + noise(p.xz + 57.0, 6) * 0.45;
  float mid = noise(p.xz - 31.0, 4);
  float own = hash3(worldVoxel);
  float nearly = 1.0 - smoothstep(40.0, 160.0, distance / scale);
  float grainy = 1.0 - smoothstep(14.0, 60.0, distance);

  // Texels of 1/12 block, that fade before they flicker.
  vec2 uv = onFace(p);
  ivec2 texel = ivec2(floor(uv * 12.0));
  float speck = hash2(texel + worldVoxel.xz * 7 + worldVoxel.y * 131);
  float speck2 = hash2((texel >> 1) + worldVoxel.zx * 5 + worldVoxel.y * 57);
  vec2 cell = fract(uv / scale);

  float shine = 0.0;
  float through = 0.0;                // light that leaves let through
  float swing = 0.06;
  if (kind == TURF) {
    vec3 dry = mix(albedo, albedo * vec3(1.28, 1.06, 0.55), 0.65);
    vec3 lush = albedo * vec3(0.72, 0.92, 0.66);
    albedo = mix(albedo, dry, smoothstep(0.48, 0.85, broad) * 0.75);
    albedo = mix(albedo, lush, smoothstep(0.55, 0.2, broad) * 0.6);
    albedo *= 0.9 + 0.2 * mid;
    if (side && scale < 1.5) {
      // Earth under the turf, which hangs over its edge.
      float fringe = 0.22 + 0.2 * hash2(ivec2(texel.x, worldVoxel.y) + worldVoxel.xz * 3);
      float under = smoothstep(fringe - 0.02, fringe + 0.02, depth) * (0.35 + 0.65 * grainy + (1.0 - grainy) * 0.15);
      albedo = mix(albedo, second.rgb * (0.9 + 0.2 * own), clamp(under, 0.0, 1.0) * 0.85);
    }
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.26 + (speck2 - 0.5) * 0.16);
    // Here and there a flower, in drifts of one colour.
    float meadow = smoothstep(0.45, 0.75, mid) * second.a;
    if (top && scale < 1.5 && own > 1.0 - 0.26 * meadow) {
      ivec2 bloom = texel - ivec2(floor(vec2(hash2(worldVoxel.xz), hash2(worldVoxel.zx + 9)) * 9.0 + 1.0)) - ivec2(floor(uv)) * 12;
      if (all(greaterThanEqual(bloom, ivec2(0))) && all(lessThan(bloom, ivec2(2)))) {
        float colour = noise(p.xz + 211.0, 5);
        vec3 petals = colour < 0.4 ? vec3(0.85, 0.62, 0.06) : colour < 0.52 ? vec3(0.8, 0.8, 0.75) : colour < 0.62 ? vec3(0.55, 0.08, 0.06) : vec3(0.3, 0.2, 0.6);
        albedo = mix(albedo, petals, grainy);
      }
    }
    swing = 0.07;
    through = 0.06;
  } else if (kind == SAND) {
    float ripple = sin((p.x * 0.8 + p.z * 0.35 + mid * 9.0) * 2.6);
    albedo *= 0.93 + 0.12 * broad + 0.025 * ripple * grainy;
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.14;
    swing = 0.03;
  } else if (kind == SNOW) {
    albedo *= 0.92 + 0.08 * broad;
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.05;
    shine = 0.25 * step(0.985, speck) * grainy;
    swing = 0.02;
  } else if (kind == LEAVES) {
    float tree = hash2((worldVoxel.xz + 3) >> 3);
    albedo *= mix(vec3(0.78, 0.9, 0.7), vec3(1.3, 1.12, 0.8), tree * 0.6 + broad * 0.4);
    // Clumps of light and shade, and gaps that go deep.
    float gap = step(0.74, speck2) * grainy;
    albedo *= (0.86 + 0.3 * own) * (1.0 + grainy * (speck - 0.5) * 0.5) * (1.0 - 0.5 * gap);
    swing = 0.0;
    through = 0.35;
  } else if (kind == WOOD) {
    float bark = hash2(ivec2(texel.x, texel.y >> 2) + worldVoxel.y * 3);
    albedo *= side ? 1.0 + grainy * (bark - 0.5) * 0.55 : 1.0 + grainy * (speck - 0.5) * 0.2;
  } else if (kind == ICE) {
    albedo *= 0.92 + 0.14 * mid;
    albedo *= 1.0 + grainy * (speck2 - 0.5) * 0.08;
    shine = 0.5;
  } else if (kind == ORE) {
    vec3 host = second.rgb * (0.92 + 0.16 * own);
    float lump = step(0.52, hash2((texel / 3) + worldVoxel.xz * 5 + worldVoxel.y * 17));
    albedo = mix(host, albedo * (0.85 + 0.5 * speck), mix(0.62, lump, grainy));
    shine = 0.35 * lump * grainy;
  } else if (kind == RUBBLE) {
    float stone = hash2((texel / 3) + worldVoxel.xz * 5 + worldVoxel.y * 17);
    albedo *= 1.0 + grainy * ((stone - 0.5) * 0.4 + (speck - 0.5) * 0.12);
    albedo *= 0.9 + 0.2 * mid;
    swing = 0.12;
  } else if (kind == EARTH) {
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.22 + (speck2 - 0.5) * 0.16);
    albedo *= 0.92 + 0.16 * mid;
  } else {
    // Rock: beds a little uneven in tone, fine level lines on walls, weathered where the sky washes it.
    float bed = hash2(ivec2(worldVoxel.y, 7 + int(floor(mid * 3.0))));
    albedo *= 0.93 + 0.12 * bed + 0.1 * (broad - 0.5);
    if (side) albedo *= 1.0 + grainy * (hash2(ivec2(texel.x >> 3, texel.y) + worldVoxel.y) - 0.5) * 0.18;
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.14 + (speck2 - 0.5) * 0.12);
    swing = 0.08;
  }
  albedo *= 1.0 + (own - 0.5) * 2.0 * swing * mix(0.45, 1.0, nearly);

  // Edges of voxels catch the light a little, and the joint between them is a little dark.
  float border = min(min(cell.x, 1.0 - cell.x), min(cell.y, 1.0 - cell.y)) * scale;
  float crisp = 1.0 - smoothstep(6.0, 34.0, distance);
  albedo *= 1.0 - 0.16 * crisp * (1.0 - smoothstep(0.0, 0.035, border)) + 0.05 * crisp * (1.0 - smoothstep(0.035, 0.1, border));
  if (all(equal(voxel, ivec3(floor(selected)))) && scale < 1.5) {
    albedo = mix(albedo, vec3(1.0), border < 0.045 ? 0.85 : 0.12);
  }

  // Light.
  vec2 slope;
  float open = openness(p, normal, level, slope);
  if (cut) open = 1.0;
  if (kind == LEAVES) open = mix(open, 1.0, 0.4);
  // A trunk stands under its own crown, which heights take for a roof.
  if (kind == WOOD) open = mix(open, 1.0, 0.5);
  float corner = mix(0.42, 1.0, occlusion * (0.35 + 0.65 * occlusion));
  if (cut) corner = 1.0;
  // Faces of voxels stand in for a rough surface: far away its lean shows, not its steps.
  // By distance alone, as the corners too: by the size of voxels shade would jump where a coarser level begins.
  vec3 lean = slope.y > 1e5 ? normal : normalize(vec3(-slope.x, 1.0, -slope.y));
  float rough = smoothstep(24.0, 190.0, distance) * 0.85;
  vec3 shading = normalize(mix(normal, lean, rough));
  // A cut is a plane, although it is made of steps.
  if (cut) shading = normalize(vec3(slice.x, 0.55, slice.y));
  corner = mix(corner, 1.0, rough * 0.55);
  float facing = cut ? 0.5 : max(dot(shading, sunDirection), 0.0);
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) * 0.5 + 0.25;
  float lit = 0.0;
  if (facing > 0.0 || through > 0.0) {
    float mapped = 1.0;
    vec3 start = p + normal * 0.35 * scale + sunDirection * 0.2 * scale;
    vec3 inMap = (shadowMatrix * vec4(ray + normal * (0.06 + 0.05 * distance / 60.0), 1.0)).xyz;
    float near = shadowReach > 0.0 ? 1.0 - smoothstep(shadowReach * 0.8, shadowReach, length(ray)) : 0.0;
    if (near > 0.0 && all(lessThan(abs(inMap - 0.5), vec3(0.499)))) {
      vec2 texelSize = 1.0 / vec2(textureSize(shadowMap, 0));
      mapped = 0.0;
      for (int i = 0; i < 4; i++) {
        vec2 shift = vec2(float(i & 1), float(i >> 1)) - 0.5 + (dither - 0.5) * 0.4;
        mapped += texture(shadowMap, vec3(inMap.xy + shift * texelSize * 1.5, inMap.z));
      }
      mapped *= 0.25;
    } else {
      near = 0.0;
    }
    float far = near < 1.0 || shadowReach <= 0.0 ? marched(start, 1.4 * scale, dither) : marched(start, shadowReach * 0.5, dither);
    lit = cut ? 1.0 : near > 0.0 ? mix(far, min(mapped, far), near) : far;
    lit *= cloudShade(p);
  }
  vec3 sun = sunLight * lit * mix(facing, 0.5 + 0.5 * facing, through);
  if (through > 0.0) sun *= 1.0 + through * 0.8 * pow(max(dot(-toEye, sunDirection), 0.0), 3.0);
  float up = shading.y * 0.5 + 0.5;
  vec3 ambient = mix(groundLight, skyLight, up) * (open * 0.92 + 0.08);
  // A breath of light in caves, or one would see nothing at all.
  ambient += vec3(0.012, 0.013, 0.016);
  if (side && !cut) ambient *= abs(normal.x) > 0.5 ? 0.94 : 1.04;
  vec3 light = sun * mix(corner, 1.0, 0.6) + ambient * corner;
  vec3 colour = albedo * light;
  if (shine > 0.0) {
    vec3 halfway = normalize(toEye + sunDirection);
    colour += sunLight * lit * shine * pow(max(dot(normal, halfway), 0.0), 60.0);
  }

  // Under water: what is left of the light on its way down and up, and what the water sends itself.
  // A cut below a river is seen through no water.
  float under = cut ? 0.0 : column.y - p.y;
  if (under > 0.02 && waterFog.w < 0.5) {
    float path = under * (1.0 + 0.6 / max(toEye.y, 0.25));
    colour *= exp(-vec3(0.30, 0.085, 0.06) * min(path, 40.0));
    colour += vec3(0.012, 0.075, 0.095) * (1.0 - exp(-path * 0.11)) * (sunLight * 0.28 + skyLight * 0.75);
  }
  if (under > 0.02) {
    float w = time * 0.7;
    float wave = noise(p.xz * 8.0 + vec2(w * 9.0, w * 4.0), 3) + noise(p.xz * 8.0 - vec2(w * 5.0, w * 8.0), 3);
    colour *= 1.0 + 0.7 * pow(1.0 - abs(wave - 1.0), 8.0) * lit * exp(-under * 0.16) * (1.0 - smoothstep(40.0, 120.0, distance));
  }
  // Wet where water has just been.
  if (kind == SAND && top) {
    float wet = 1.0 - smoothstep(0.3, 1.5, abs(p.y - seaLevel));
    colour *= 1.0 - 0.16 * wet;
  }
  colour = throughAir(colour, ray, eye);
  if (borders > 0.5) {
    vec2 within = fract(onFace(p - vec3(0.0, groundBase, 0.0)) / (32.0 * scale));
    float line = min(min(within.x, 1.0 - within.x), min(within.y, 1.0 - within.y)) * 32.0 * scale;
    vec3 tint = level == 0 ? vec3(1.0, 0.8, 0.2) : level == 1 ? vec3(0.2, 0.9, 1.0) : level == 2 ? vec3(1.0, 0.35, 0.8) : vec3(0.5, 1.0, 0.4);
    colour = mix(colour, tint, 0.8 * (1.0 - smoothstep(0.5, 1.0, line / max(0.06, distance * 0.0016))));
  }
  result = vec4(display(colour), 1.0);
}
`;

/** Only depth, as the sun sees it. */
export const shadowVertex = /* glsl */ `${PRECISION}${QUAD}
void main() {
  Corner c = unpackCorner(0.0);
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`;
export const shadowFragment = /* glsl */ `${PRECISION}
void main() {}
`;
