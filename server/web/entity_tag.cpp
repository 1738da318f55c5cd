#include "web/entity_tag.h"

#include <cstddef>

#include <xxhash.h>

namespace talus::server::web {

std::string entity_tag(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr std::size_t kHalf = 16;  // digits. Every answer has a tag: fmt would be slower
  std::string tag(2 + 2 * kHalf, '"');
  for (std::size_t i = 0; i < kHalf; ++i) {
    tag[1 + i] = kDigits[hash.high64 >> (60 - 4 * i) & 0xF];
    tag[1 + kHalf + i] = kDigits[hash.low64 >> (60 - 4 * i) & 0xF];
  }
  return tag;
}

bool lists_tag(const std::string* if_none_match, std::string_view tag) {
  return if_none_match != nullptr && (*if_none_match == "*" || if_none_match->find(tag) != std::string::npos);
}

}  // namespace talus::server::web
