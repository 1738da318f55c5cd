"""Decodes a chunk's payload: codec 4 of core/voxel/FORMAT.md, whose terms this file uses.

    voxels = decode(payload)        # numpy uint16[32][32][32]: y, z, x

To use the decoder in another project, copy this file: it is complete, and needs only numpy.

The symbols of the entropy coder are sequential, so a loop reads them; numpy computes their predictions for a row of a
plane or a wave of a volume at once.

Sections: the whole payload; numbers and entropy coding; trained numbers; volume; runs and raw; layered.
"""

import functools
import struct

import numpy as np

SIZE = 32
VOXELS = SIZE**3
MAX_PAYLOAD_BYTES = 65538

# Zeros after the payload, so that a step may read past the end and be rejected afterwards. The longest step is a batch
# of a volume: 17 groups of exceptions and 256 symbols and escapes, under 2,000 bytes.
_READ_AHEAD = 4096


class DecodeError(ValueError):
    """Invalid payload. `reason` is the error's name in FORMAT.md, with underscores."""

    def __init__(self, reason, detail=""):
        super().__init__(f"not a chunk's payload: {reason.replace('_', ' ')}" + (f" ({detail})" if detail else ""))
        self.reason = reason


def decode(payload):
    """Returns a payload's voxels as a new array uint16[y][z][x]. Raises DecodeError if it is invalid."""
    payload = bytes(payload)
    if not payload:
        raise DecodeError("empty")
    version = payload[0]
    if version not in (3, 4):
        raise DecodeError("unknown_version", f"{version}; this decoder knows 3 and 4")
    if len(payload) < 2:
        raise DecodeError("truncated")
    if len(payload) > MAX_PAYLOAD_BYTES:
        raise DecodeError("too_long", f"{len(payload)} bytes; a payload has at most {MAX_PAYLOAD_BYTES}")
    read = _READERS.get((version, payload[1]))
    if read is None:
        raise DecodeError("unknown_encoding", f"{payload[1]} of version {version}")
    return read(payload).astype(np.uint16, copy=False).reshape(SIZE, SIZE, SIZE)


# Numbers and entropy coding
# --------------------------


class Header:
    """The uncoded parts of a body, from the payload's third byte on."""

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

    def numbers(self, count, max_count):
        if not 1 <= count <= max_count:
            raise DecodeError("bad_materials", f"{count} materials; from 1 to {max_count} are possible")
        return [self.number() for _ in range(count)]

    def materials_with_probabilities(self):
        ids = self.numbers(self.number(), 256)
        if ids[0] in ids[1:] or any(a >= b for a, b in zip(ids[1:], ids[2:])):
            raise DecodeError("bad_materials", "an id repeats, or ids after the first do not rise")
        return ids, slot_table([size + 1 for size in self.take(len(ids))])

    def coded(self):
        """The rest: 16 states and the coded part."""
        return RansReader(self.payload, self.at)


def slot_table(sizes):
    """For each slot 0 to 255: (the size of its interval, the slot's place in it, the symbol)."""
    if sum(sizes) != 256:
        raise DecodeError("bad_number", f"intervals end at {sum(sizes)} instead of 256")
    return [(size, place, symbol) for symbol, size in enumerate(sizes) for place in range(size)]


class RansReader:
    """Sixteen rANS states and the bytes that they read, to the end of the payload."""

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
        """Checks the end. Without `endings` all states must be 256; otherwise returns the bytes that they hold."""
        if self.at < self.end:
            raise DecodeError("too_long", f"{self.end - self.at} bytes after the end")
        rest = [state - 256 for state in self.states]
        if max(rest) > (255 if endings else 0):
            raise DecodeError("bad_ending", "the final states do not end a whole payload")
        return bytes(rest)


# Trained numbers
# ---------------
# Copied block by block from FORMAT.md, which a test compares: text by name; `volume-classes` has one text for each of
# the eight tables.


