#include "net/watchdog.h"

#include <catch2/catch.hpp>

using namespace talus::server;
using namespace std::chrono_literals;
using Verdict = Watchdog::Verdict;

namespace {

const SessionTimeouts kTimeouts{10s, 60s, 15s};
const Clock::time_point kStart = Clock::time_point{} + 1h;

/// Whether nothing is wrong until `at`, which is when it is to be looked at again, and then it is `verdict`.
void check_ends(const Watchdog& dog, Clock::time_point now, Clock::time_point at, Verdict verdict) {
  CHECK(dog.check(now) == Verdict::wait);
  CHECK(dog.next(now) <= at);
  CHECK(dog.check(at - 1ns) == Verdict::wait);
  CHECK(dog.check(at) == verdict);
}

}  // namespace

TEST_CASE("a Hello that does not come in time is silence") {
  Watchdog dog{kTimeouts, kStart};
  check_ends(dog, kStart, kStart + 10s, Verdict::silent);
  dog.frame_came(kStart + 9s);  // that was no Hello
  check_ends(dog, kStart + 9s, kStart + 10s, Verdict::silent);
}

TEST_CASE("after Hello each frame begins the idle time anew") {
  Watchdog dog{kTimeouts, kStart};
  dog.greeted();
  dog.frame_came(kStart + 30s);
  check_ends(dog, kStart + 30s, kStart + 90s, Verdict::silent);
}

TEST_CASE("a client that has promised to send no more is not idle") {
  Watchdog dog{kTimeouts, kStart};
  dog.greeted();
  dog.expects_no_more();
  CHECK(dog.check(kStart + 1h) == Verdict::wait);
}

TEST_CASE("a write in flight without progress stalls, and any progress begins its time anew") {
  Watchdog dog{kTimeouts, kStart};
  dog.greeted();
  dog.writing(kStart);
  check_ends(dog, kStart, kStart + 15s, Verdict::write_stalled);
  dog.writing(kStart + 14s);
  check_ends(dog, kStart + 14s, kStart + 29s, Verdict::write_stalled);
  dog.written();
  CHECK(dog.check(kStart + 29s) == Verdict::wait);
}

TEST_CASE("a token's end comes before the idle time's") {
  Watchdog dog{kTimeouts, kStart};
  dog.greeted();
  dog.token_ends(kStart + 5s);
  check_ends(dog, kStart, kStart + 5s, Verdict::token_expired);
}

TEST_CASE("a session that closes has two seconds, whatever else is over") {
  Watchdog dog{kTimeouts, kStart};
  dog.token_ends(kStart + 1s);
  CHECK(dog.closes(kStart));
  CHECK_FALSE(dog.closes(kStart + 1s));
  check_ends(dog, kStart, kStart + 2s, Verdict::closed);
}

TEST_CASE("a token lasts for the clocks' difference longer, and at most a century") {
  const std::chrono::sys_seconds now{1'700'000'000s};
  CHECK(token_lifetime(now + 100s, now) == 130s);
  CHECK(token_lifetime(now - 1h, now) == 0s);
  CHECK(token_lifetime(std::chrono::sys_seconds::max(), now) == 36'525 * 24h + 30s);
}
