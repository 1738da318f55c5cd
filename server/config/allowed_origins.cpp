#include "config/allowed_origins.h"

#include <algorithm>

#include <fmt/format.h>

namespace talus::server {
namespace {

constexpr std::string_view kHttp = "http://";
constexpr std::string_view kHttps = "https://";

/// True for a scheme, host and optional port, as browsers send them.
bool is_origin(std::string_view text) {
  const std::string_view scheme = text.starts_with(kHttps) ? kHttps : kHttp;
  if (!text.starts_with(scheme) || text.size() == scheme.size()) return false;
  return text.find_first_of("/?#@ ABCDEFGHIJKLMNOPQRSTUVWXYZ", scheme.size()) == std::string_view::npos;
}

std::string_view host_of(std::string_view origin) {
  for (const std::string_view scheme : {kHttps, kHttp}) {
    if (origin.starts_with(scheme)) return origin.substr(scheme.size());
  }
  return {};
}

}  // namespace

tl::expected<AllowedOrigins, std::string> AllowedOrigins::parse(std::string_view text) {
  AllowedOrigins allowed;
  allowed.text_ = text;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    std::string_view each = text.substr(0, comma);
    while (each.starts_with(' ')) each.remove_prefix(1);
    while (each.ends_with(' ')) each.remove_suffix(1);
    if (each == "*") {
      allowed.all_ = true;
    } else if (is_origin(each)) {
      allowed.origins_.emplace_back(each);
    } else {
      return tl::make_unexpected(
          fmt::format("'{}' is not an origin; write https://play.example, or * for all", each.substr(0, 80)));
    }
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return allowed;
}

bool AllowedOrigins::allow(std::string_view origin, std::string_view host) const {
  if (all_) return true;
  if (!host.empty() && host_of(origin) == host) return true;
  return lists(origin);
}

bool AllowedOrigins::lists(std::string_view origin) const {
  return std::find(origins_.begin(), origins_.end(), origin) != origins_.end();
}

}  // namespace talus::server
