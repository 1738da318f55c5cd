#include "net/admission.h"

#include <catch2/catch.hpp>

#include "runtime/manual_clock.h"

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

TEST_CASE("slots run out and come back, in all and for each address") {
  const ManualClock clock;
  Admission admission{{3, 2}, clock};
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
  { const Admission::Slot given_back = *std::move(first); }
  CHECK(admission.enter(here).has_value());
}

TEST_CASE("an IPv4 address shares its slots and rates with itself mapped into IPv6") {
  const ManualClock clock;
  Admission admission{{10, 2}, clock};
  const auto address = asio::ip::make_address("192.0.2.1");
  const auto mapped = asio::ip::make_address("::ffff:192.0.2.1");
  const auto first = admission.enter(address);
  const auto second = admission.enter(mapped);
  REQUIRE(second.has_value());
  CHECK(first->rates() == second->rates());
  CHECK_FALSE(admission.enter(address).has_value());
  CHECK_FALSE(admission.enter(mapped).has_value());
}

TEST_CASE("connections of one address share its rates, also over a time without any") {
  ManualClock clock;
  Admission admission{{10, 10, std::chrono::hours{1}}, clock};
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

TEST_CASE("changed limits count for new connections, and rates for all") {
  ManualClock clock;
  Admission admission{{2, 2, std::chrono::hours{1}, {{}, {}, {1, 10}}}, clock};
  const auto here = asio::ip::make_address("192.0.2.1");
  const auto first = admission.enter(here);
  const AddressBucketsPtr before = first->rates();
  auto second = admission.enter(here);
  CHECK_FALSE(admission.enter(asio::ip::make_address("192.0.2.2")).has_value());

  const RateSet lower{{}, {}, {1, 3}};
  admission.change({3, 1, std::chrono::hours{1}, lower});
  CHECK(first->rates() != before);
  CHECK(first->rates() == second->rates());
  CHECK(first->rates()->rates == lower);
  CHECK(admission.connections() == 2);
  CHECK_FALSE(admission.enter(here).has_value());
  CHECK(admission.enter(asio::ip::make_address("192.0.2.2"))->rates()->rates == lower);

  const AddressBucketsPtr same = first->rates();
  admission.change({3, 1, std::chrono::hours{1}, lower});
  CHECK(first->rates() == same);
}

TEST_CASE("addresses that left are forgotten when their time is over") {
  ManualClock clock;
  Admission admission{{10, 10, std::chrono::hours{1}}, clock};
  const auto other = asio::ip::make_address("192.0.2.2");
  { const auto slot = admission.enter(asio::ip::make_address("192.0.2.1")); }
  { const auto slot = admission.enter(other); }
  CHECK(admission.addresses() == 2);
  clock.advance(std::chrono::hours{1});
  { const auto slot = admission.enter(other); }
  CHECK(admission.addresses() == 1);
}

TEST_CASE("an address that made editors is remembered until it has saved them up again") {
  ManualClock clock;
  RateSet rates;
  rates.editors = {1, 2 * kEditorTokens};  // one an hour
  Admission admission{{10, 10, std::chrono::seconds{32}, rates}, clock};
  const auto address = asio::ip::make_address("192.0.2.1");
  const auto made = [&] {
    const auto slot = admission.enter(address);
    SessionRates session{{{}, rates, {}}, slot->rates(), 1};
    int editors = 0;
    while (!session.refuse_editor(clock.now())) ++editors;
    return editors;
  };
  CHECK(made() == 2);
  clock.advance(std::chrono::minutes{61});
  CHECK(made() == 1);
  clock.advance(std::chrono::hours{3});
  CHECK(made() == 2);
}

TEST_CASE("an address that took new land is remembered until it has saved that up again") {
  ManualClock clock;
  RateSet rates;
  rates.new_chunks = {1, 2 * kNewChunkTokens};  // one an hour
  Admission admission{{10, 10, std::chrono::seconds{32}, rates}, clock};
  const auto edited = [&] {
    const auto slot = admission.enter(asio::ip::make_address("192.0.2.1"));
    SessionRates session{{{}, rates, {}}, slot->rates(), 1};
    int chunks = 0;
    while (!session.refuse_edit(clock.now(), {1, 1})) ++chunks;
    return chunks;
  };
  CHECK(edited() == 2);
  clock.advance(std::chrono::minutes{61});
  CHECK(edited() == 1);
}

TEST_CASE("few addresses are remembered, however many come and go") {
  ManualClock clock;
  Admission admission{{10, 10, std::chrono::hours{1}}, clock};
  const auto here = admission.enter(asio::ip::make_address("192.0.2.1"));
  for (std::uint32_t address = 0; address < 3 * Admission::kMaxRemembered; ++address) {
    (void)admission.enter(asio::ip::address_v4{address});
  }
  CHECK(admission.addresses() <= Admission::kMaxRemembered + 1);
  CHECK(admission.enter(asio::ip::make_address("192.0.2.1"))->rates() == here->rates());
}
