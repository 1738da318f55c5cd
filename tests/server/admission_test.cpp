#include "net/admission.h"

#include <catch2/catch.hpp>

using namespace talus::server;

TEST_CASE("an IPv6 address counts as its /64 network") {
  CHECK(counted_as(asio::ip::make_address("2001:db8:1:2:3:4:5:6")) ==
        asio::ip::make_address("2001:db8:1:2::"));
}

TEST_CASE("an IPv4 address counts as itself, also mapped into IPv6") {
  const auto address = asio::ip::make_address("192.0.2.7");
  CHECK(counted_as(address) == address);
  CHECK(counted_as(asio::ip::make_address("::ffff:192.0.2.7")) == address);
}

TEST_CASE("places run out and come back, in all and for each address") {
  Admission admission{3, 2};
  const auto here = asio::ip::make_address("192.0.2.1");
  const auto there = asio::ip::make_address("192.0.2.2");
  auto first = admission.enter(here);
  auto second = admission.enter(here);
  REQUIRE(first.has_value());
  REQUIRE(second.has_value());
  CHECK_FALSE(admission.enter(here).has_value());
  {
    const auto third = admission.enter(there);
    CHECK(third.has_value());
    CHECK_FALSE(admission.enter(there).has_value());
  }
  CHECK(admission.connections() == 2);
  { const Admission::Place given_back = *std::move(first); }
  CHECK(admission.enter(here).has_value());
}

TEST_CASE("connections of one address share its rates, also over a time without any") {
  Admission admission{10, 10, std::chrono::hours{1}};
  const auto address = asio::ip::make_address("192.0.2.1");
  AddressBucketsPtr rates;
  {
    const auto first = admission.enter(address);
    const auto second = admission.enter(address);
    rates = first->rates();
    CHECK(second->rates() == rates);
  }
  CHECK(admission.enter(address)->rates() == rates);
  CHECK(admission.enter(asio::ip::make_address("192.0.2.2"))->rates() != rates);
}

TEST_CASE("addresses that left are forgotten when their time is over") {
  Admission admission{10, 10};
  { const auto place = admission.enter(asio::ip::make_address("192.0.2.1")); }
  CHECK(admission.addresses() == 0);
}

TEST_CASE("however many addresses come and go, few are remembered") {
  Admission admission{10, 10, std::chrono::hours{1}};
  const auto here = admission.enter(asio::ip::make_address("192.0.2.1"));
  for (std::uint32_t address = 0; address < 3 * Admission::kMostRemembered; ++address) {
    (void)admission.enter(asio::ip::address_v4{address});
  }
  CHECK(admission.addresses() <= Admission::kMostRemembered + 1);
  CHECK(admission.enter(asio::ip::make_address("192.0.2.1"))->rates() == here->rates());
}
