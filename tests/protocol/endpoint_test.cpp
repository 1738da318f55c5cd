#include <string>

#include <catch2/catch.hpp>

#include <talus/protocol/endpoint.h>

namespace talus::protocol {

TEST_CASE("an endpoint is read back from its text") {
  for (const char* text : {"127.0.0.1:4780", "localhost:0", "[::]:65535", "[fe80::1%eth0]:1"}) {
    const auto endpoint = parse_endpoint(text);
    REQUIRE(endpoint.has_value());
    CHECK(to_string(*endpoint) == text);
  }
}

TEST_CASE("an address other than HOST:PORT is refused") {
  for (const char* text : {"", ":", "host", "host:", ":80", "host:65536", "host:-1", "host:8 0", "::1:80",
                           "[::1]", "[]:80", "h\nst:80", "ho st:80", "host:80x"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_endpoint(text).has_value());
  }
}

TEST_CASE("the error says what is wrong and repeats nothing of the text") {
  for (const auto& [text, what] : {std::pair{"hostname", "the port is missing"},
                                   {":80", "the host is missing"},
                                   {"::1:80", "needs brackets"},
                                   {"h\xFFst:80", "neither a name nor an address"},
                                   {"localhost:65536", "at most 65535"}}) {
    const auto endpoint = parse_endpoint(text);
    REQUIRE_FALSE(endpoint.has_value());
    CHECK_THAT(endpoint.error(), Catch::Contains(what) && !Catch::Contains(text));
  }
}

}  // namespace talus::protocol
