#include "web/entity_tag.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace talus::server::web {

std::string entity_tag(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("\"{:016x}{:016x}\"", hash.high64, hash.low64);
}

bool lists_tag(const std::string* if_none_match, std::string_view tag) {
  return if_none_match != nullptr && (*if_none_match == "*" || if_none_match->find(tag) != std::string::npos);
}

}  // namespace talus::server::web