BLOCKS = {
    "gap-sizes": """
60 10 11 12 17 12 13 17 22 24 20 15 11 6 4 2
""",
    "volume-ends": """
 53  85 199    28 163 242    50 180 206    83 153 208    43 218 236    91 198 217   110 180 237   122 229 245
134 210 236   151 250 253   151 173 218    21  46 248     8  20  28    15  28  42    18 254 255    44  85 240
 53  95 131    22  71  83    49 252 253    59 241 245    21 254 255   162 203 234   100 123 252    81 237 247
 35 251 252    62 135 230   122 141 251   115 135 252    59 246 252   199 211 231     8 251 253   105 140 250
 69 251 255   116 249 252   166 220 221    75 254 255   130 178 201   146 233 239   164 223 244   158 240 249
189 234 238   183 236 248   188 209 247   189 252 253   200 235 247   209 247 250   206 253 254   216 235 245
223 253 254   222 245 246   229 249 252   232 254 255   240 254 255   241 248 249   228 233 234   245 254 255
240 244 250   249 250 251   250 254 255   252 254 255   253 254 255   132 182 228
""",
    "volume-classes": (
        """
5555777d777ddfhk577d7bfebdbhfjjm57797dbh7bjefjjp7999bdhkb9hkenna
G3Aa377a3d7aaaaaHL5a2hSa4kIaaaaaD3aa3NdaGXXaaaaaCa2a3h9aHhZaaaaa
77ddd99hddhhhkkmddd9hhmm9hhhkqpq7999dhhhdhjkkpmq999hhhkm9hkmmqqa
lziabaaa59kaaaaazj9aaaaaaaaadaaaTiiaXaaa3kkaaaaaakhaaaaaaaaaXaaa
5337aaaaa3aaaaaa03FaaaaaaXaaaaaa3zPaaaaaa9aaaaaaPaadaaaaaaaaaaaa
332daaaaa3aaaaaaGz6aaaaaa9aaaaaaGa0aaaaaaXaaaaaaPaahaaaaaaaaaaaa
""",
        """
AzTcTiTlTiTlTuuuALTlTlsnLllrTusvLLliTllrTlsnTusvTcTlTisrTisrnrsa
T7zaTdLaolAaaaaaLf6agfaahraaaaaau7gau9gawlTaaaaaT98alhYamrYaaaaa
TusrTvsvsvsyvysysvsuuvrqnrvvuvvysvrrrrrrsuvruvvvuyvyuxvyuxvyrxva
5v7a2aaa6l5aaaaa1okaaaaaaaaa4aaa5ySa4aaa6r5aaaaa1ohaaaaaaaaaJaaa
PY0eaaaaaTaaaaaa38PaaaaaaLaaaaaa0gQaaaaaa9aaaaaaFaalaaaaaaaaaaaa
FnBnaaaaauaaaaaaPcPaaaaaaeaaaaaa0gRaaaaaa9aaaaaaBaaoaaaaaaaaaaaa
""",
        """
z6LzzcLcz8LeLlllz8TcLcsjziljiosrz8icziioLcsjiosrz7lfzdnnzdnmYnsa
073aAd8a8oNaaaaa1c3a6j5aSrJaaaaa0Nzag9fa8oNaaaaa2a5a2Y5a4sOaaaaa
TTssTusssrsvuvsvTusuuuvvlvswuvvvlrsqrrsruuvvuvvvTuvtguvxTuvxnwva
lTuadaaaLilaaaaactkaaaaaaaaadaaaouoa9aaacrnaaaaaiphaaaaaaaaa9aaa
P52baaaaazaaaaaa366aaaaaa7aaaaaa0gVaaaaaa9aaaaaaPaaiaaaaaaaaaaaa
Fe2jaaaaagaaaaaa0L6aaaaaabaaaaaa0gMaaaaaa9aaaaaaFaajaaaaaaaaaaaa
""",
        """
aaaYsorruorxywyyffejjkwmrrptytyxccsjeopwqjtoxqxxlkmhsmxmomtmytya
A3aaTzcaaiGaaaaa4TGa4nJa2r2aaaaar3lal5iaeehaaaaa4Laa5nbaNnIaaaaa
eonrotrtrtrtxyyyfootwyyxoxtxxyyyetotqxkyrvwyyxyyoxpkwwytrwxtyyya
GxaabaaaGuaaaaaazrhaaaaaaaaabaaaaylaJaaazteaaaaaarkaaaaaaaaa9aaa
GrGtaaaaaeaaaaaaGeGaaaaaaYaaaaaaGazaaaaaahaaaaaaFaamaaaaaaaaaaaa
0lataaaaafaaaaaaGlAaaaaaahaaaaaa3a3aaaaaabaaaaaaFaamaaaaaaaaaaaa
""",
        """
06gio9no7NeqTmvr3hgifSx99ohplpyy2Nbocobo7Sxkltvy34nf1Sjk2Sohehva
P66aPiXa4uXaaaaa4c4a1tEaOyZaaaaaP1zaP9fa4vcaaaaaG77a1kOaUvZaaaaa
znswywttrqsouwyviorowxyyqwqwyyyyeomqqyryuxyyyyyyiqwqoyyyowxqwwya
itmaoaaaftkaaaaaoymaaaaaaaaataaaujuakaaaghyaaaaafwmaaaaaaaaamaaa
548baaaaa1aaaaaaF2VaaaaaaWaaaaaaPdPaaaaaahaaaaaa7aaXaaaaaaaaaaaa
337maaaaa4aaaaaaGPiaaaaaaZaaaaaaPfVaaaaaa9aaaaaaPaahaaaaaaaaaaaa
""",
        """
eAslxhrwf9YnrkxrAfTuohxmeqeouwyy3Seulcmn7StmlqyyPSlm6NwqaNnqmkya
66caPdXaNu9aaaaaJiSa4mKaZxZaaaaa01gaPWfaeobaaaaa289a19Za5wXaaaaa
cjlmytqqrtrqwtxviotqtxyytxqvyyyyejqoouqwrtyyxyyyiwwwovyyotwtwxya
9rhaeaaadthaaaaaiykaaaaaaaaapaaaTllaZaaaghwaaaaa6qtaaaaaaaaa9aaa
33gjaaaaa4aaaaaa3LVaaaaaaZaaaaaa0cPaaaaaajaaaaaaPaa9aaaaaaaaaaaa
33btaaaaa1aaaaaa3VgaaaaaaZaaaaaaPcVaaaaaaXaaaaaaFaamaaaaaaaaaaaa
""",
        """
Tbseldnredqqtkwsidljo9xmldjmrpxw8dljfjnooXxmrpxweNodi9wpk9wpomya
5zLa7hhaJp7aaaaaOl6aOqZaKtZaaaaa57gacXoa7kdaaaaaOfTaNk9aOq9aaaaa
iorsrtwrrtwtxwywlowqxxyyoxtwyyyyeotooypyttyyxyyyokxmwtyxwqyxwwya
6jqaXaaacumaaaaafxhaaaaaaaaakaaaLtwaZaaaitqaaaaa8wpaaaaaaaaahaaa
0LgmaaaaaNaaaaaa3bVaaaaaa9aaaaaa0f6aaaaaamaaaaaaFaahaaaaaaaaaaaa
FfctaaaaaXaaaaaa0f6aaaaaa9aaaaaa3c6aaaaaa9aaaaaaFaamaaaaaaaaaaaa
""",
        """
PG38555t2N5rAlsrPdFi55sb4iOjAtsv2g2LJnJj25sbTwsy12P725bk245hYnsa
1APa1l1aUT3aaaaa4uUa1xUaUvIaaaaaPz0aPdca4T3aaaaa4lUa1tOaUrmaaaaa
eYefrosenosksysvfij7rxywoxkrxyyyejhojxrxsvywsyvyiktiopxwoTwtwxya
u5xauaaaixqaaaaajyhaaaaaaaaaraaaulyaraaagqyaaaaafymaaaaaaaaamaaa
b4bJaaaaaUaaaaaaP4caaaaaaIaaaaaaPePaaaaaamaaaaaa7aa7aaaaaaaaaaaa
54NNaaaaaNaaaaaa2PdaaaaaaZaaaaaaPfPaaaaaa9aaaaaa6aahaaaaaaaaaaaa
""",
    ),
    "intervals": """
 23  41  65  96 118 143 167 193 209 227 243 246 250 253 252 253
250 253 253 252 254 254 255 255 254 255 255 255 255 255 255 255
  1  10  11  26  44  55  75 121 145 171 194 228 235 245 253 255
""",
    "weights-level-even": """
  41   52   53   40   54   68   55   40   53   54   47   40   40   40   40   40
  46   42   50   64   56   71   79   64   69   88   66   64   64   64   64   64
  -7   13   26    0  -24    5    0    0    8    6  -11    0    0    0    0    0
 -47  -60  -37    0  -54  -35    9    0   -9    6   35    0    0    0    0    0
  -1   -7  -27    0  -12    9   -7    0  -19  -10    0    0    0    0    0    0
  16  -16  -28    0   42   -1  -36    0   28   22  -10    0    0    0    0    0
   7  -16   -9    0   15    0   13    0   -2  -17   12    0    0    0    0    0
 -41  -43  -24    0  -14    0    8    0    1   34   19    0    0    0    0    0
 -20   -4   -2    0    4    3    4    0   -4   -3  -18    0    0    0    0    0
 -54  -17  -23    0  -14    0   16    0    5    5   45    0    0    0    0    0
  11  -16  -22    0   -3    1   -1    0  -16   -5   -2    0    0    0    0    0
 -51  -19   33    0  -47   -6   26    0  -30  -11   -2    0    0    0    0    0
  11    8   31    0   -2   -2  -12    0   -5    0   -8    0    0    0    0    0
  79  116  107    0   21   27   25    0   12  -13  -28    0    0    0    0    0
  19   -3   -1    0   -7    1    2    0   -6    2   -4    0    0    0    0    0
 101  112   74    0    4    0  -13    0  -12    0   15    0    0    0    0    0
 -10    2   15    0    1    2  -14    0  -14    0    8    0    0    0    0    0
 114  100   45    0  -51    2  127    0  -29    0   16    0    0    0    0    0
""",
    "weights-level-odd": """
  41   53   52   40   52   68   53   40   54   55   45   40   40   40   40   40
  30   49   71   64   38   69   86   64   57   78   83   64   64   64   64   64
   3   17   32    0  -28    5    7    0    2    4   -7    0    0    0    0    0
 -79  -81  -37    0  -42  -36    1    0   17   19   46    0    0    0    0    0
  -1  -10  -32    0  -15   11  -11    0  -21  -11    3    0    0    0    0    0
  36  -24  -65    0   42   -3  -44    0   66   37  -18    0    0    0    0    0
  11   -9   -4    0   14   -2   13    0    0  -11   13    0    0    0    0    0
  -1  -15  -11    0    8    1   -3    0   -1   14   -3    0    0    0    0    0
  -5   -3    7    0    7   -4    7    0    4   -3   -5    0    0    0    0    0
  -6   -7  -31    0    8    0  -10    0   15    2    4    0    0    0    0    0
  13  -16  -26    0    3   -1   -2    0  -11   -4   -2    0    0    0    0    0
 -94  -14   52    0  -60    5   48    0  -43  -12    2    0    0    0    0    0
   7   -2   27    0   -1   -1  -19    0   -1    3   -6    0    0    0    0    0
  41   71  111    0    9   36   72    0  -19  -29  -28    0    0    0    0    0
  20   -2   -3    0  -16    4   -3    0  -11    4   -9    0    0    0    0    0
  87   75   53    0    1   -1   -7    0  -36    1   37    0    0    0    0    0
 -14    4   29    0    8    2  -15    0   -6    0    5    0    0    0    0    0
  92   76   28    0  -47   -1  127    0  -25    1    4    0    0    0    0    0
  -3   12   -1    0  -41  -36   15    0   17  -34  -46    0   -2  -30    7    0
  24   -3  -37    0   56   69   32    0  -31  -65  -91    0  -62   -4   64    0
  -1   11   -5    0   15  -34  -39    0  -33  -30   18    0   18  -26    5    0
 -38   -4   31    0   23   63   55    0  -82  -64  -24    0   62  -11  -61    0
   0    1    1    0   -7    6    4    0   22    7    0    0   27  -12  -19    0
  94  -10    4    0   29   -9   32    0   41  -29  -29    0   40  -16    5    0
   0   -1    0    0   -8    3    3    0   23    0   -3    0   28  -17  -22    0
  87    0    0    0   28    7   31    0   34  -18  -37    0   44    2   -7    0
""",
    "weights-carried-even": """
  52   44   49   40   50   53   52   40   50   45   53   40   40   40   40   40
  50   54   71   64   52   64   75   64   50   74   77   64   64   64   64   64
  17   22   17    0   -5   -4   -1    0   -3   -2   -2    0    0    0    0    0
 -27  -22  -26    0   -1  -11   -6    0   14    3    4    0    0    0    0    0
  -1   -5  -23    0  -13   11  -12    0  -21   -2    5    0    0    0    0    0
  16  -19  -24    0   51    1  -45    0   28   18  -15    0    0    0    0    0
   0   -1    0    0   -4    5   -3    0   -3   -4    0    0    0    0    0    0
  25   23   30    0   -7    1    6    0   -7  -21  -24    0    0    0    0    0
  -1   -2    2    0    1    2    2    0    0   -2   -3    0    0    0    0    0
 -27   -4   -5    0  -13    0   11    0    2    8   24    0    0    0    0    0
  11  -32  -29    0   -1    2    0    0  -15   -1    0    0    0    0    0    0
 -18   21   31    0  -32    2   20    0  -32   -8    1    0    0    0    0    0
   4   -5    6    0    3   -1   -6    0    2    0   -1    0    0    0    0    0
  -2   40   89    0   12    0    5    0   19   -5  -27    0    0    0    0    0
  -4   -3    9    0    4   -1   -1    0    1    0   -2    0    0    0    0    0
  19   -2    1    0    5    2   -5    0   -5   -1    6    0    0    0    0    0
   3   -1   -2    0   -1    1   -2    0    1    0   -1    0    0    0    0    0
  23   -1  -20    0  -20    4   21    0  -10    1    4    0    0    0    0    0
""",
    "weights-carried-odd": """
  51   49   53   40   49   53   51   40   49   51   53   40   40   40   40   40
  54   65   62   64   53   66   71   64   63   69   71   64   64   64   64   64
  13   20   13    0   -4   -4    0    0   -2   -1   -1    0    0    0    0    0
   4  -20  -35    0  -10   -7   -3    0    8    3    9    0    0    0    0    0
  -2   -4  -23    0  -13   11  -12    0  -19   -2    2    0    0    0    0    0
  16  -22  -17    0   39    1  -34    0   17   22  -14    0    0    0    0    0
   0   -2    1    0    1    4    1    0   -1   -4   -1    0    0    0    0    0
  20   18   18    0    7   -1   -3    0  -11  -18  -18    0    0    0    0    0
   0   -2    4    0    1   -1    3    0    0   -3    0    0    0    0    0    0
 -32   -9   -6    0  -15    0   11    0    3   10   30    0    0    0    0    0
  11  -29  -27    0   -6    2    2    0  -19   -1    0    0    0    0    0    0
 -18   20   25    0  -28    5   19    0  -25   -5    1    0    0    0    0    0
   5   -3    8    0    1   -1   -8    0    1    1   -1    0    0    0    0    0
   2   27   77    0   12   -5    4    0   16   -3  -26    0    0    0    0    0
  -4   -1    6    0    1    0   -1    0    1    1   -4    0    0    0    0    0
   6    2    8    0    5    3   -6    0   -3   -1    4    0    0    0    0    0
   3   -2   -1    0   -2    1   -1    0    0    0   -1    0    0    0    0    0
  14    0  -15    0  -16    1   30    0   -3    0   -1    0    0    0    0    0
   3    5    4    0    9   -9  -13    0  -14   -9    8    0   -7  -15   -5    0
  -1    0    3    0  -19  -25  -17    0   20   24   19    0    3   -2   -1    0
   3    2    4    0   -3   -6   -6    0   -6   -7   -4    0    1   -5   -3    0
   4    0   -5    0  -10  -14  -18    0   16   16   12    0  -12    4    7    0
  -1   -2    0    0  -15    8    1    0   -6    5    0    0   -2    4    0    0
   8   -1   -1    0    2    0   -8    0  -20    0    8    0  -40   12    4    0
   0   -2    0    0  -11    5    0    0    1    0    0    0    4    5   -4    0
  -3    0    1    0   21    8   -7    0    0   -2    4    0   13  -22    4    0
""",
    "weights-first-even": """
  40   40   40   40   40   61   40   40   40   40   40   40   40   40   40   40
  64   64   64   64   64   66   64   64   64   64   64   64   64   64   64   64
   0    4    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0  -19    0  -28    5  -30    0  -26   -1   -3    0    0    0    0    0
  18  -20  -38    0   42    1  -43    0   23   26  -30    0    0    0    0    0
   0    0    0    0    0    2    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    2    0    0    0    0    0    0    0    0    0
   0    0    0    0  -15    1   16    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   5   -2    4    0    0    0    0    0    0    0    0    0    0    0    0    0
  23    0  -24    0    0    0    0    0    0    0    0    0    0    0    0    0
  -2    1   -4    0    0    0    0    0    0    0    0    0    0    0    0    0
   9   -1   -6    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
""",
    "weights-first-odd": """
  40   40   40   40   40   63   40   40   40   40   40   40   40   40   40   40
  64   64   64   64   64   64   64   64   64   64   64   64   64   64   64   64
   0    5    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
 -10    1  -25    0  -33    7  -33    0  -32    5  -15    0    0    0    0    0
  27  -23  -33    0   43    0  -40    0   20   23  -23    0    0    0    0    0
   0    0    0    0    0    3    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    3   -1    3    0    0    0    0    0    0    0    0    0
   0    0    0    0  -17    0   19    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   4   -2    3    0    0    0    0    0    0    0    0    0    0    0    0    0
  23    0  -22    0    0    0    0    0    0    0    0    0    0    0    0    0
  -4    1   -5    0    0    0    0    0    0    0    0    0    0    0    0    0
   7    0  -10    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   6    4    8    0  -16  -19  -40    0  -30  -22   -5    0  -23  -20  -25    0
  12    1   -2    0  -17   -3  -24    0    9   -1   -4    0   -2   -3  -11    0
  11    4   17    0   -6  -10   -1    0  -30  -14  -14    0  -21  -37  -22    0
  -5    0  -11    0   -6   15  -10    0   26  -12   13    0   52   -1  -45    0
  -2    0    0    0    5    0    0    0    6    0    0    0    6    0    0    0
   0    0    0    0   -2    0    0    0    2    0    0    0    0    0    0    0
   0    0    0    0   -1    0    0    0    0    0    0    0   -5    0    0    0
   0    0    0    0    1    0    0    0    0    0    0    0    0    0    0    0
""",
}


