// /v1/heights: PROTOCOL.md, "Heights". Input is not trusted.
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

const PATH_BYTES = 700; // for columns; servers and caches limit the length of a path

type Columns = readonly { readonly x: number; readonly z: number }[];

/** Requests columns in as many queries as path lengths require; `get(query)` returns a body. */
export async function askHeights(
  columns: Columns,
  { looks = false, fields = [] }: { readonly looks?: boolean; readonly fields?: readonly string[] },
  knownLooks: () => readonly string[],
  get: (query: string) => Promise<Uint8Array>,
): Promise<Places> {
  const all: Places = {
    heightsFx: new Int32Array(columns.length),
    looks: looks ? new Uint8Array(columns.length) : null,
    values: fields.length > 0 ? new Float32Array(columns.length * fields.length) : null,
  };
  const rest = [
    ...(looks ? ['&looks=1'] : []),
    ...(fields.length > 0 ? [`&fields=${fields.map(encodeURIComponent).join(',')}`] : []),
  ].join('');
  for (let at = 0; at < columns.length; ) {
    let list = '';
    let end = at;
    for (; end < columns.length && list.length < PATH_BYTES; ++end) {
      list += `${list === '' ? '' : ';'}${columns[end]!.x},${columns[end]!.z}`;
    }
    const places = readHeights(await get(`columns=${list}${rest}`), end - at, looks, fields, knownLooks());
    all.heightsFx.set(places.heightsFx, at);
    if (places.looks !== null) all.looks!.set(places.looks, at);
    if (places.values !== null) all.values!.set(places.values, at * fields.length);
    at = end;
  }
  return all;
}
