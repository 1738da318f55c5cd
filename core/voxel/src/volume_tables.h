// The probabilities of volumes: made by train_volume (tests/bench), part of the payload's format.
// FORMAT.md lists the same numbers, and a change needs a new kCodecVersion.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::codec {

/// By class: where the intervals of symbols 0, 1 and 2 end; that of symbol 3 ends at 256.
inline constexpr std::array<std::array<std::uint8_t, 3>, 62> kVolumeEnds{{
    {16, 43, 55},    {22, 253, 254},  {54, 91, 235},   {61, 251, 253},  {15, 191, 212},  {93, 197, 221},
    {79, 237, 247},  {99, 250, 253},  {120, 228, 241}, {139, 234, 243}, {133, 244, 251}, {147, 181, 208},
    {51, 89, 125},   {96, 165, 212},  {29, 142, 226},  {91, 139, 199},  {48, 176, 178},  {43, 92, 167},
    {67, 130, 223},  {79, 142, 161},  {51, 120, 193},  {72, 126, 192},  {61, 162, 204},  {68, 139, 183},
    {60, 141, 196},  {64, 128, 192},  {64, 128, 192},  {64, 128, 192},  {64, 128, 192},  {64, 128, 192},
    {64, 128, 192},  {64, 128, 192},  {64, 128, 192},  {64, 128, 192},  {64, 128, 192},  {64, 128, 192},
    {64, 128, 192},  {133, 252, 253}, {143, 193, 242}, {161, 243, 250}, {167, 252, 253}, {176, 249, 253},
    {185, 238, 245}, {190, 207, 208}, {194, 253, 254}, {197, 250, 252}, {208, 253, 254}, {213, 247, 248},
    {208, 230, 243}, {223, 254, 255}, {222, 250, 251}, {230, 253, 254}, {234, 254, 255}, {230, 239, 240},
    {241, 254, 255}, {247, 254, 255}, {243, 247, 251}, {247, 248, 249}, {251, 254, 255}, {252, 254, 255},
    {253, 254, 255}, {64, 128, 192},
}};

/// By table and context: a class, as a digit: 0 to 9, A to Z, a to z.
inline constexpr std::array<std::string_view, 4> kVolumeClasses{
    "5555899d899ddjfj588A89gg8d9fgllp588A8d9f89gggolp8AAf9dfk9dfkgloBCFBBL89BM9ABBBBB0B5BMf3B4j3BBBBB0MFBF6dB"
    "C7ABBBBB0BMBKebBCe3BBBBB8A9ddffiddfiikknAAddfjnodfiikqqs8AdfdiiidfkkjqpsdffiiiknffknnssBmBmB9BBB5AjBBBBB"
    "BjdBBBBBBBBBdBBBmmmBABBBDjiBBBBBDjiBBBBBBBBBbBBB5DF8BBBBBDBBBBBB2D2BBBBBB7BBBBBBNBIBBBBBBABBBBBBIBBdBBBB"
    "BBBBBBBBDDMdBBBBBDBBBBBBHcDBBBBBBbBBBBBBHBIBBBBBBbBBBBBBIBBjBBBBBBBBBBBB",
    "JBBhrorumurwxwxyggcogjtoruptutywc9rjgpptqltousvxmknfmkplmnrohrrBBFJBmDgBJmJBBBBB4BJB4m6BGrGBBBBBmFmBm5gB"
    "BggBBBBB4B4B4h8B4h3BBBBB9pgppqqqpppswyxy9olstxyxowswxyyydpoqpwkxsxwyyxyyotpkttytswwtyyyBhxrBoBBBBuBBBBBB"
    "uysBBBBBBBBBgBBBuyyBnBBBmtlBBBBBrukBBBBBBBBBjBBBHrNsBBBBBgBBBBBBCBCBBBBBBgBBBBBBNBDBBBBBBfBBBBBB2BBpBBBB"
    "BBBBBBBBHm9qBBBBBgBBBBBBCmBBBBBBBiBBBBBBNBDBBBBBB9BBBBBB2BBoBBBBBBBBBBBB",
    "B9rmufrtldqstiwrmfmnjexnljlosqyw5Amplgopj7wnunxw96rfmAwqgAtqpnyB5ccB5ffB6s8BBBBB3m5B3q3B3t7BBBBBM5mBc7pB"
    "5ndBBBBB3dmB6ibB3seBBBBBgpsrxstrtstsxtywljtstwyysxswyyyyggtpqwqxttyyxyyyoiwpttyxtsywwwyBcjkBbBBBgukBBBBB"
    "gwiBBBBBBBBBnBBBcttB7BBBmssBBBBB8tqBBBBBBBBBeBBBHcckBBBBB6BBBBBBK92BBBBBBbBBBBBBHgIBBBBBBnBBBBBB2BBeBBBB"
    "BBBBBBBB2ccsBBBBB6BBBBBBHccBBBBBBbBBBBBBKccBBBBBBbBBBBBB2BBnBBBBBBBBBBBB",
    "LOBgl8gs569sBoruKjcmg6ve6p6omsvyM68m8u6o53vjmtvyE4cfE6gkM6gigivBEcIBEm6B4u8BBBBB4m1B4t1B1y3BBBBBEIcBIAgB"
    "4u8BBBBB4g6BEp1B1vbBBBBBchhjysslrqrkvxvvggsgtwyyswqwyyyydjnppyuytxyxvyyydktqqwyypuwswwyBmgtBuBBBmtnBBBBB"
    "lynBBBBBBBBBtBBBumuBpBBBciyBBBBBgxnBBBBBBBBBnBBB5498BBBBB4BBBBBBIMcBBBBBB3BBBBBBIgIBBBBBBjBBBBBB8BB7BBBB"
    "BBBBBBBB5M8jBBBBB6BBBBBBJIgBBBBBB3BBBBBBIg2BBBBBBeBBBBBBIBBiBBBBBBBBBBBB",
};

}  // namespace talus::codec
