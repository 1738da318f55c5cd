// What materials look like, told from their names and colours: the world says no more of them.
import { Color, DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';
import type { Material } from 'talus';

/** As in shaders/terrain.ts. */
export const LOOKS = { rock: 0, turf: 1, sand: 2, snow: 3, leaves: 4, wood: 5, ice: 6, ore: 7, rubble: 8, earth: 9 } as const;
export type Look = keyof typeof LOOKS;

const WORDS: [RegExp, Look][] = [
  [/leaves|needles|bush|hedge|foliage/, 'leaves'],
  [/wood|bark|log|trunk|timber|plank/, 'wood'],
  [/\bice\b|glacier/, 'ice'],
  [/snow|firn/, 'snow'],
  [/\bore\b|coal|copper|silver|gold|iron\b|crystal/, 'ore'],
  [/scree|gravel|shingle|pebble|rubble|cobble|talus/, 'rubble'],
  [/sandstone|limestone/, 'rock'],
  [/beach|desert$|\bsand\b|dune|sea floor/, 'sand'],
  [/grass|meadow|forest|jungle|taiga|tundra|savanna|moss|turf|heath|steppe|prairie|cactus/, 'turf'],
  [/soil|dirt|earth|clay|mud|peat|loam|humus/, 'earth'],
];

export function lookOf(material: Material): Look {
  const name = material.name.toLowerCase();
  for (const [words, look] of WORDS) if (words.test(name)) return look;
  return 'rock';
}

/** Two texels a material: its colour and look, and the colour beneath (earth under turf, rock around ore), and whether flowers
 *  grow there. */
export function materialTexture(materials: readonly Material[]): DataTexture {
  const data = new Float32Array(materials.length * 8);
  const colour = new Color();
  const earth = new Color(materials.find((m) => /soil|dirt|earth/.test(m.name))?.colour ?? 0x7a5b3e);
  const rock = new Color(materials.find((m) => m.phase === 'solid')?.colour ?? 0x767076);
  materials.forEach((material, i) => {
    const look = lookOf(material);
    colour.set(material.colour); // sRGB to linear
    const beneath = look === 'ore' ? rock : /cactus/.test(material.name) ? colour : earth;
    data.set([colour.r, colour.g, colour.b, LOOKS[look], beneath.r, beneath.g, beneath.b, /meadow|forest|grass|heath|taiga/.test(material.name) ? 1 : 0], i * 8);
  });
  const texture = new DataTexture(data, 2, materials.length, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
