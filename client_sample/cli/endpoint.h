// HOST:PORT as a person types it.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::cli {

struct Endpoint {
  std::string host;
  std::string port;
};

/// "host:port", "1.2.3.4:port" or "[::1]:port"; else one line that says what is wrong with it, as of
/// `option`.
[[nodiscard]] tl::expected<Endpoint, std::string> parse_endpoint(std::string_view text,
                                                                 std::string_view option = "--connect");

}  // namespace talus::cli
