// How far a server is behind, and which of several servers has a wrong state.
#include <catch2/catch.hpp>

#include "cluster/log_end.h"
#include "cluster/message.h"
#include "cluster/state_comparison.h"

namespace talus::server::cluster {
namespace {

using namespace std::chrono_literals;
using Verdict = StateComparison::Verdict;

/// Of the first start of a server.
constexpr std::uint64_t of(std::uint32_t server, std::uint32_t start = 1) {
  return publisher_of(server, start);
}

constexpr edits::StateHash kRight{1, 1};
constexpr edits::StateHash kWrong{2, 2};

}  // namespace

TEST_CASE("a server is ready when it is within a second of the log's end, until it is ten behind") {
  LogEnd end;
  const LogEnd::TimePoint start{};
  CHECK_FALSE(end.is_ready());
  end.heard(100, start);
  CHECK_FALSE(end.is_ready());
  CHECK(end.lag() == 100);
  end.applied(50);
  end.heard(120, start + 5s);
  CHECK(end.behind() == 5s);
  end.applied(100);
  CHECK(end.behind() == 0s);  // since 5 s the leader has said nothing, and then this was the end
  CHECK(end.is_ready());
  end.heard(200, start + 6s);
  CHECK(end.is_ready());
  CHECK(end.behind() == 1s);
  end.heard(210, start + 15s);
  CHECK(end.is_ready());
  end.heard(220, start + 16s);
  CHECK_FALSE(end.is_ready());
  end.applied(210);  // what was the end a second before
  CHECK(end.is_ready());
  end.applied(220);
  CHECK(end.lag() == 0);
}

TEST_CASE("a server that loses contact with the leader stays ready, and one that never had it is not") {
  LogEnd end;
  end.applied(7);
  CHECK_FALSE(end.is_ready());
  end.heard(7, LogEnd::TimePoint{});
  CHECK(end.is_ready());
  end.applied(9);
  CHECK(end.is_ready());
}

TEST_CASE("a leader's silence does not count as time behind") {
  LogEnd end;
  const LogEnd::TimePoint start{};
  end.applied(7);
  end.heard(7, start);
  end.heard(8, start + 1s);
  end.heard(8, start + 2s);
  end.unanswered(start + 2s);
  end.unanswered(start + 32s);
  end.answered(start + 62s);
  end.heard(9, start + 62s);
  CHECK(end.behind() == 1s);
  CHECK(end.is_ready());
  end.heard(9, start + 72s);
  CHECK_FALSE(end.is_ready());
}

TEST_CASE("a leader that says nothing each second time hides no lag") {
  LogEnd end;
  const LogEnd::TimePoint start{};
  end.applied(7);
  end.heard(7, start);
  for (int i = 1; i <= 12; ++i) {
    const auto asked = start + i * 1s;
    end.unanswered(asked - 500ms);
    CHECK(end.silent_since() == asked - 500ms);
    end.answered(asked);
    CHECK_FALSE(end.silent_since());
    end.heard(8, asked);
    CHECK(end.behind() == (i - 1) * 1s);
    CHECK(end.is_ready() == (i <= 11));
  }
}

TEST_CASE("an end that the leader takes back is not waited for") {
  LogEnd end;
  const LogEnd::TimePoint start{};
  end.applied(7);
  end.heard(7, start);
  end.heard(5'000'000, start + 1s);
  end.heard(8, start + 2s);
  end.heard(8, start + 20s);
  CHECK_FALSE(end.is_ready());
  CHECK(end.lag() == 1);
  CHECK(end.behind() == 18s);
  end.applied(8);
  end.heard(8, start + 21s);
  CHECK(end.is_ready());
  CHECK(end.lag() == 0);
}

TEST_CASE("a server that is far behind for hours keeps few reports of the end") {
  LogEnd end;
  for (int i = 0; i < 10'000; ++i)
    end.heard(static_cast<std::uint64_t>(i) + 1, LogEnd::TimePoint{} + i * 500ms);
  CHECK(end.behind() == 9'999 * 500ms);
  end.applied(9'990);
  CHECK(end.behind() <= 600s);
  end.applied(10'000);
  CHECK(end.is_ready());
}

TEST_CASE("an equal state has no effect, and a forgotten one is not compared") {
  StateComparison own{of(1)};
  const StateComparison::TimePoint now{};
  CHECK_FALSE(own.heard({of(2), 5, kWrong}, now).has_value());
  own.stands(5, kRight);
  own.stands(7, kRight);
  CHECK_FALSE(own.heard({of(2), 5, kRight}, now).has_value());
  CHECK_FALSE(own.heard({of(2), 4, kWrong}, now).has_value());
  CHECK(own.judge(now + 10s) == Verdict::same);
}

TEST_CASE("a server at a revision that this server never had, inside a message, has another state") {
  const StateComparison::TimePoint now{};
  StateComparison own{of(1)};
  own.stands(5, kRight);
  own.stands(7, {4, 4});
  // Between two, and beyond the last.
  const std::uint64_t revision = GENERATE(6, 900);
  const auto say = own.heard({of(2), revision, kRight}, now);
  REQUIRE(say.has_value());
  CHECK(say->revision == 7);  // where it stands itself
  CHECK(say->hash == edits::StateHash{4, 4});
  CHECK(own.what().find(std::to_string(revision)) != std::string::npos);
  CHECK(own.judge(now + 2s) == Verdict::undecided);
  SECTION("than a third") {
    CHECK_FALSE(own.heard({of(3), 7, {4, 4}}, now + 3s).has_value());
    CHECK(own.judge(now + 3s) == Verdict::same);
  }
  SECTION("and so has a third") {
    CHECK_FALSE(own.heard({of(3), revision, kWrong}, now + 3s).has_value());
    CHECK(own.judge(now + 3s) == Verdict::wrong);
  }
}

TEST_CASE("one of three servers with another state is wrong") {
  const StateComparison::TimePoint now{};
  const auto verdict = [&](std::uint32_t self, edits::StateHash hash) {
    StateComparison own{of(self)};
    own.stands(5, hash);
    // What is in the log: 3 is wrong and says so first, then all that hear of it.
    bool says = false;
    for (const StateComparison::Claim claim : {StateComparison::Claim{of(3), 5, kWrong},
                                               {of(1), 5, kRight},
                                               {of(2), 5, kRight},
                                               {of(3), 5, kWrong}}) {
      const auto say = own.heard(claim, now);
      if (say) {
        CHECK(say->publisher == of(self));
        CHECK(say->revision == 5);
        CHECK(say->hash == hash);
        CHECK_FALSE(says);
        says = true;
      }
    }
    CHECK(says);
    CHECK(own.judge(now + 1s) == Verdict::voting);
    const Verdict after = own.judge(now + 2s);
    // It stays so, and who is known to be wrong makes no further trouble.
    CHECK_FALSE(own.heard({of(3), 5, kWrong}, now + 3s).has_value());
    CHECK(own.judge(now + 3s) == after);
    return after;
  };
  CHECK(verdict(1, kRight) == Verdict::same);
  CHECK(verdict(2, kRight) == Verdict::same);
  CHECK(verdict(3, kWrong) == Verdict::wrong);
}

TEST_CASE("two that say otherwise wait for a third, whichever revision it speaks of") {
  const StateComparison::TimePoint now{};
  StateComparison own{of(1)};
  own.stands(5, kRight);
  own.stands(8, {4, 4});
  REQUIRE(own.heard({of(2), 5, kWrong}, now).has_value());
  CHECK(own.judge(now + 5s) == Verdict::undecided);
  CHECK(own.what().find("revision 5") != std::string::npos);
  SECTION("that has the same later") {
    CHECK_FALSE(own.heard({of(3), 8, {4, 4}}, now + 6s).has_value());
    CHECK(own.judge(now + 6s) == Verdict::same);
  }
  SECTION("that had the other") {
    CHECK_FALSE(own.heard({of(3), 5, kWrong}, now + 6s).has_value());
    CHECK(own.judge(now + 6s) == Verdict::wrong);
  }
  SECTION("that has a third state") {
    CHECK_FALSE(own.heard({of(3), 5, {9, 9}}, now + 6s).has_value());
    CHECK(own.judge(now + 6s) == Verdict::undecided);
  }
}

TEST_CASE("a server that is wrong and starts again has no second vote") {
  const StateComparison::TimePoint now{};
  StateComparison own{of(1)};
  own.stands(5, kRight);
  REQUIRE(own.heard({of(3, 1), 5, kWrong}, now).has_value());
  CHECK_FALSE(own.heard({of(3, 2), 5, kWrong}, now).has_value());
  CHECK_FALSE(own.heard({of(3, 3), 5, kWrong}, now).has_value());
  SECTION("against another that is right") {
    CHECK_FALSE(own.heard({of(2), 5, kRight}, now).has_value());
    CHECK(own.judge(now + 2s) == Verdict::same);
  }
  SECTION("and of two servers neither is out") {
    CHECK(own.judge(now + 2s) == Verdict::undecided);
  }
  SECTION("and one that has taken another store since is right again") {
    CHECK_FALSE(own.heard({of(3, 4), 5, kRight}, now + 3s).has_value());
    CHECK(own.judge(now + 3s) == Verdict::same);
  }
}

TEST_CASE("a server that is wrong and undecided finds it out by what others say later") {
  const StateComparison::TimePoint now{};
  StateComparison own{of(1)};
  own.stands(5, kWrong);
  own.stands(8, {kWrong.low + 10, kWrong.high + 20});
  REQUIRE(own.heard({of(2), 5, kRight}, now).has_value());
  CHECK(own.judge(now + 2s) == Verdict::undecided);
  CHECK_FALSE(own.heard({of(3), 8, {kRight.low + 10, kRight.high + 20}}, now + 3s).has_value());
  CHECK(own.judge(now + 3s) == Verdict::wrong);
}

}  // namespace talus::server::cluster
