// The vectors and documents of the repository that this package is a part of.
import { readFileSync } from 'node:fs';

const root = new URL('../../../../../', import.meta.url);

export function read(path) {
  return readFileSync(new URL(path, root), 'utf8');
}

export function fromHex(hex) {
  return Uint8Array.from(hex === '-' ? [] : hex.match(/../g), (byte) => parseInt(byte, 16));
}

/** Of core/voxel/vectors/payloads.txt: {kind: 'chunk' | 'error', name, value: hash or error, payload}. */
export function payloads() {
  return read('core/voxel/vectors/payloads.txt')
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('#'))
    .map((line) => {
      const [kind, name, value, hex] = line.split(' ');
      return { kind, name, value, payload: fromHex(hex) };
    });
}
