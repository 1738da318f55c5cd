// Appearance of materials, derived from their names and colours, which is all that the world provides.
import { Color, DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';
import type { Material } from 'talus';
import { TINTS, WORDS } from './look.js';

/** As in shaders/terrain.ts. */
export const LOOKS = { rock: 0, turf: 1, sand: 2, snow: 3, leaves: 4, wood: 5, ice: 6, ore: 7, rubble: 8, earth: 9 } as const;
export type Look = keyof typeof LOOKS;

export function lookOf(material: Material): Look {
  const name = material.name.toLowerCase();
  for (const [words, look] of WORDS) if (words.test(name)) return look as Look;
  return 'rock';
}

/** Converts a map's colour to the colour in sunlight; same as talus-client (cli/look.cpp). */
function tint(colour: Color, look: Look): void {
  const tint = TINTS.get(look);
  if (tint === undefined) return;
  const grey = colour.r * 0.32 + colour.g * 0.6 + colour.b * 0.08;
  const [red, green, blue] = tint.times as [number, number, number];
  colour.lerp(new Color().setRGB(grey, grey, grey), tint.grey);
  colour.setRGB(colour.r * red, colour.g * green, colour.b * blue);
}

/** Two texels per material: its colour and look, then the colour beneath (earth under turf, rock around ore) and
 *  whether flowers grow there. */
export function materialTexture(materials: readonly Material[]): DataTexture {
  const data = new Float32Array(materials.length * 8);
  const colour = new Color();
  const earth = new Color(materials.find((m) => /soil|dirt|earth/.test(m.name))?.colour ?? 0x7a5b3e);
  const rock = new Color(materials.find((m) => m.phase === 'solid')?.colour ?? 0x767076);
  materials.forEach((material, i) => {
    const look = lookOf(material);
    colour.set(material.colour); // sRGB to linear
    tint(colour, look);
    const beneath = look === 'ore' ? rock : /cactus/.test(material.name) ? colour : earth;
    data.set([colour.r, colour.g, colour.b, LOOKS[look], beneath.r, beneath.g, beneath.b, /meadow|forest|grass|heath|taiga/.test(material.name) ? 1 : 0], i * 8);
  });
  const texture = new DataTexture(data, 2, materials.length, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
