// Reads the NumPy arrays of talus-gen.
import { readFileSync } from 'node:fs';

const KINDS = { '|u1': Uint8Array, '<u2': Uint16Array, '<i4': Int32Array };

export function readNpy(path) {
  const bytes = readFileSync(path);
  const header = bytes.toString('latin1', 10, 10 + bytes.readUInt16LE(8));
  const kind = KINDS[/'descr': '([^']+)'/.exec(header)[1]];
  const shape = /'shape': \(([^)]*)\)/.exec(header)[1].split(',').map((n) => n.trim()).filter(Boolean).map(Number);
  const data = bytes.subarray(10 + bytes.readUInt16LE(8));
  return { shape, values: new kind(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength)) };
}
