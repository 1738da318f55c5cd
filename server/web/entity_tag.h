// Entity tags, by which caches revalidate answers. Pure functions. Source: RFC 9110, 8.8.3 and 13.1.2.
#pragma once

#include <string>
#include <string_view>

#include "net/http/response.h"

namespace talus::server::web {

[[nodiscard]] http::EntityTag entity_tag(std::string_view bytes);

/// Returns true if an If-None-Match list has the tag.
[[nodiscard]] bool lists_tag(std::string_view if_none_match, const http::EntityTag& tag);

}  // namespace talus::server::web
