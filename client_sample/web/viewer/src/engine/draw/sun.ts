// Light at an hour: positions of sun and moon, and colours of light, sky and air.
import { Color, Matrix3, Matrix4, Vector3 } from 'three';
import { LIGHT_KEYS } from './look.js';

export interface Light {
  /** Direction to the light that casts shadows: the sun, or the moon. */
  readonly direction: Vector3;
  readonly sun: Vector3;
  readonly moon: Vector3;
  readonly sunLight: Vector3;
  readonly skyLight: Vector3;
  readonly groundLight: Vector3;
  readonly zenith: Vector3;
  readonly horizon: Vector3;
  readonly glow: Vector3;
  readonly exposure: number;
  readonly stars: number;
  readonly night: number;
  readonly mist: number;
  readonly starTurn: Matrix3;
}

const rgb = ([colour, times]: readonly [string, number]) => {
  const c = new Color(colour); // linear
  return [c.r * times, c.g * times, c.b * times];
};

const KEYS = LIGHT_KEYS.map(({ at, exposure, ...key }) => ({
  at,
  exposure,
  sunLight: rgb(key.sunLight),
  skyLight: rgb(key.skyLight),
  zenith: rgb(key.zenith),
  horizon: rgb(key.horizon),
  glow: rgb(key.glow),
}));

const mixed = (a: number[], b: number[], f: number) => new Vector3(...a.map((v, i) => v + (b[i]! - v) * f));
const smooth = (low: number, high: number, x: number) => {
  const t = Math.min(Math.max((x - low) / (high - low), 0), 1);
  return t * t * (3 - 2 * t);
};

/** Light at an hour, 0 to 24. The sun rises in the east at 6 and passes south of the zenith. */
export function lightAt(hours: number): Light {
  const angle = ((hours - 6) / 24) * 2 * Math.PI;
  const tilt = 0.55;
  const sun = new Vector3(Math.cos(angle), Math.sin(angle) * Math.cos(tilt), Math.sin(angle) * Math.sin(tilt)).normalize();
  const moon = new Vector3(-sun.x, -sun.y * 0.9, sun.z * 0.2 + 0.35).normalize();
  const height = sun.y;
  let i = 0;
  while (i < KEYS.length - 2 && height > KEYS[i + 1]!.at) i++;
  const a = KEYS[i]!;
  const b = KEYS[i + 1]!;
  const f = Math.min(Math.max((height - a.at) / (b.at - a.at), 0), 1);
  // At dusk the shadow-casting light changes from sun to moon while both are faint.
  const bySun = height > -0.05;
  const handover = bySun ? smooth(-0.05, 0.03, height) : smooth(-0.05, -0.16, height);
  const direction = bySun ? sun.clone() : moon.clone();
  direction.y = Math.max(direction.y, 0.035);
  direction.normalize();
  const sunLight = mixed(a.sunLight, b.sunLight, f).multiplyScalar(handover);
  const skyLight = mixed(a.skyLight, b.skyLight, f);
  const turn = new Matrix3().setFromMatrix4(new Matrix4().makeRotationAxis(new Vector3(0, Math.sin(0.7), Math.cos(0.7)).normalize(), -angle));
  return {
    direction,
    sun,
    moon,
    sunLight,
    skyLight,
    groundLight: skyLight.clone().multiply(new Vector3(0.42, 0.36, 0.28)).addScaledVector(new Vector3(sunLight.x * 0.075, sunLight.y * 0.065, sunLight.z * 0.045), Math.max(direction.y, 0) + 0.2),
    zenith: mixed(a.zenith, b.zenith, f),
    horizon: mixed(a.horizon, b.horizon, f),
    glow: mixed(a.glow, b.glow, f),
    exposure: a.exposure + (b.exposure - a.exposure) * f,
    stars: smooth(-0.1, -0.25, height),
    night: smooth(0.0, -0.18, height),
    mist: 0.0003 + 0.0016 * (1 - smooth(0.08, 0.4, Math.abs(height))),
    starTurn: turn,
  };
}
