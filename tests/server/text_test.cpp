#include <array>
#include <catch2/catch.hpp>

#include <rapidcheck.h>

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

TEST_CASE("the nearest name is the one with the fewest changes") {
  constexpr std::array<std::string_view, 3> kNames{"listen", "limits.connections", "log.level"};
  CHECK(nearest("lisen", kNames) == "listen");
  CHECK(nearest("limit.conections", kNames) == "limits.connections");
  CHECK(nearest("loglevel", kNames) == "log.level");
}
