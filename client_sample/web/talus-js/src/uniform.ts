// Payloads of uniform chunks: the shortest that FORMAT.md defines.

/** 03 00 01, then the id as a number. */
export function uniformPayload(material: number): Uint8Array<ArrayBuffer> {
  const bytes = [3, 0, 1];
  let rest = material;
  for (; rest >= 0x80; rest >>= 7) bytes.push((rest & 0x7f) | 0x80);
  bytes.push(rest);
  return Uint8Array.from(bytes);
}

/** The material of a uniform payload; null if it is another kind, or invalid. */
export function materialOf(payload: Uint8Array): number | null {
  if (payload.length < 4 || payload.length > 6 || payload[0] !== 3 || payload[1] !== 0 || payload[2] !== 1) return null;
  let material = 0;
  for (let i = 3; i < payload.length; ++i) material |= (payload[i]! & 0x7f) << (7 * (i - 3));
  const expected = uniformPayload(material & 0xffff);
  return expected.length === payload.length && expected.every((byte, i) => byte === payload[i]) ? material : null;
}
