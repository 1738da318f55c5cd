// The probabilities of volumes: made by train_volume (tests/bench), part of the payload's format.
// FORMAT.md lists the same numbers, and a change needs a new kCodecVersion.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::codec {

/// By class: where the intervals of symbols 0, 1 and 2 end; that of symbol 3 ends at 256.
inline constexpr std::array<std::array<std::uint8_t, 3>, 62> kVolumeEnds{{
    {24, 182, 193},  {11, 203, 236},  {32, 143, 221},  {69, 211, 237},  {98, 198, 241},  {89, 185, 211},
    {101, 214, 231}, {118, 239, 247}, {127, 228, 241}, {140, 235, 245}, {137, 245, 252}, {147, 181, 209},
    {14, 253, 255},  {49, 82, 237},   {52, 94, 129},   {15, 28, 43},    {8, 20, 28},     {49, 252, 253},
    {34, 252, 253},  {68, 254, 255},  {23, 73, 84},    {193, 208, 209}, {60, 254, 255},  {72, 249, 251},
    {83, 239, 248},  {33, 67, 211},   {99, 249, 253},  {64, 121, 216},  {87, 144, 244},  {74, 126, 185},
    {82, 162, 207},  {93, 148, 210},  {167, 254, 255}, {222, 232, 241}, {140, 254, 255}, {53, 240, 248},
    {121, 249, 251}, {137, 248, 250}, {145, 197, 242}, {161, 243, 250}, {171, 250, 254}, {174, 248, 249},
    {180, 236, 247}, {189, 240, 242}, {194, 253, 254}, {197, 250, 252}, {208, 253, 254}, {212, 246, 247},
    {203, 230, 245}, {223, 254, 255}, {222, 250, 251}, {230, 253, 254}, {234, 254, 255}, {231, 241, 242},
    {241, 254, 255}, {247, 254, 255}, {244, 249, 251}, {247, 248, 249}, {251, 254, 255}, {252, 254, 255},
    {253, 254, 255}, {97, 250, 255},
}};

/// By table and context: a class, as a digit: 0 to 9, A to Z, a to z.
inline constexpr std::array<std::string_view, 4> kVolumeClasses{
    "5666699d699ddjjj688A88gh8d9egllp677A8d9e88jhgolp6AAe8dfk9efkhloBEVBBT89BU97BBBBBKB3B2fNB0jHBBBBBFUTBTOdB"
    "EaaBBBBBGB5BTfbBKfNBBBBB8A9ddeeideeiikknAAdejjnoeeiikqqs7AAeeiWidjkkjqpsAeeiiikneiknnssBXBmB9BBB6AjBBBBB"
    "BjdBBBBBBBBBdBBBmmmBABBBUjiBBBBB5jiBBBBBBBBBaBBB5UV8BBBBBUBBBBBBPVDBBBBBBQBBBBBBTBRBBBBBBABBBBBBRBBdBBBB"
    "BBBBBBBBUU5dBBBBBUBBBBBBTcVBBBBBBbBBBBBBTBRBBBBBBaBBBBBBRBBjBBBBBBBBBBBB",
    "5BBLLoruXuuwxwxyggcogjtoruptutywggrjhpptqltousuxhkneXkpomnuoLrLBBTTBmBgB5mEBBBBB0BEB0lOB0r0BBBBBmTmBm5mB"
    "BgfBBBBB0B0B0L6B0LZBBBBB9pgppqqqpppswyxy9ojstxyxowswxyyygpoqpwkxsxwyyxyyotpkttytswwtyyyBLxrBoBBBBXBBBBBB"
    "uysBBBBBBBBBhBBBuyyBnBBBmtlBBBBBrukBBBBBBBBBjBBBErTsBBBBBgBBBBBBEBEBBBBBBhBBBBBBTBVBBBBBBfBBBBBBDBBpBBBB"
    "BBBBBBBBRX8qBBBBBgBBBBBBEmBBBBBBBiBBBBBBTBVBBBBBBbBBBBBBDBBoBBBBBBBBBBBB",
    "B9XmuertleqstiwrmeXnjWxnljlosqyw47mplmopjQwnunxwcZrjmAwqjAtqpnyB4ccB4eeBOs7BBBBBZm4BZqJBNtJBBBBBU4mBcQpB"
    "5ndBBBBBZdmBOiYBZsWBBBBBgpsrxstrtstsxtywojtstwyysxswyyyyggtpqwqxttyyxyyyoiwpttyxtsywwwyB4jkBbBBBgukBBBBB"
    "gwiBBBBBBBBBnBBBmtuBJBBBmssBBBBB8tqBBBBBBBBBWBBBPcckBBBBBOBBBBBBTgSBBBBBBYBBBBBBPgSBBBBBBnBBBBBBSBBWBBBB"
    "BBBBBBBBPccsBBBBBOBBBBBBPccBBBBBBYBBBBBBTcSBBBBBBYBBBBBBDBBnBBBBBBBBBBBB",
    "VUBgo7hs3O6sBoruRjSmgZvf6pNoXsvy236m7XOo6ZujXtvy23cg2Zfk2ZhihivB2cSB2mOB1u6BBBBB1mCB1tCBCyMBBBBB24cBRAgB"
    "1X8BBBBB0gOB2pIBCvYBBBBBcLLjysulrqrkvxvvggsgtwyyswqwyyyygjnppyuyuxyxvyyydktqqwyypuwswwyBmhtBuBBBmtnBBBBB"
    "lynBBBBBBBBBtBBBXmyBpBBBciyBBBBBgxnBBBBBBBBBnBBB5197BBBBB1BBBBBBV3cBBBBBBHBBBBBBRg2BBBBBBjBBBBBB4BBzBBBB"
    "BBBBBBBB556jBBBBB3BBBBBB5SgBBBBBBMBBBBBBRgSBBBBBBWBBBBBBSBBiBBBBBBBBBBBB",
};

}  // namespace talus::codec
