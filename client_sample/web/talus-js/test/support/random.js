// Random tests print their seed, and TALUS_SEED repeats one.
import { randomInt } from 'node:crypto';

/** next(n): an integer from 0 to n - 1. */
export function random(name) {
  const seed = Number(process.env.TALUS_SEED ?? randomInt(2 ** 31));
  console.log(`# ${name}: TALUS_SEED=${seed}`);
  let state = seed >>> 0;
  return (n) => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) % n;
  };
}

/** A copy with bytes changed, cut off, put in or repeated. */
export function mutate(bytes, next) {
  let out = [...bytes];
  for (let i = 1 + next(4); i > 0; --i) {
    const at = next(out.length + 1);
    switch (next(6)) {
      case 0:
        out[Math.min(at, out.length - 1)] = next(256);
        break;
      case 1:
        if (out.length > 0) out[at % out.length] ^= 1 << next(8);
        break;
      case 2:
        out = out.slice(0, at);
        break;
      case 3:
        out.splice(at, 0, ...Array.from({ length: 1 + next(8) }, () => next(256)));
        break;
      case 4:
        out.splice(at, 1 + next(8));
        break;
      default:
        out.splice(at, 0, ...out.slice(at, at + 1 + next(16)));
    }
  }
  return Uint8Array.from(out);
}