# Volume
# ------
# numpy finds the contexts of a wave at once; only voxels that are not steady are looped over.


_WAVES = 94
_PADDED = SIZE + 2  # a row with its first and last voxel repeated at its ends
_FIRST_ROW = SIZE * SIZE  # a row of the first material
_GAPS = slot_table([int(size) for size in BLOCKS["gap-sizes"].split()])


@functools.lru_cache(maxsize=None)
def _volume_ends(table):
    """For each context 0 to 383: ends of the intervals of symbols 0, 1 and 2."""
    numbers = [int(end) for end in BLOCKS["volume-ends"].split()]
    classes = [tuple(numbers[i : i + 3]) for i in range(0, len(numbers), 3)]
    letters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
    return [classes[letters.index(letter)] for line in BLOCKS["volume-classes"][table].split() for letter in line]


@functools.lru_cache(maxsize=None)
def _wave_rows(wave):
    """Indices of rows: the wave's, and their rows north, below, below north and below south."""

    def place(y, z):
        return y * SIZE + z

    rows = []
    for y in range(max(0, (wave - SIZE + 2) // 2), min(SIZE - 1, wave // 2) + 1):
        z = wave - 2 * y
        if y == 0 and z == 0:
            around = [_FIRST_ROW] * 4
        elif y == 0:
            around = [place(0, z - 1)] * 4
        else:
            below = place(y - 1, z)
            around = [
                place(y, z - 1) if z > 0 else below,
                below,
                place(y - 1, z - 1) if z > 0 else below,
                place(y - 1, z + 1) if z < SIZE - 1 else below,
            ]
        rows.append([place(y, z), *around])
    return np.array(rows).T


class Exceptions:
    """Materials of steady voxels that differ from the prediction. `wait`: steady voxels before the next one."""

    def __init__(self, coded, slots, count):
        self.coded, self.slots, self.left = coded, slots, count
        self.group = []
        self.wait = VOXELS  # more than there can be
        self.advance()

    def advance(self):
        if not self.group and self.left:
            size = min(self.left, 16)
            gaps = self.coded.digits(_GAPS, size)
            self.group = list(zip(gaps, self.coded.values(self.slots, size)))[::-1]
            self.left -= size
        self.wait = self.group[-1][0] if self.group else VOXELS

    def pass_by(self, count):
        self.wait -= count

    def among(self, count):
        """(place, material) of each exception among the next `count` steady voxels."""
        found = []
        at = 0
        while at + self.wait < count:
            at += self.wait
            found.append((at, self.group.pop()[1]))
            at += 1
            self.advance()
        self.wait -= count - at
        return found


# Equalities near a voxel, as bits of one number. The first eight are known before its row is read.
_NEAR_BITS = 8


def _bits(count):
    numbers = np.arange(1 << count)
    return [(numbers >> i & 1).astype(bool) for i in range(count)]


def _number(*bits):
    return sum(bit.astype(np.int16) << i for i, bit in enumerate(bits))


def _even_contexts():
    upright, level_south, west_n, east_n, west_b, east_b, same, level, south_north = _bits(_NEAR_BITS + 1)
    surroundings = _number(upright, level_south, west_n, east_n, west_b, east_b)
    differ = _number(level, upright, level_south, south_north, west_n & east_n, west_b & east_b)
    return np.where(same, surroundings, 64 + differ).astype(np.int16)


def _odd_contexts():
    """Contexts, and whether E is first: by the first eight bits and W = E, N = W, B = W, N = E, B = E."""
    upright, level_south, west_n, east_n, west_b, east_b, same, level, between, nw, bw, ne, be = _bits(_NEAR_BITS + 5)
    base_west, other_west = np.where(level, nw, bw), np.where(level, bw, nw)
    base_east, other_east = np.where(level, ne, be), np.where(level, be, ne)
    swap = base_east | (other_east & ~base_west)
    surroundings = _number(upright, level_south, west_n, east_n, west_b, east_b)
    differ = _number(
        np.where(swap, base_east, base_west),
        np.where(swap, other_east, other_west),
        np.where(swap, base_west, base_east),
        np.where(swap, other_west, other_east),
        upright,
        level,
        level_south,
    )
    equal = _number(base_west, other_west, same, upright, level, level_south)
    contexts = np.where(between, np.where(base_west & other_west, 128 + surroundings, 192 + equal), 256 + differ)
    return contexts.astype(np.int16), swap & ~between


_EVEN_CONTEXTS = _even_contexts()
_ODD_CONTEXTS, _EAST_FIRST = _odd_contexts()
_STEADY_EVEN, _STEADY_ODD = 63, 128 + 63  # the contexts of steady voxels


def _packed(equal):
    """Each voxel's eight bits, the last axis, as one number. Along any other axis packbits takes ten times as long."""
    return np.packbits(equal, bitorder="little").reshape(equal.shape[:2]).astype(np.intp)


def read_volume(payload):
    header = Header(payload)
    ids, slots = header.materials_with_probabilities()
    count = header.number()
    if len(payload) < header.at + 33:
        raise DecodeError("truncated")
    table = header.take(1)[0]
    if table > 7:
        raise DecodeError("bad_number", f"table {table}; there are 0 to 7")
    ends = _volume_ends(table)
    coded = header.coded()
    exceptions = Exceptions(coded, slots, count)
    # Indices in the list of materials; the first is 0. The last row is not changed.
    rows = np.zeros((SIZE * SIZE + 1, _PADDED), np.uint8)
    for wave in range(_WAVES):
        places = _wave_rows(wave)
        rows[places[0]] = Wave(rows[places[1:]], coded, exceptions, ends, slots).read()
    if exceptions.left or exceptions.group:
        raise DecodeError("bad_number", "exceptions are left over")
    coded.finish()
    return np.array(ids, np.uint16)[rows[:-1, 1:-1]]


class Wave:
    """The rows around a wave's: [north, below, below north, below south][row of the wave][x + 1]."""

    def __init__(self, around, coded, exceptions, ends, slots):
        self.around, self.coded, self.exceptions, self.ends, self.slots = around, coded, exceptions, ends, slots

    def read(self):
        """The wave's rows, padded."""
        around = self.around
        padded = around[1].copy()
        now = padded[:, 1:-1]
        north, below, below_north, below_south = around[:, :, 1:-1]
        equal = np.empty((*now.shape, _NEAR_BITS), bool)
        bits = equal.transpose(2, 0, 1)
        np.equal(north, below_north, out=bits[0])  # upright
        np.equal(below, below_south, out=bits[1])  # level south
        np.equal(around[:2, :, :-2], around[:2, :, 1:-1], out=bits[2:6:2])  # west n, west b
        np.equal(around[:2, :, 2:], around[:2, :, 1:-1], out=bits[3:6:2])  # east n, east b
        np.equal(north, below, out=bits[6])  # same
        np.equal(below, below_north, out=bits[7])  # level
        near = _packed(equal)
        np.copyto(now, north, where=bits[7])  # base, the first candidate of even columns
        if (near & 127).min() == 127 and self.exceptions.wait >= now.size:
            self.exceptions.pass_by(now.size)  # odd voxels are steady too, as their neighbours are base
            return padded
        self.read_even(now, near[:, 0::2], north[:, 0::2] == below_south[:, 0::2])
        padded[:, -1] = padded[:, -3]  # E of the last column is W
        self.read_odd(padded, near[:, 1::2], north[:, 1::2], below[:, 1::2])
        padded[:, 0] = padded[:, 1]
        padded[:, -1] = padded[:, -2]
        return padded

    def read_even(self, now, near, south_north):
        contexts = _EVEN_CONTEXTS[near + south_north * (1 << _NEAR_BITS)]
        now[:, 0::2] = self.read_batch(now[:, 0::2].ravel(), contexts.ravel(), None).reshape(near.shape)

    def read_odd(self, padded, near, north, below):
        west, east = padded[:, 1:-2:2], padded[:, 3::2]
        equal = np.zeros((*near.shape, 8), bool)
        bits = equal.transpose(2, 0, 1)
        np.equal(west, east, out=bits[0])
        np.equal(north, west, out=bits[1])
        np.equal(below, west, out=bits[2])
        np.equal(north, east, out=bits[3])
        np.equal(below, east, out=bits[4])
        places = near + (_packed(equal) << _NEAR_BITS)
        swap = _EAST_FIRST[places]
        first = np.where(swap, east, west).ravel()
        read = self.read_batch(first, _ODD_CONTEXTS[places].ravel(), lambda: np.where(swap, west, east).ravel())
        padded[:, 2::2] = read.reshape(near.shape)

    def read_batch(self, voxels, contexts, seconds):
        """Turns `voxels`, a batch's first candidates, into its voxels. `seconds`: second candidates of odd columns."""
        coded, exceptions, ends = self.coded, self.exceptions, self.ends
        steady = contexts == (_STEADY_EVEN if seconds is None else _STEADY_ODD)
        others = np.flatnonzero(~steady)
        count = steady.size - others.size
        if exceptions.wait >= count:
            exceptions.pass_by(count)
        else:
            places = np.flatnonzero(steady)
            for place, material in exceptions.among(count):
                voxels[places[place]] = material
        symbols = coded.symbols([ends[context] for context in contexts[others].tolist()])
        bad = ""
        if any(symbols):
            escapes = []
            around = self.around.tobytes()
            if seconds:
                seconds = seconds()
            for place, first, symbol in zip(others.tolist(), voxels[others].tolist(), symbols):
                if symbol == 3:
                    escapes.append(place)
                elif symbol:
                    candidates = self.candidates(around, place, () if seconds is None else (first, int(seconds[place])))
                    if symbol < len(candidates):
                        voxels[place] = candidates[symbol]
                    else:
                        bad = "a candidate that there is not"
            voxels[escapes] = coded.values(self.slots, len(escapes))
        coded.end_of_step(bad)
        return voxels

    def candidates(self, around, place, beside):
        """The distinct materials around the voxel at `place` of its batch, most likely first."""
        row, column = divmod(place, SIZE // 2)
        stride = self.around.shape[1] * _PADDED
        north = row * _PADDED + 2 * column + (1 + (len(beside) > 0))
        below = north + stride
        n, b, d, s = around[north], around[below], around[below + stride], around[below + 2 * stride]
        both = (n, b) if b == d else (b, n)
        sides = (around[north + 1], around[north - 1], around[below + 1], around[below - 1])
        return list(dict.fromkeys(beside + both + sides + (s, d)))


# Runs and raw
# ------------


def read_runs(payload):
    header = Header(payload)
    ids, slots = header.materials_with_probabilities()
    count = header.number()
    single = count == VOXELS
    digits = None if single else slot_table(header.take(16))
    coded = header.coded()
    lengths, kinds = [], []
    filled = 0
    for begin in range(0, count, 256 if single else 16):
        size = min(count - begin, 256 if single else 16)
        group = [1] * size if single else [more + 1 for more in coded.digits(digits, size)]
        kinds += coded.values(slots, size)
        filled += sum(group)
        coded.end_of_step("runs of more voxels than a chunk has" if filled > VOXELS else "")
        lengths += group
    if filled != VOXELS:
        raise DecodeError("bad_number", f"runs of {filled} voxels; a chunk has {VOXELS}")
    coded.finish()
    return np.repeat(np.array(ids, np.uint16)[kinds], lengths)


def read_raw(payload):
    if len(payload) < MAX_PAYLOAD_BYTES:
        raise DecodeError("truncated")
    return np.frombuffer(payload, "<u2", VOXELS, 2).copy()


# Layered
# -------
# numpy finds the features of a row at once.

# The features of a column, two bits of its key each.
_FEATURES = (
    "west",
    "east",
    "far east",
    "step",
    "step west",
    "step east",
    "step far west",
    "step far east",
    "floor",
    "thickness",
    "thickness west",
    "thickness east",
    "symbol west",
    "symbol east",
)
_PAIRS = (
    ("step west", "step east"),
    ("floor", "thickness east"),
    ("west", "east"),
    ("step", "step far west"),
    ("far east", "step far east"),
    ("thickness west", "thickness east"),
    ("west", "thickness"),
    ("east", "thickness"),
    ("floor", "thickness"),
    ("west", "symbol west"),
    ("east", "symbol east"),
    ("thickness", "symbol west"),
    ("thickness", "symbol east"),
)
_SYMBOL_WEST, _SYMBOL_EAST = (2 * _FEATURES.index(name) for name in ("symbol west", "symbol east"))


def _interval_ends():
    """For each pair of classes, 16 * the first score's + the second's: ends of symbols 0's, 1's and 2's intervals."""
    a, o, u = (list(map(int, line.split())) for line in BLOCKS["intervals"].strip().split("\n"))
    return [(a[i], a[i] + 1 + ((o[i] - a[i] - 2) * u[j] >> 8), o[i]) for i in range(16) for j in range(16)]


class Columns(dict):
    """Ends of intervals by a column's key, for one kind of row and parity of x. Keys repeat, so scores are cached."""

    INTERVAL_ENDS = _interval_ends()
    MAX_KEYS = 1 << 14

    def __init__(self, kind, parity):
        super().__init__()
        weights = [list(map(int, line.split())) for line in BLOCKS[f"weights-{kind}-{parity}"].strip().split("\n")]
        self.pairs = [
            (2 * _FEATURES.index(first), 2 * _FEATURES.index(second), weights[2 * i], weights[2 * i + 1])
            for i, (first, second) in enumerate(_PAIRS[: len(weights) // 2])
        ]

    def __missing__(self, key):
        one = two = 0
        for first, second, weights_one, weights_two in self.pairs:
            features = (key >> first & 3) + 4 * (key >> second & 3)
            one = min(max(one + weights_one[features], -128), 127)
            two = min(max(two + weights_two[features], -128), 127)
        if len(self) == self.MAX_KEYS:
            self.clear()
        ends = self[key] = self.INTERVAL_ENDS[(max(one, 0) >> 3) * 16 + (max(two, 0) >> 3)]
        return ends


_COLUMNS = {kind: (Columns(kind, "even"), Columns(kind, "odd")) for kind in ("first", "level", "carried")}


def read_layered(payload):
    header = Header(payload)
    count = header.number()
    ids = None
    if 66 <= count <= 80:
        count -= 64
    else:
        ids = header.numbers(count, 64)
        _check_neighbours(ids)
        if count == 1:
            if header.at < len(payload):
                raise DecodeError("too_long")
            return np.full(VOXELS, ids[0], np.uint16)
    coded = header.coded()
    floor = np.zeros((SIZE, SIZE), int)
    # The number of planes at or below a voxel equals the number of materials below its own.
    levels = np.arange(SIZE)[:, None, None]
    materials = np.zeros((SIZE, SIZE, SIZE), np.uint8)
    for _ in range(count - 1):
        floor = _read_plane(coded, floor)
        materials += floor <= levels
    ending = coded.finish(endings=ids is None)
    if ids is None:
        ids = _ids_of_ending(ending, count)
        _check_neighbours(ids)
    return np.array(ids, np.uint16)[materials]


def _check_neighbours(ids):
    if any(a == b for a, b in zip(ids, ids[1:])):
        raise DecodeError("bad_materials", "neighbours are equal")


def _ids_of_ending(ending, count):
    header = Header(b"  " + ending)
    try:
        ids = [header.number() for _ in range(count)]
    except DecodeError:
        raise DecodeError("bad_ending", "the final states hold no ids") from None
    if any(ending[header.at - 2 :]):
        raise DecodeError("bad_ending", "the final states hold more than ids")
    return ids


# The features of a row in one array: steps from x = -2, rises from x - 1 to x, rises of two columns, thicknesses from
# x = -1, and the floor's rises.
_STEPS, _RISES, _FAR, _THICKNESS, _FLOOR, _END = 0, 36, 70, 102, 136, 168
_PLACES = {
    "west": _RISES,
    "east": _RISES + 1,
    "far east": _FAR,
    "step": _STEPS + 2,
    "step west": _STEPS + 1,
    "step east": _STEPS + 3,
    "step far west": _STEPS,
    "step far east": _STEPS + 4,
    "floor": _FLOOR,
    "thickness": _THICKNESS + 1,
    "thickness west": _THICKNESS,
    "thickness east": _THICKNESS + 2,
}
_GATHER = np.array([_PLACES[name] + np.arange(SIZE) for name in _FEATURES if name in _PLACES])
_KEY_BITS = np.array([1 << 2 * i for i, name in enumerate(_FEATURES) if name in _PLACES])
_REPEATED = np.array([0, *range(SIZE), SIZE - 1, SIZE - 1])  # x = -1 to 33


class RowFeatures:
    """The keys of a row's columns, without the symbols."""

    def __init__(self):
        self.signs = np.empty(_END, int)
        self.thickness = np.empty(34, int)

    def keys(self, steps, north, below_north, below):
        signs = self.signs
        near = north[_REPEATED]
        signs[:_RISES] = steps
        np.subtract(near[1:], near[:-1], out=signs[_RISES : _FAR])
        np.subtract(near[3:], north, out=signs[_FAR : _THICKNESS])
        np.subtract(below, below_north, out=signs[_FLOOR :])
        np.sign(signs, out=signs)
        signs += 1
        np.subtract(near[:34], below_north[_REPEATED[:34]], out=self.thickness)
        np.minimum(self.thickness, 2, out=signs[_THICKNESS : _FLOOR])
        return np.dot(_KEY_BITS, signs[_GATHER]).tolist()


def _read_plane(coded, floor):
    present = coded.bytes(1)[0]
    masks = [coded.bytes(1)[0] if present >> b & 1 else 0 for b in range(4)]
    carried = int.from_bytes(bytes(masks), "little")
    coded.end_of_step("a mask of carried rows" if present > 15 or carried & 1 else "")
    plane = np.zeros((SIZE, SIZE), int)
    features = RowFeatures()
    steps = np.zeros(SIZE + 4, int)  # of the previous row, from x = -2
    for z in range(SIZE):
        north, below_north = (plane[z - 1], floor[z - 1]) if z else (floor[0], floor[0])
        kind = "carried" if carried >> z & 1 else "level" if z else "first"
        changes = _read_changes(coded, features.keys(steps, north, below_north, floor[z]), *_COLUMNS[kind])
        steps[2:-2] = changes if kind == "level" else np.cumsum(changes)
        np.maximum(north * (north != below_north), floor[z], out=plane[z])  # as predicted: no floor is below 0
        plane[z] += steps[2:-2]
        if coded.at > coded.end:
            break
    whole = slice(z if coded.at > coded.end else SIZE)  # an invalid height in an earlier row precedes truncation
    if (plane[whole] < floor[whole]).any() or (plane[whole] > SIZE).any():
        raise DecodeError("bad_number", "a height below its floor or over 32")
    coded.end_of_step()
    return plane


def _read_changes(coded, keys, even_columns, odd_columns):
    """The changes of a row's steps."""
    even = coded.symbols([even_columns[key] for key in keys[0::2]])
    odd_keys = keys[1::2]
    if any(even):
        odd_keys = [
            key + (west << _SYMBOL_WEST) + (east << _SYMBOL_EAST)
            for key, west, east in zip(odd_keys, even, even[1:] + [0])
        ]
    odd = coded.symbols([odd_columns[key] for key in odd_keys])
    symbols = [symbol for pair in zip(even, odd) for symbol in pair]
    return [_CHANGES[symbol] if symbol < 3 else _signed(coded.bytes(1)[0]) for symbol in symbols]


_CHANGES = (0, 1, -1)


def _signed(byte):
    return byte - 256 if byte > 127 else byte


# By version and encoding.
_READERS = {
    (3, 0): read_layered,
    (4, 1): read_volume,
    (4, 2): read_raw,
    (4, 3): read_runs,
}
