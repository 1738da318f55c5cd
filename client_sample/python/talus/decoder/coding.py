"""What all encodings are made of: numbers, lists, and symbols coded by rANS (FORMAT.md, Entropy coding)."""

import struct

SIZE = 32
VOXELS = SIZE**3
MAX_PAYLOAD_BYTES = 65538

# Zeros after the payload, so that a step may read past the end and be refused after it. A batch of a volume is the
# longest step: 17 groups of exceptions and 256 symbols and escapes, under 2,000 bytes.
_READ_AHEAD = 4096


class DecodeError(ValueError):
    """Bytes that are no payload. `reason` is the error's name in FORMAT.md, with underscores."""

    def __init__(self, reason, detail=""):
        super().__init__(f"not a chunk's payload: {reason.replace('_', ' ')}" + (f" ({detail})" if detail else ""))
        self.reason = reason


class Header:
    """The parts of a body before the coded ones, from the payload's third byte on."""

    def __init__(self, payload):
        self.payload = payload
        self.at = 2

    def take(self, count):
        part = self.payload[self.at : self.at + count]
        if len(part) < count:
            raise DecodeError("truncated")
        self.at += count
        return part

    def number(self):
        value = 0
        for shift in (0, 7, 14):
            byte = self.take(1)[0]
            value |= (byte & 127) << shift
            if byte < 128:
                if value > 0xFFFF or (byte == 0 and shift > 0):
                    break
                return value
        raise DecodeError("bad_number", "a number over 65,535 or longer than necessary")

    def numbers(self, count, most):
        if not 1 <= count <= most:
            raise DecodeError("bad_materials", f"{count} materials; from 1 to {most} are possible")
        return [self.number() for _ in range(count)]

    def materials_with_probabilities(self):
        ids = self.numbers(self.number(), 256)
        if ids[0] in ids[1:] or any(a >= b for a, b in zip(ids[1:], ids[2:])):
            raise DecodeError("bad_materials", "an id repeats, or ids after the first do not rise")
        return ids, slot_table([size + 1 for size in self.take(len(ids))])

    def coded(self):
        """What is left: 16 states and the coded part."""
        return Coded(self.payload, self.at)


def slot_table(sizes):
    """For each slot 0 to 255: (the size of its interval, the slot's place in it, the symbol)."""
    if sum(sizes) != 256:
        raise DecodeError("bad_number", f"intervals end at {sum(sizes)} instead of 256")
    return [(size, place, symbol) for symbol, size in enumerate(sizes) for place in range(size)]


class Coded:
    """Sixteen rANS states and the bytes that they take, to the end of the payload."""

    def __init__(self, payload, at):
        if len(payload) < at + 32:
            raise DecodeError("truncated")
        self.states = list(struct.unpack_from("<16H", payload, at))
        if min(self.states) < 256:
            raise DecodeError("bad_ending", "a state begins below 256")
        self.data = payload + bytes(_READ_AHEAD)
        self.at = at + 32
        self.end = len(payload)

    def symbols(self, ends):
        """A symbol 0 to 3 for each (end of symbol 0, of 1, of 2); the k-th is read from state k % 16."""
        states, data, at = self.states, self.data, self.at
        symbols = []
        put = symbols.append
        lane = 0
        for one, two, three in ends:
            state = states[lane]
            slot = state & 255
            if slot < one:
                state = one * (state >> 8) + slot
                put(0)
            elif slot < two:
                state = (two - one) * (state >> 8) + slot - one
                put(1)
            elif slot < three:
                state = (three - two) * (state >> 8) + slot - two
                put(2)
            else:
                state = (256 - three) * (state >> 8) + slot - three
                put(3)
            if state < 256:
                state = state << 8 | data[at]
                at += 1
            states[lane] = state
            lane = lane + 1 & 15
        self.at = at
        return symbols

    def values(self, slots, count):
        """`count` symbols of the same intervals; the k-th is read from state k % 16."""
        states, data, at = self.states, self.data, self.at
        values = []
        for k in range(count):
            state = states[k & 15]
            size, place, value = slots[state & 255]
            state = size * (state >> 8) + place
            if state < 256:
                state = state << 8 | data[at]
                at += 1
            states[k & 15] = state
            values.append(value)
        self.at = at
        return values

    def digits(self, slots, count):
        """A group of up to 16 numbers as digits."""
        counts = self.values(slots, count)
        size = sum(digits - 1 for digits in counts if digits) + 7 >> 3
        bits = int.from_bytes(self.bytes(size), "little")
        numbers = []
        for digits in counts:
            below = max(digits - 1, 0)
            numbers.append(bits & (1 << below) - 1 | 1 << below if digits else 0)
            bits >>= below
        return numbers

    def bytes(self, count):
        part = self.data[self.at : self.at + count]
        self.at += count
        return part

    def end_of_step(self, bad=""):
        if self.at > self.end:
            raise DecodeError("truncated")
        if bad:
            raise DecodeError("bad_number", bad)

    def finish(self, endings=None):
        """At the end. Without `endings` all states must be 256; else they hold bytes, which are given back."""
        if self.at < self.end:
            raise DecodeError("too_long", f"{self.end - self.at} bytes after the end")
        rest = [state - 256 for state in self.states]
        if max(rest) > (255 if endings else 0):
            raise DecodeError("bad_ending", "the final states are not those of a whole payload")
        return bytes(rest)
