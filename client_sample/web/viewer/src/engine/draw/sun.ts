// The light of an hour: where sun and moon stand, and which colours light, sky and air have then.
import { Color, Matrix3, Matrix4, Vector3 } from 'three';

export interface Light {
  /** Of what casts shadows: the sun, or the moon. */
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

interface Key {
  /** Sine of the sun's height. */
  readonly at: number;
  readonly sunLight: number[];
  readonly skyLight: number[];
  readonly zenith: number[];
  readonly horizon: number[];
  readonly glow: number[];
  readonly exposure: number;
}

const rgb = (hex: number, times: number) => {
  const c = new Color(hex); // linear
  return [c.r * times, c.g * times, c.b * times];
};

// By the sun's height, from night to noon.
const KEYS: Key[] = [
  { at: -0.3, sunLight: rgb(0xa9c0ff, 0.34), skyLight: rgb(0x3a5090, 0.7), zenith: rgb(0x04081a, 1), horizon: rgb(0x0f1c38, 1), glow: rgb(0x000000, 0), exposure: 2.1 },
  { at: -0.14, sunLight: rgb(0xa9c0ff, 0.2), skyLight: rgb(0x7078a8, 1.25), zenith: rgb(0x0a1436, 1), horizon: rgb(0x2c3a68, 0.9), glow: rgb(0xa0483a, 0.45), exposure: 2.0 },
  { at: -0.03, sunLight: rgb(0xff8a4a, 0.1), skyLight: rgb(0x8088b8, 0.85), zenith: rgb(0x1c3070, 1), horizon: rgb(0x7d7090, 0.75), glow: rgb(0xff6e32, 1.35), exposure: 1.7 },
  { at: 0.06, sunLight: rgb(0xff9a52, 2.3), skyLight: rgb(0x8c98c8, 0.85), zenith: rgb(0x34589e, 1), horizon: rgb(0xcbaaa4, 0.82), glow: rgb(0xff8a3c, 1.3), exposure: 1.25 },
  { at: 0.22, sunLight: rgb(0xffc58a, 3.7), skyLight: rgb(0x9db0d4, 1.05), zenith: rgb(0x3a74c4, 1), horizon: rgb(0xe2d8d4, 1.05), glow: rgb(0xffb870, 0.7), exposure: 0.9 },
  { at: 0.5, sunLight: rgb(0xffe6c2, 4.3), skyLight: rgb(0xa2bade, 1.4), zenith: rgb(0x3b7dd6, 1.05), horizon: rgb(0xcfe2f2, 1.3), glow: rgb(0xffe2b8, 0.35), exposure: 0.75 },
  { at: 1, sunLight: rgb(0xfff2dc, 4.6), skyLight: rgb(0xa2bade, 1.55), zenith: rgb(0x3879d6, 1.1), horizon: rgb(0xc6def4, 1.45), glow: rgb(0xfff0d8, 0.25), exposure: 0.69 },
];

const mixed = (a: number[], b: number[], f: number) => new Vector3(...a.map((v, i) => v + (b[i]! - v) * f));
const smooth = (low: number, high: number, x: number) => {
  const t = Math.min(Math.max((x - low) / (high - low), 0), 1);
  return t * t * (3 - 2 * t);
};

/** Of an hour, 0 to 24. The sun rises in the east at 6 and passes south of the zenith. */
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
  // At dusk the sun hands its shadows to the moon while neither gives much light.
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
