// Liquid: reflection and transmission; shaders/terrain.ts colours the bed.
import { GROUND, NOISE, OUTPUT, PRECISION, SHADOW, SKY } from './common.js';
import { QUAD } from './quads.js';
import { SURFACE_BELOW_TOP } from '../waterline.js';

export const waterVertex = /* glsl */ `${PRECISION}${QUAD}
out vec3 ray;
flat out vec3 normal;
flat out float scale;
flat out uint material;

void main() {
  Corner c = unpackCorner(0.0);         // what is seen through must not overlap
  ray = c.position;
  // The surface lies a little below its voxel's top, at every level of detail alike.
  if (c.normal.y > 0.5) ray.y -= ${SURFACE_BELOW_TOP};
  normal = c.normal;
  scale = c.scale;
  material = c.material;
  gl_Position = viewProjection * vec4(ray, 1.0);
}
`;

export const waterFragment = /* glsl */ `${PRECISION}${NOISE}${SKY}${OUTPUT}${GROUND}${SHADOW}
uniform vec3 eye;
uniform sampler2D materials;
uniform vec4 slice;
uniform float time;

in vec3 ray;
flat in vec3 normal;
flat in float scale;
flat in uint material;
out vec4 result;

/** Slope of the waves, of three lengths that go their own ways. */
vec2 slopeOf(vec2 p, float distance) {
  vec2 slope = vec2(0.0);
  float t = time;
  vec2 drift = vec2(t * 1.1, t * 0.6);
  for (int i = 0; i < 3; i++) {
    float fine = 1.0 - smoothstep(60.0, 500.0, distance * (i == 0 ? 1.0 : i == 1 ? 0.4 : 0.12));
    int k = i == 0 ? 1 : i == 1 ? 3 : 5;
    float size = float(1 << k);
    vec2 q = p + drift * (i == 1 ? -0.8 : 1.0) * (1.0 + float(i));
    float e = size * 0.2;
    float here = noise(q, k);
    slope += vec2(noise(q + vec2(e, 0.0), k) - here, noise(q + vec2(0.0, e), k) - here) * fine * (i == 0 ? 0.16 : i == 1 ? 0.2 : 0.16);
  }
  return slope;
}

/** The surface from under water: the sky, bent by the waves, in a round window; beyond its rim it mirrors the water. */
vec3 fromBelow(vec3 p, vec2 waves, vec3 toEye, float distance) {
  float near = 1.0 - smoothstep(20.0, 90.0, distance);
  vec2 drift = vec2(4.2, 2.1) * time;
  vec2 a = p.xz * 4.0 + drift;
  vec2 b = p.xz * 4.0 - drift.yx;
  float ripple = noise(a, 3) + noise(b, 3) - 1.0;
  vec2 ripples = vec2(noise(a + 1.5, 3) - noise(a - 1.5, 3), noise(b + 1.5, 3) - noise(b - 1.5, 3));
  // Steeper than seen from above, where the sky hides how flat they are.
  vec2 slope = waves * 3.0 + ripples * 0.16 * near;
  vec3 n = normalize(vec3(slope.x, -1.0, slope.y));
  float facing = max(dot(n, toEye), 0.0);
  float window = smoothstep(0.63, 0.75, facing);
  // Light that the waves gather: bright threads, as on the bed.
  float threads = pow(1.0 - min(abs(ripple) * 1.1, 1.0), 5.0) * (0.25 + 0.75 * near);
  vec3 mirrored = waterColour(reflect(-toEye, n)) * (0.8 + 0.5 * ripple) + waterFog.rgb * threads * 0.9;
  vec3 through = refract(-toEye, n, 1.333);
  vec3 sky = vec3(0.0);
  if (window > 0.0 && through.y > 0.0) {
    vec2 at = p.xz + through.xz * (CLOUD_HEIGHT - p.y) / (through.y + 0.09);
    float cloud = smoothstep(0.58 - cloudCover * 0.25, 0.74 - cloudCover * 0.25, cloudNoise(at));
    float toSun = max(dot(through, sunDirection), 0.0);
    sky = mix(skyColour(through), sunLight * 0.3 + skyLight * 0.4, cloud * 0.8) * (0.85 + 0.3 * threads);
    sky += sunLight * (pow(toSun, 400.0) * 8.0 + pow(toSun, 24.0) * 0.5) * (1.0 - 0.8 * cloud);
  }
  // The rim gathers all of the horizon.
  return mix(mirrored, sky, window) + horizon * 0.35 * window * (1.0 - smoothstep(0.7, 0.8, facing));
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.5 * scale) discard;
  if (isBeyondHorizon(ray)) discard;
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  vec4 first = texelFetch(materials, ivec2(0, int(material)), 0);
  bool top = normal.y > 0.5;
  vec2 slope = top ? slopeOf(p.xz, distance) : vec2(0.0);
  if (waterFog.w > 0.5) {
    // Sides let the air behind them through.
    vec3 seen = top ? fromBelow(p, slope, toEye, distance) : waterColour(-toEye) * 1.2;
    result = vec4(display(throughAir(seen, ray, eye)), top ? 0.92 : 0.35);
    return;
  }
  vec3 n = top ? normalize(vec3(-slope.x, 1.0, -slope.y)) : normal;
  float facing = max(dot(n, toEye), 0.0);
  float mirror = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
  vec3 away = reflect(-toEye, n);
  away.y = abs(away.y);
  vec3 seen = skyColour(away);
  // Hills stand in the mirror: where the land rises that way, it is dark.
  int level = levelAt(p.xz);
  float hill = 0.0;
  float t = 14.0;
  for (int i = 0; i < 5; i++) {
    vec2 at = p.xz + away.xz * t;
    hill = max(hill, smoothstep(-2.0, 10.0, groundAt(at, levelAt(at)) - (p.y + away.y * t)));
    t *= 2.0;
  }
  seen = mix(seen, (skyLight * 0.10 + sunLight * 0.04) * vec3(0.55, 0.7, 0.4) + seen * 0.25, hill * 0.8);
  float lit = marched(p + vec3(0.0, 0.4, 0.0), 1.5, 0.5) * cloudShade(p);
  float depth = p.y - groundAt(p.xz, level);
  float thin = max(depth, 0.0);
  vec3 body = mix(first.rgb * vec3(0.35, 0.75, 0.8), vec3(0.012, 0.085, 0.11), 0.6) * (sunLight * 0.3 * lit + skyLight * 0.8);
  float murk = (1.0 - exp(-thin * 0.10)) * 0.55 + 0.06;
  // Glitter.
  vec3 halfway = normalize(toEye + sunDirection);
  float glint = pow(max(dot(n, halfway), 0.0), 340.0) * 7.0 + pow(max(dot(n, halfway), 0.0), 60.0) * 0.25;
  // A line of foam along the shore, that comes and goes.
  float swash = noise(p.xz * 2.0 + time * 0.9, 2) * 0.6 + noise(p.xz * 4.0 - time * 0.7, 1) * 0.4;
  float foam = (1.0 - smoothstep(0.0, 0.9, thin + (swash - 0.5) * 1.1)) * step(scale, 1.5) * (1.0 - smoothstep(60.0, 260.0, distance));
  foam *= smoothstep(0.35, 0.65, swash + 0.12);
  float alpha = 1.0 - (1.0 - mirror) * (1.0 - murk);
  vec3 colour = (seen * mirror + body * (1.0 - mirror) * murk) / alpha;
  colour += sunLight * glint * lit * mirror * 6.0;
  vec3 white = (sunLight * 0.7 * lit * max(sunDirection.y, 0.0) + skyLight) * 0.75;
  colour = mix(colour, white, foam * 0.7);
  alpha = max(alpha, foam * 0.7);
  alpha = mix(alpha, 1.0, smoothstep(0.3, 1.0, distance / horizonBlocks));
  result = vec4(display(throughAir(colour, ray, eye)), alpha);
}
`;
