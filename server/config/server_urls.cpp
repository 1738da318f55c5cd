#include "config/server_urls.h"

#include <algorithm>

#include <fmt/format.h>

#include <talus/protocol/endpoint.h>

#include "runtime/log/escape.h"

#include "config/trimmed.h"

namespace talus::server {
namespace {

constexpr std::string_view kAfterScheme = "://";

std::string_view scheme_of(std::string_view url) {
  return url.substr(0, std::min(url.find(kAfterScheme), url.size()));
}

/// Normalizes an address; the error describes what is wrong with it.
tl::expected<std::string, std::string> checked_url(std::string_view url,
                                                   std::span<const std::string_view> schemes) {
  const std::string_view scheme = scheme_of(url);
  if (scheme.size() == url.size() || std::find(schemes.begin(), schemes.end(), scheme) == schemes.end()) {
    return tl::unexpected{fmt::format("does not begin with {}://", fmt::join(schemes, ":// or "))};
  }
  std::string_view rest = url.substr(scheme.size() + kAfterScheme.size());
  if (rest.ends_with('/')) rest.remove_suffix(1);
  if (rest.find('@') != std::string_view::npos) {
    return tl::unexpected{std::string{"holds a user or a secret; they have settings of their own"}};
  }
  const auto endpoint = protocol::parse_endpoint(rest);
  if (!endpoint) return tl::unexpected{endpoint.error()};
  if (endpoint->port == 0) return tl::unexpected{std::string{"has port 0; give the port of the server"}};
  return fmt::format("{}{}{}", scheme, kAfterScheme, to_string(*endpoint));
}

}  // namespace

tl::expected<ServerUrls, std::string> ServerUrls::parse(std::string_view text,
                                                        std::span<const std::string_view> schemes) {
  ServerUrls urls;
  if (trimmed(text).empty()) return urls;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string_view each = trimmed(text.substr(from, comma - from));
    auto url = checked_url(each, schemes);
    // Hides the part before an @, which may be secret.
    const std::size_t at = each.rfind('@');
    const std::string shown = escaped(each.substr(at == std::string_view::npos ? 0 : at));
    if (!url) return tl::unexpected{fmt::format("\"{}\" {}", shown, url.error())};
    if (!urls.empty() && scheme_of(*url) != urls.scheme()) {
      return tl::unexpected{fmt::format("\"{}\" is {}:// and others are {}://; give all the same", shown,
                                        scheme_of(*url), urls.scheme())};
    }
    if (urls.size() == kMax) {
      return tl::unexpected{fmt::format("the list has more than {} addresses; a few are enough", kMax)};
    }
    urls.urls_.push_back(*std::move(url));
    from = comma + 1;
  }
  return urls;
}

ServerUrls ServerUrls::just(std::size_t which) const {
  ServerUrls one;
  one.urls_.push_back(urls_[which]);
  return one;
}

std::string_view ServerUrls::scheme() const {
  return urls_.empty() ? std::string_view{} : scheme_of(urls_.front());
}

std::string ServerUrls::text() const {
  return fmt::format("{}", fmt::join(urls_, ", "));
}

}  // namespace talus::server
