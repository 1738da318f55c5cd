#include <catch2/catch.hpp>

#include "config/endpoint.h"

using namespace talus::server;

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
