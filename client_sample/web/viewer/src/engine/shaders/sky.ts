// The sky: gradient, sun, moon, stars and clouds.
import { NOISE, OUTPUT, PRECISION, SKY } from './common.js';

export const skyVertex = /* glsl */ `${PRECISION}
uniform mat4 inverseViewProjection;
out vec3 direction;
void main() {
  // One triangle over the whole picture, at the far end.
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 far = inverseViewProjection * vec4(at, 1.0, 1.0);
  direction = far.xyz / far.w;
  gl_Position = vec4(at, 1.0, 1.0);
}
`;

export const skyFragment = /* glsl */ `${PRECISION}${NOISE}${SKY}${OUTPUT}
uniform vec3 eye;
uniform vec3 moonDirection;
uniform float stars;
uniform mat3 starTurn;
uniform float sunDisc;
in vec3 direction;
out vec4 result;

vec3 starLight(vec3 d) {
  vec3 q = starTurn * d;
  // Cells on the faces of a cube.
  vec3 a = abs(q);
  vec2 uv = a.x > a.y && a.x > a.z ? q.yz / a.x : a.y > a.z ? q.xz / a.y : q.xy / a.z;
  int face = a.x > a.y && a.x > a.z ? (q.x > 0.0 ? 0 : 1) : a.y > a.z ? (q.y > 0.0 ? 2 : 3) : (q.z > 0.0 ? 4 : 5);
  vec2 at = uv * 70.0;
  ivec2 cell = ivec2(floor(at));
  float chance = hash3(ivec3(cell, face));
  vec2 where = vec2(hash3(ivec3(cell, face + 10)), hash3(ivec3(cell, face + 20))) * 0.7 + 0.15;
  float size = 0.03 + 0.05 * pow(hash3(ivec3(cell, face + 30)), 6.0);
  float spot = 1.0 - smoothstep(size * 0.4, size + 0.04, length(fract(at) - where));
  float warm = hash3(ivec3(cell, face + 40));
  vec3 band = vec3(0.5, 0.6, 1.0) * 0.02 * pow(1.0 - abs(dot(q, normalize(vec3(0.3, 0.5, 0.8)))), 6.0);
  return step(0.82, chance) * spot * mix(vec3(1.0, 0.85, 0.7), vec3(0.75, 0.85, 1.0), warm) * (0.25 + chance * chance) + band;
}

void main() {
  vec3 d = normalize(direction);
  vec3 colour = skyColour(d);
  if (d.y < 0.0) colour = mix(colour, horizon * 0.9, min(-d.y * 3.0, 1.0));
  float toSun = dot(d, glowDirection);
  colour += sunDisc * vec3(1.0, 0.86, 0.62) * (smoothstep(0.99955, 0.99975, toSun) * 22.0 + pow(max(toSun, 0.0), 900.0) * 2.0);
  float toMoon = dot(d, moonDirection);
  float disc = 0.0;                     // of the moon, which stars do not shine through
  if (stars > 0.0 && toMoon > 0.99) {
    vec3 right = normalize(cross(moonDirection, vec3(0.0, 0.0, 1.0)));
    vec3 upward = cross(right, moonDirection);
    vec2 m = vec2(dot(d, right), dot(d, upward)) / 0.028;
    disc = 1.0 - smoothstep(0.96, 1.02, length(m));
    float spots = noise(m * 3.0 + 40.0, 1) * 0.6 + noise(m * 7.0 + 90.0, 1) * 0.4;
    colour = mix(colour, vec3(0.95, 0.94, 0.88) * (0.55 + 0.45 * spots) * 1.3, disc * min(stars * 2.0, 1.0));
    colour += vec3(0.10, 0.12, 0.16) * stars * pow(max(toMoon, 0.0), 1200.0);
  }

  float clear = 1.0;                    // of clouds
  // Clouds on a plane high above: thick where noise is high, lit from the sun's side, lost in the distance.
  if (d.y > 0.015 && eye.y < CLOUD_HEIGHT) {
    // As of a dome, not a plane: or clouds far off would be drawn out to streaks.
    float reach = (CLOUD_HEIGHT - eye.y) / (d.y + 0.09);
    vec2 at = eye.xz + d.xz * reach;
    float fine = noise(at * 4.0 + cloudShift * 4.0, 8) * 0.09 + noise(at * 10.0 + cloudShift * 9.0, 8) * 0.06;
    float base = cloudNoise(at) + fine;
    float threshold = 0.58 - cloudCover * 0.25;
    float density = smoothstep(threshold, threshold + 0.16, base);
    float toward = cloudNoise(at + glowDirection.xz * 90.0 * sign(sunDirection.y)) + fine;
    float lit = clamp(0.75 + (base - toward) * 3.2 - (base - threshold) * 0.9, 0.0, 1.3);
    vec3 shade = horizon * 0.32 + zenith * 0.3 + skyLight * 0.18;
    float silver = pow(max(toSun, 0.0), 12.0) * (1.0 - density) * 1.6;
    vec3 cloud = mix(shade, sunLight * 0.42 + skyLight * 0.36, lit * 0.85) + glow * (0.22 * lit + silver);
    float thick = density * smoothstep(0.02, 0.16, d.y);
    colour = mix(colour, cloud, thick * 0.92);
    // A star is a point: what dims a bright sky little puts it out.
    clear = pow(1.0 - thick, 4.0);
  }
  if (stars > 0.0 && d.y > -0.02) colour += starLight(d) * stars * clear * (1.0 - disc) * smoothstep(-0.02, 0.25, d.y);
  if (waterFog.w > 0.5) colour = waterColour(d);
  // Less than a step of colour, so that gradients show no bands.
  float noisy = hash2(ivec2(gl_FragCoord.xy)) - 0.5;
  result = vec4(display(colour) + noisy / 255.0, 1.0);
}
`;
