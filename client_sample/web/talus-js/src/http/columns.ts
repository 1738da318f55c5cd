// Columns and squares of chunks in one body: PROTOCOL.md, "Columns of chunks".
import { broken } from '../wire/table.js';

export const MAX_BODY_BYTES = 4 << 20;

/** Vertically consecutive chunks with one payload. */
export interface Run {
  readonly firstY: number;
  readonly count: number;
  readonly payload: Uint8Array;
}

/** The runs of a column, from the lowest chunk of the level to the highest, without gaps. */
export function readColumn(body: Uint8Array, lod: number): Run[] {
  const data = new DataView(body.buffer, body.byteOffset, body.byteLength);
  if (body.length < 4 || body[0] !== 1 || body[1] !== 0) throw broken('no column of chunks of version 1');
  const count = data.getUint16(2, true);
  const limit = 2 ** (31 - lod);
  const runs: Run[] = [];
  let at = 4;
  let y = -limit;
  for (let i = 0; i < count; ++i) {
    if (at + 12 > body.length) throw broken('a column of chunks that ends within a run');
    const firstY = data.getInt32(at, true);
    const rows = data.getUint32(at + 4, true);
    const bytes = data.getUint32(at + 8, true);
    at += 12;
    if (at + bytes > body.length) throw broken('a column of chunks that ends within a payload');
    if (firstY !== y || rows === 0) throw broken(`a column of chunks with row ${firstY} after row ${y - 1}`);
    runs.push({ firstY, count: rows, payload: body.subarray(at, at + bytes) });
    at += bytes;
    y += rows;
  }
  if (at !== body.length || y !== limit) throw broken('a column of chunks that does not end as it should');
  return runs;
}

/** The bodies of a square's n x n columns, from west to east, then from north to south. */
export function readSquare(body: Uint8Array, n: number): Uint8Array[] {
  const data = new DataView(body.buffer, body.byteOffset, body.byteLength);
  if (body.length < 4 || body[0] !== 1 || body[1] !== n || data.getUint16(2, true) !== 0) {
    throw broken(`no square of ${n} x ${n} columns of version 1`);
  }
  const columns: Uint8Array[] = [];
  let at = 4;
  for (let i = 0; i < n * n; ++i) {
    if (at + 4 > body.length) throw broken('a square of columns that ends within one');
    const bytes = data.getUint32(at, true);
    at += 4;
    if (at + bytes > body.length) throw broken('a square of columns that ends within one');
    columns.push(body.subarray(at, at + bytes));
    at += bytes;
  }
  if (at !== body.length) throw broken('a square of columns that goes on after its end');
  return columns;
}
