// Reads untrusted FlatBuffers: every offset is checked against the frame before it is followed, and allocations are
// bounded. (The flatbuffers package has no verifier; it is used for writing.) Offsets are relative to the frame's first
// byte, the first of its length. test/frames.test.js compares this with the schema.
import { TalusError } from '../errors.js';

/** Bounds text and tables of one frame: a hostile one may refer to the same bytes repeatedly. */
const MAX_TEXT_BYTES = 1 << 20;
const MAX_TABLES = 65_536;

export function broken(what: string): TalusError {
  return new TalusError('broken_protocol', `the server sent ${what}`);
}

export class Frame {
  readonly view: DataView;
  private textBytes = 0;
  private tables = 0;

  constructor(readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  root(): Table {
    this.check(4, 4);
    return this.table(4 + this.view.getUint32(4, true));
  }

  check(at: number, bytes: number): void {
    if (at < 4 || at + bytes > this.bytes.length) throw broken('a frame with an offset past its end');
  }

  table(at: number): Table {
    if (++this.tables > MAX_TABLES) throw broken(`a frame with more than ${MAX_TABLES} tables`);
    return new Table(this, at);
  }

  text(at: number, bytes: number): string {
    this.textBytes += bytes;
    if (this.textBytes > MAX_TEXT_BYTES) throw broken(`a frame with more than ${MAX_TEXT_BYTES} bytes of text`);
    return decoder.decode(this.bytes.subarray(at, at + bytes));
  }
}

const decoder = /* @__PURE__ */ new TextDecoder();

/** `count` elements at `at`, all inside the frame. */
export interface Vector {
  readonly at: number;
  readonly count: number;
}
const NOTHING: Vector = { at: 0, count: 0 };

/** A table; fields by their number in the schema. Absent fields read as 0 or as empty. */
export class Table {
  private readonly view: DataView;
  private readonly vtable: number;
  private readonly vtableBytes: number;
  private readonly bytes: number;

  constructor(
    private readonly frame: Frame,
    private readonly at: number,
  ) {
    this.view = frame.view;
    frame.check(at, 4);
    this.vtable = at - this.view.getInt32(at, true);
    frame.check(this.vtable, 4);
    this.vtableBytes = this.view.getUint16(this.vtable, true);
    this.bytes = this.view.getUint16(this.vtable + 2, true);
    if (this.vtableBytes < 4 || this.vtableBytes % 2 !== 0) throw broken('a table with a wrong list of fields');
    frame.check(this.vtable, this.vtableBytes);
    frame.check(at, this.bytes);
  }

  /** Position of a field of `bytes`; 0: absent. */
  struct(field: number, bytes: number): number {
    const entry = 4 + 2 * field;
    if (entry + 2 > this.vtableBytes) return 0;
    const offset = this.view.getUint16(this.vtable + entry, true);
    if (offset === 0) return 0;
    if (offset < 4 || offset + bytes > this.bytes) throw broken('a table with a field outside it');
    return this.at + offset;
  }

  u8(field: number): number {
    const at = this.struct(field, 1);
    return at === 0 ? 0 : this.view.getUint8(at);
  }
  bool(field: number): boolean {
    return this.u8(field) !== 0;
  }
  u16(field: number): number {
    const at = this.struct(field, 2);
    return at === 0 ? 0 : this.view.getUint16(at, true);
  }
  i32(field: number): number {
    const at = this.struct(field, 4);
    return at === 0 ? 0 : this.view.getInt32(at, true);
  }
  u32(field: number): number {
    return this.i32(field) >>> 0;
  }
  u64(field: number): bigint {
    const at = this.struct(field, 8);
    return at === 0 ? 0n : this.view.getBigUint64(at, true);
  }
  i64(field: number): bigint {
    return BigInt.asIntN(64, this.u64(field));
  }

  private target(field: number): number {
    const at = this.struct(field, 4);
    if (at === 0) return 0;
    const target = at + this.view.getUint32(at, true);
    this.frame.check(target, 4);
    return target;
  }

  table(field: number): Table | null {
    const at = this.target(field);
    return at === 0 ? null : this.frame.table(at);
  }

  vector(field: number, elementBytes: number): Vector {
    const at = this.target(field);
    if (at === 0) return NOTHING;
    const count = this.view.getUint32(at, true);
    this.frame.check(at + 4, count * elementBytes);
    return { at: at + 4, count };
  }

  /** Returns a copy. */
  bytesOf(field: number): Uint8Array<ArrayBuffer> {
    const { at, count } = this.vector(field, 1);
    return new Uint8Array(this.frame.bytes.subarray(at, at + count));
  }

  text(field: number): string {
    const { at, count } = this.vector(field, 1);
    return this.frame.text(at, count);
  }

  texts(field: number): string[] {
    return this.eachOffset(field, (at) => {
      const bytes = this.view.getUint32(at, true);
      this.frame.check(at + 4, bytes);
      return this.frame.text(at + 4, bytes);
    });
  }

  tables<T>(field: number, read: (table: Table) => T): T[] {
    return this.eachOffset(field, (at) => read(this.frame.table(at)));
  }

  private eachOffset<T>(field: number, read: (at: number) => T): T[] {
    const { at, count } = this.vector(field, 4);
    if (count > MAX_TABLES) throw broken(`a list of ${count} entries`);
    const values: T[] = [];
    for (let i = 0; i < count; ++i) {
      const target = at + 4 * i + this.view.getUint32(at + 4 * i, true);
      this.frame.check(target, 4);
      values.push(read(target));
    }
    return values;
  }

  get data(): DataView {
    return this.view;
  }
}
