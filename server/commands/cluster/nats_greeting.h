// What a NATS server says of itself before anything else: the line INFO {...}.
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
  bool tls = false;         // asked for
  bool tls_verify = false;  // of clients, too
  std::int64_t max_payload = 0;
};

/// Of "nats://HOST:PORT". An error is one line without the address.
[[nodiscard]] tl::expected<Greeting, std::string> greeting_of(std::string_view url,
                                                              std::chrono::milliseconds patience);

[[nodiscard]] tl::expected<Greeting, std::string> parse_greeting(std::string_view line);

/// Whether the version is at least that.
[[nodiscard]] bool at_least(std::string_view version, int major, int minor);

}  // namespace talus::server::cluster_tool
