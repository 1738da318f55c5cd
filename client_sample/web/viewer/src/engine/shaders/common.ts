// GLSL shared by the engine's shaders. Positions are relative to the anchor, a point of the world near the camera whose
// coordinates are multiples of 4,096 blocks, so that single-precision floats suffice everywhere.

export const PRECISION = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;
precision highp sampler2DShadow;
`;

export const NOISE = /* glsl */ `
uniform ivec2 anchor;                 // x and z, modulo 2^30

uint mixed(uint h) {
  h ^= h >> 16; h *= 0x7feb352du; h ^= h >> 15; h *= 0x846ca68bu; h ^= h >> 16;
  return h;
}
float unit(uint h) { return float(h >> 8) * (1.0 / 16777216.0); }
float hash2(ivec2 p) { return unit(mixed(uint(p.x) * 0x9e3779b9u ^ mixed(uint(p.y)))); }
float hash3(ivec3 p) { return unit(mixed(uint(p.x) * 0x9e3779b9u ^ mixed(uint(p.y) * 0x85ebca6bu ^ mixed(uint(p.z))))); }

/** Value noise, 0 to 1, whose cells are 2^k blocks. */
float noise(vec2 p, int k) {
  vec2 q = p / float(1 << k);
  ivec2 cell = ivec2(floor(q)) + (anchor >> k);
  vec2 f = fract(q);
  f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  return mix(mix(hash2(cell), hash2(cell + ivec2(1, 0)), f.x), mix(hash2(cell + ivec2(0, 1)), hash2(cell + ivec2(1, 1)), f.x), f.y);
}
`;

export const SKY = /* glsl */ `
uniform vec3 sunDirection;            // of what lights the land: the sun, or the moon at night
uniform vec3 sunLight;
uniform vec3 skyLight;                // from above, on a level floor
uniform vec3 groundLight;             // from below
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 glow;                    // around the sun
uniform vec3 glowDirection;           // the sun's, at night too
uniform float horizonBlocks;
uniform float fogDensity;
uniform float mist;
uniform float seaLevel;               // relative to the anchor, as y always is
uniform vec4 waterFog;                // colour; w: 1 where the camera is under water
uniform float cloudCover;
uniform vec2 cloudShift;

/** The sky without sun, moon, stars and clouds: also what distance fades to. */
vec3 skyColour(vec3 direction) {
  float up = max(direction.y, 0.0);
  vec3 colour = mix(zenith, horizon, exp(-up * 4.5));
  colour = mix(colour, horizon * 1.08, exp(-up * 16.0) * 0.6);
  float toward = dot(direction, glowDirection);
  float low = exp(-up * 5.0);
  float wide = pow(max(toward * 0.5 + 0.5, 0.0), 6.0);
  float near = pow(max(toward, 0.0), 24.0);
  return colour + glow * (wide * low * 0.55 + near * 0.35 * (0.35 + low));
}

float cloudNoise(vec2 p) {
  p += cloudShift;
  return noise(p, 9) * 0.5 + noise(p + 311.0, 8) * 0.27 + noise(p - 97.0, 7) * 0.15;
}
const float CLOUD_HEIGHT = 620.0;

/** 0 to 1: how much of the sun's light clouds leave at a place. */
float cloudShade(vec3 p) {
  vec2 at = p.xz + sunDirection.xz / max(sunDirection.y, 0.18) * (CLOUD_HEIGHT - p.y);
  return 1.0 - 0.55 * smoothstep(0.56 - cloudCover * 0.25, 0.78 - cloudCover * 0.25, cloudNoise(at) + 0.04);
}

/** What water sends itself: bright from above and around the sun, dark from the deep. */
vec3 waterColour(vec3 direction) {
  float up = direction.y * 0.5 + 0.5;
  float toSun = max(dot(direction, sunDirection), 0.0);
  return waterFog.rgb * (mix(0.45, 1.7, up * up) + 0.5 * pow(toSun, 3.0) + 0.9 * pow(toSun, 24.0));
}

/** Chunks reach past the horizon, the coarser the farther. There all has the sky's colour, but would hide its clouds, sun and stars. */
bool isBeyondHorizon(vec3 ray) { return length(ray.xz) > horizonBlocks; }

