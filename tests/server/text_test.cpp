#include <array>
#include <catch2/catch.hpp>

#include <rapidcheck.h>

#include "config/endpoint.h"
#include "config/nearest.h"
#include "log/escape.h"

using namespace talus::server;

TEST_CASE("escaped text is printable ASCII and bounded, whatever it was") {
  CHECK(rc::check([](const std::string& text) {
    const std::string safe = escaped(text, 20);
    RC_ASSERT(safe.size() <= 20 * 4 + 3);
    for (const char c : safe) RC_ASSERT(c >= ' ' && c <= '~');
  }));
}

TEST_CASE("printable text is left as it is") {
  CHECK(escaped("talus-client 1.0 (x86)") == "talus-client 1.0 (x86)");
  CHECK(escaped("a\nb\"\\") == "a\\x0ab\\x22\\x5c");
}

TEST_CASE("an endpoint is read back from its text") {
  for (const char* text : {"127.0.0.1:4780", "localhost:0", "[::]:65535", "[fe80::1%eth0]:1"}) {
    const auto endpoint = parse_endpoint(text);
    REQUIRE(endpoint.has_value());
    CHECK(to_string(*endpoint) == text);
  }
}

TEST_CASE("what is not HOST:PORT is refused") {
  for (const char* text : {"", ":", "host", "host:", ":80", "host:65536", "host:-1", "host:8 0", "::1:80",
                           "[::1]", "[]:80", "ho st:80", "host:80x"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_endpoint(text).has_value());
  }
}

TEST_CASE("the nearest name is the one with the fewest changes") {
  constexpr std::array<std::string_view, 3> kNames{"listen", "limits.connections", "log.level"};
  CHECK(nearest("lisen", kNames) == "listen");
  CHECK(nearest("limit.conections", kNames) == "limits.connections");
  CHECK(nearest("loglevel", kNames) == "log.level");
}
