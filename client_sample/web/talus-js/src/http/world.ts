// /v1/world: Welcome as JSON. Input is not trusted.
import type { Material, Phase, Rates, World } from '../types.js';
import { checkHeights } from '../wire/heights.js';
import { broken } from '../wire/table.js';

type Json = Record<string, unknown>;

function wrong(name: string): never {
  throw broken(`a world whose ${name} is missing or wrong`);
}

function numberOf(from: Json, name: string): number {
  const value = from[name];
  return typeof value === 'number' && Number.isSafeInteger(value) ? value : wrong(name);
}

function textOf(from: Json, name: string): string {
  const value = from[name];
  return typeof value === 'string' ? value : wrong(name);
}

function listOf(from: Json, name: string): unknown[] {
  const value = from[name];
  return Array.isArray(value) ? value : wrong(name);
}

function objectOf(from: Json, name: string): Json {
  const value = from[name];
  return typeof value === 'object' && value !== null ? (value as Json) : wrong(name);
}

function fingerprintOf(from: Json, name: string): string {
  const value = textOf(from, name);
  return /^[0-9a-f]{32}$/.test(value) ? value : wrong(name);
}

function textsOf(from: Json, name: string): string[] {
  return listOf(from, name).map((value) => (typeof value === 'string' ? value : wrong(name)));
}

function materialOf(value: unknown): Material {
  const from = (value ?? {}) as Json;
  const colour = /^#([0-9a-f]{6})$/.exec(textOf(from, 'colour'));
  const phase = textOf(from, 'phase');
  if (colour === null || !['gas', 'liquid', 'solid'].includes(phase)) wrong('materials');
  return {
    id: numberOf(from, 'id'),
    name: textOf(from, 'name'),
    colour: parseInt(colour[1]!, 16),
    phase: phase as Phase,
  };
}

function ratesOf(from: Json, name: string): Rates {
  const rates = objectOf(from, name);
  return {
    chunks: numberOf(rates, 'chunks_per_second'),
    bytes: numberOf(rates, 'bytes_per_second'),
    requests: numberOf(rates, 'requests_per_second'),
    burstMs: numberOf(rates, 'burst_ms'),
  };
}

/** Limits that only streams have are 0. */
export function readWorld(json: unknown): World {
  if (typeof json !== 'object' || json === null) wrong('JSON');
  const from = json as Json;
  const limits = objectOf(from, 'limits');
  const [x, y, z] = listOf(from, 'spawn');
  if (![x, y, z].every(Number.isSafeInteger)) wrong('spawn');
  if (numberOf(from, 'chunk_size') !== 32) wrong('chunk_size');
  const minY = numberOf(from, 'min_y');
  const maxY = numberOf(from, 'max_y');
  checkHeights({ minY, maxY });
  return {
    protocol: 0,
    fingerprint: fingerprintOf(from, 'fingerprint'),
    storeId: fingerprintOf(from, 'store_id'),
    codec: numberOf(from, 'codec'),
    materials: listOf(from, 'materials').map(materialOf),
    minY,
    maxY,
    spawn: { x: x as number, y: y as number, z: z as number },
    limits: {
      frameBytes: 0,
      requestsInFlight: 0,
      heightsPerRequest: numberOf(limits, 'heights_per_request'),
      viewHorizontalRadius: numberOf(limits, 'view_horizontal_radius'),
      viewVerticalRadius: numberOf(limits, 'view_vertical_radius'),
      viewChunks: numberOf(limits, 'view_chunks'),
      windowBytes: 0,
      idleTimeoutMs: 0,
      sessionRates: ratesOf(limits, 'session'),
      addressRates: ratesOf(limits, 'address'),
      viewHorizon: true, // the chunks of a View are computed here
      viewBase: 'world_file' in from,
    },
    server: textOf(from, 'server'),
    looks: textsOf(from, 'looks'),
    fields: textsOf(from, 'fields'),
    worldFile: 'world_file' in from ? textOf(from, 'world_file') : '',
  };
}
