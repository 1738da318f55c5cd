#include "web/entity_tag.h"

#include <cstddef>
#include <cstdint>

#include <xxhash.h>

namespace talus::server::web {
namespace {

/// Writes sixteen digits. Every answer needs two of these numbers, so eight digits are made at a time, from
/// nibbles spread over the bytes of a number.
void write_hex(std::uint64_t number, char* to) {
  for (int half = 0; half < 2; ++half) {
    std::uint64_t nibbles = number >> (32 - 32 * half) & 0xFFFF'FFFF;
    nibbles = (nibbles << 16 | nibbles) & 0x0000'FFFF'0000'FFFF;
    nibbles = (nibbles << 8 | nibbles) & 0x00FF'00FF'00FF'00FF;
    nibbles = (nibbles << 4 | nibbles) & 0x0F0F'0F0F'0F0F'0F0F;
    // 1 in each byte above 9; 'a' - ('9' + 1) is 39.
    const std::uint64_t letters = (nibbles + 0x0606'0606'0606'0606) >> 4 & 0x0101'0101'0101'0101;
    const std::uint64_t digits = nibbles + 0x3030'3030'3030'3030 + letters * 39;
    for (int i = 0; i < 8; ++i) to[8 * half + i] = static_cast<char>(digits >> (56 - 8 * i) & 0xFF);
  }
}

}  // namespace

http::EntityTag entity_tag(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  http::EntityTag tag;
  tag.front() = tag.back() = '"';
  write_hex(hash.high64, tag.data() + 1);
  write_hex(hash.low64, tag.data() + 17);
  return tag;
}

bool lists_tag(std::string_view if_none_match, const http::EntityTag& tag) {
  return if_none_match == "*" || if_none_match.find(http::text_of(tag)) != std::string_view::npos;
}

}  // namespace talus::server::web
