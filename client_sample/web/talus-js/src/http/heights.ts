// /v1/heights: PROTOCOL.md, "Heights". Nothing of it is trusted.
import type { Places } from '../types.js';
import { broken } from '../wire/table.js';

function numbers(value: unknown, count: number, name: string): number[] {
  if (!Array.isArray(value) || value.length !== count || !value.every((each) => typeof each === 'number')) {
    throw broken(`heights whose ${name} are not ${count} numbers`);
  }
  return value as number[];
}

export function readHeights(
  body: Uint8Array,
  count: number,
  looks: boolean,
  fields: readonly string[],
  knownLooks: readonly string[],
): Places {
  let json: { heights?: unknown; looks?: unknown; fields?: Record<string, unknown> };
  try {
    json = JSON.parse(new TextDecoder().decode(body)) ?? {};
  } catch (error) {
    throw broken(`heights that are no JSON: ${(error as Error).message}`);
  }
  const heightsFx = Int32Array.from(numbers(json.heights, count, 'heights'));
  let places: Uint8Array | null = null;
  if (looks) {
    if (!Array.isArray(json.looks) || json.looks.length !== count) throw broken(`heights without ${count} looks`);
    places = Uint8Array.from(json.looks, (name) => {
      const look = knownLooks.indexOf(name);
      if (look < 0) throw broken('a look that the world does not list');
      return look;
    });
  }
  let values: Float32Array | null = null;
  if (fields.length > 0) {
    values = new Float32Array(count * fields.length);
    fields.forEach((name, field) => {
      numbers(json.fields?.[name], count, name).forEach((value, i) => {
        values![i * fields.length + field] = value;
      });
    });
  }
  return { heightsFx, looks: places, values };
}
