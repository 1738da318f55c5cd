#include "config/networks.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <fmt/format.h>

using namespace talus::server;

namespace {

asio::ip::address address(const std::string& text) {
  return asio::ip::make_address(text);
}

Networks networks(const std::string& text) {
  const auto parsed = Networks::parse(text);
  REQUIRE(parsed.has_value());
  return *parsed;
}

}  // namespace

TEST_CASE("a list of networks contains what lies in one of them, and no neighbour") {
  const Networks list = networks("10.0.0.0/8, 192.0.2.7 ,2001:db8::/33");
  CHECK(list.contain(address("10.255.255.255")));
  CHECK_FALSE(list.contain(address("11.0.0.0")));
  CHECK(list.contain(address("192.0.2.7")));
  CHECK_FALSE(list.contain(address("192.0.2.6")));
  CHECK(list.contain(address("2001:db8:7fff::1")));
  CHECK_FALSE(list.contain(address("2001:db8:8000::1")));
}

TEST_CASE("an IPv4 address mapped into IPv6 is in the network that it is in by itself") {
  CHECK(networks("192.0.2.0/24").contain(address("::ffff:192.0.2.9")));
  CHECK(networks("::ffff:192.0.2.0/120").contain(address("192.0.2.9")));
}

TEST_CASE("a network of length 0 is all of its kind") {
  CHECK(networks("0.0.0.0/0").contain(address("203.0.113.1")));
  CHECK_FALSE(networks("0.0.0.0/0").contain(address("2001:db8::1")));
  CHECK(networks("::/0").contain(address("203.0.113.1")));
}

TEST_CASE("an empty list of networks contains no address") {
  CHECK_FALSE(networks("").contain(address("127.0.0.1")));
  CHECK(networks("  ").empty());
}

TEST_CASE("a list of networks that is wrong is one line that names the part") {
  for (const std::string wrong : {"10.0.0.0/33", "10.0.0.1/8", "10.0.0/8", "example.org", "::1/129",
                                  "10.0.0.0/", "10.0.0.0/+8", "10.0.0.0/8 1", "fe80::1%1"}) {
    CAPTURE(wrong);
    const auto parsed = Networks::parse("192.0.2.7, " + wrong);
    REQUIRE_FALSE(parsed.has_value());
    CHECK_THAT(parsed.error(), Catch::StartsWith("\"" + wrong + "\"") && Catch::Contains("10.0.0.0/8, "));
  }
  CHECK_FALSE(Networks::parse("10.0.0.0/8,").has_value());
}

TEST_CASE("a network of n bits contains exactly the addresses that share them") {
  const auto holds = rc::check([](std::uint32_t in, std::uint32_t other) {
    const unsigned bits = *rc::gen::inRange(0U, 33U);
    const std::uint32_t mask = bits == 0 ? 0 : ~std::uint32_t{0} << (32 - bits);
    const auto list =
        Networks::parse(fmt::format("{}/{}", asio::ip::address_v4{in & mask}.to_string(), bits));
    RC_ASSERT(list.has_value());
    RC_ASSERT(list->contain(asio::ip::address_v4{in}));
    RC_ASSERT(list->contain(asio::ip::address_v4{other}) == ((in & mask) == (other & mask)));
  });
  CHECK(holds);
}