/** What the air does to light on its way. */
vec3 throughAir(vec3 colour, vec3 ray, vec3 eye) {
  float distance = length(ray);
  vec3 direction = ray / max(distance, 0.001);
  if (waterFog.w > 0.5) return mix(waterColour(direction), colour * vec3(0.42, 0.76, 0.82), exp(-distance * vec3(0.075, 0.045, 0.04)));
  float far = distance / horizonBlocks;
  float thick = far * far * 2.8 * fogDensity;
  // Mist lies low: the integral of exp(-height / 40) along the ray.
  float from = max(eye.y - seaLevel, 0.0) / 40.0;
  float to = max(eye.y + ray.y - seaLevel, 0.0) / 40.0;
  float along = abs(to - from) < 0.01 ? exp(-from) : (exp(-from) - exp(-to)) / (to - from);
  thick += mist * distance * along;
  float edge = smoothstep(0.86, 1.0, length(ray.xz) / horizonBlocks);
  float kept = exp(-thick) * (1.0 - edge);
  return mix(skyColour(normalize(vec3(direction.x, max(direction.y, 0.0) + 0.012, direction.z))), colour, kept);
}
`;

export const OUTPUT = /* glsl */ `
uniform float exposure;
uniform float nightly;                // 0 by day, 1 at night: eyes see less colour

/** Filmic tone curve (after Hill's fit of the ACES reference), then sRGB. */
vec3 display(vec3 light) {
  light *= exposure;
  float grey = dot(light, vec3(0.2126, 0.7152, 0.0722));
  light = mix(light, vec3(grey) * vec3(0.78, 0.94, 1.24), nightly * 0.5);
  const mat3 toRrt = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 fromOdt = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = toRrt * light;
  v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  v = clamp(fromOdt * v, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), v));
}
`;

export const GROUND = /* glsl */ `
uniform sampler2DArray ground;        // by level: height of solid ground, of liquid, in voxels of the level
uniform vec2 viewCentre;              // of what the levels surround
uniform float level0Reach;            // blocks
uniform int levels;
uniform float groundBase;             // y of row 0

int levelAt(vec2 p) {
  vec2 d = abs(p - viewCentre);
  return clamp(int(ceil(log2(max(max(d.x, d.y), 1.0) / level0Reach))), 0, levels - 1);
}
vec3 groundPlace(vec2 p, int level) {
  float scale = float(1 << level);
  vec2 size = vec2(textureSize(ground, 0).xy);
  // Levels of up to 2^6 blocks a voxel: an anchor of multiples of 4,096 is whole in all of them.
  return vec3((p / scale + vec2((anchor >> level) & (ivec2(size) - 1))) / size, float(level));
}
/** Height of the ground at p, smooth. */
float groundAt(vec2 p, int level) {
  return texture(ground, groundPlace(p, level)).r * float(1 << level) + groundBase;
}
vec2 groundVoxel(vec2 p, int level) {
  ivec3 size = textureSize(ground, 0);
  ivec2 at = (ivec2(floor(p / float(1 << level))) + (anchor >> level)) & (size.xy - 1);
  return texelFetch(ground, ivec3(at, level), 0).rg * float(1 << level) + groundBase;
}
`;

export const SHADOW = /* glsl */ `
uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;            // from eye-relative to the map
uniform float shadowReach;            // blocks; 0: none
uniform int marchSteps;

/** By the heights of the land: soft, and as far as one sees. */
float marched(vec3 p, float from, float dither) {
  if (sunDirection.y <= 0.0) return 0.0;
  float lit = 1.0;
  float t = from * (0.85 + 0.3 * dither);
  float up = sunDirection.y / max(length(sunDirection.xz), 0.001);
  vec2 along = sunDirection.xz / max(length(sunDirection.xz), 0.001);
  for (int i = 0; i < marchSteps; i++) {
    vec2 at = p.xz + along * t;
    float over = p.y + up * t - groundAt(at, levelAt(at));
    lit = min(lit, 0.5 + over * 14.0 / (t + 24.0));
    if (lit <= 0.0 || up * t > 420.0) break;
    t *= 1.42;
  }
  return smoothstep(0.0, 1.0, lit);
}
`;
