// Appearance of land: client_sample/look.json, which talus-client's pictures use too.
import look from '../../../../../look.json';

type Amount = readonly [colour: string, times: number];

export interface LightKey {
  /** Sine of the sun's elevation. */
  readonly at: number;
  readonly sunLight: Amount;
  readonly skyLight: Amount;
  readonly zenith: Amount;
  readonly horizon: Amount;
  readonly glow: Amount;
  readonly exposure: number;
}

export const LIGHT_KEYS = look.light as unknown as readonly LightKey[];

/** By a material's name, in lower case. */
export const WORDS: readonly (readonly [words: RegExp, look: string])[] = look.looks.map(([words, name]) => [new RegExp(words!), name!]);

export interface Tint {
  readonly grey: number;
  readonly times: readonly number[];
}

export const TINTS: ReadonlyMap<string, Tint> = new Map(look.tints.map(({ look: name, grey, times }) => [name, { grey, times }]));
