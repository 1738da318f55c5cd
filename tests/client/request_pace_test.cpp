#include "request_pace.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

namespace talus::client {
namespace {

using std::chrono::milliseconds;
using Time = RequestPace::Time;

const Time kStart{std::chrono::hours{1}};

ServerLimits limits_of(std::uint64_t session, std::uint64_t address, milliseconds burst) {
  ServerLimits limits;
  limits.session_rates = Rates{0, 0, session, burst};
  limits.address_rates = Rates{0, 0, address, burst};
  return limits;
}

int taken(RequestPace& pace, Time now) {
  int count = 0;
  while (count < 10'000 && pace.take(now)) ++count;
  return count;
}

}  // namespace

TEST_CASE("without a rate requests are sent at once, also if the server announces no rate") {
  RequestPace unlimited{limits_of(0, 0, milliseconds{1'000}), kStart};
  CHECK(taken(unlimited, kStart) == 10'000);
  RequestPace untold{ServerLimits{}, kStart};
  CHECK(taken(untold, kStart) == 10'000);
}

TEST_CASE("seven eighths of a burst go at once, then the rate, the lower of the two") {
  RequestPace pace{limits_of(400, 100, milliseconds{2'000}), kStart};
  CHECK(taken(pace, kStart) == 175);
  CHECK(pace.next(kStart) == kStart + milliseconds{10});
  CHECK(taken(pace, kStart + milliseconds{250}) == 25);
  CHECK(taken(pace, kStart + std::chrono::hours{1}) == 175);
}

TEST_CASE("a bucket of less than one request still grants one at a time") {
  RequestPace pace{limits_of(1, 0, milliseconds{100}), kStart};
  CHECK(taken(pace, kStart) == 1);
  CHECK(taken(pace, kStart + milliseconds{999}) == 0);
  CHECK(taken(pace, kStart + milliseconds{1'000}) == 1);
}

TEST_CASE("after a refusal nothing is sent until the given time, then the refused requests") {
  const std::uint64_t rate = GENERATE(0U, 1'000U);
  RequestPace pace{limits_of(rate, 0, milliseconds{2'000}), kStart};
  for (int i = 0; i < 3; ++i) pace.refused(kStart, milliseconds{500 + i});
  CHECK(taken(pace, kStart + milliseconds{501}) == 0);
  CHECK(pace.next(kStart) == kStart + milliseconds{502});
  CHECK(taken(pace, kStart + milliseconds{502}) == (rate == 0 ? 10'000 : 3));
}

TEST_CASE("no wait that a server asks for is without end") {
  RequestPace pace;
  pace.refused(kStart, milliseconds{4'294'967'295});
  CHECK(taken(pace, kStart + std::chrono::minutes{1}) > 0);
}

TEST_CASE("requests spent beyond the pace are paid back before more are sent") {
  RequestPace pace{limits_of(10, 0, milliseconds{1'000}), kStart};
  for (int i = 0; i < 18; ++i) pace.spend(kStart);  // 8.75 were there
  CHECK(taken(pace, kStart + milliseconds{1'000}) == 0);
  CHECK(taken(pace, kStart + milliseconds{1'100}) == 1);
}

TEST_CASE("a server with the same rate grants all, though the network delays and bunches requests") {
  const bool held = rc::check("granted", [] {
    constexpr double kRate = 100;
    constexpr double kBurst = 200;
    RequestPace pace{limits_of(100, 0, milliseconds{2'000}), kStart};
    double level = kBurst;
    double filled = 0;  // seconds
    double arrival = 0;
    Time now = kStart;
    for (int step = 0; step < 200; ++step) {
      now += milliseconds{*rc::gen::inRange(0, 60)};
      // Up to 250 ms late, and never before those sent earlier: 25 requests, an eighth of the burst.
      const double late = *rc::gen::inRange(0, 250) / 1000.0;
      arrival = std::max(arrival, std::chrono::duration<double>(now - kStart).count() + late);
      level = std::min(kBurst, level + (arrival - filled) * kRate);
      filled = arrival;
      level -= taken(pace, now);
      RC_ASSERT(level >= -1e-6);
    }
  });
  REQUIRE(held);
}

}  // namespace talus::client
