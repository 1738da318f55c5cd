// A NATS server's first line, INFO {...}.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server::cluster_tool {

struct Greeting {
  std::string name;
  std::string version;  // "2.9.10"
  bool jetstream = false;
  bool tls = false;         // required
  bool tls_verify = false;  // client certificates required
  std::int64_t max_payload = 0;
};

/// Reads the greeting of "nats://HOST:PORT". An error is one line without the address.
[[nodiscard]] tl::expected<Greeting, std::string> greeting_of(std::string_view url,
                                                              std::chrono::milliseconds patience);

[[nodiscard]] tl::expected<Greeting, std::string> parse_greeting(std::string_view line);

/// True if `version` is at least `major`.`minor`.
[[nodiscard]] bool at_least(std::string_view version, int major, int minor);

}  // namespace talus::server::cluster_tool
