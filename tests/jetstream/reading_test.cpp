// Which messages are given out and asked for, without a network.
#include <algorithm>
#include <random>
#include <set>
#include <string>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "cluster/jetstream/reading.h"
#include "opened_stream.h"

using talus::nats_test::bytes_of;
using talus::nats_test::text_of;
using talus::server::jetstream::Reading;
using namespace std::chrono_literals;

namespace {

using TimePoint = Reading::TimePoint;
using Sequences = std::vector<std::uint64_t>;

std::string true_text(std::uint64_t sequence) {
  return "message " + std::to_string(sequence);
}

void hear(Reading& reading, std::uint64_t sequence, TimePoint now) {
  reading.heard(sequence, bytes_of(true_text(sequence)), now);
}
void answer(Reading& reading, std::uint64_t sequence, TimePoint now) {
  reading.answered(sequence, bytes_of(true_text(sequence)), now);
}

std::uint64_t taken(Reading& reading) {
  const auto message = reading.take();
  if (!message) return 0;
  CHECK(text_of(message->bytes) == true_text(message->sequence));
  return message->sequence;
}

const TimePoint kStart{1h};

}  // namespace

TEST_CASE("messages of the tail are given out in order, and nothing is asked for") {
  Reading reading{kStart, 7};
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    hear(reading, sequence, kStart);
    CHECK(reading.wanted(kStart).empty());
    CHECK(taken(reading) == sequence);
  }
  CHECK(taken(reading) == 0);
  CHECK(reading.gaps() == 0);
}

TEST_CASE("an answer is waited for until it comes, or what it would bring has come by itself") {
  Reading reading{kStart, 7};
  CHECK_FALSE(reading.asks());
  hear(reading, 3, kStart);
  CHECK(reading.learned(3, kStart));
  CHECK(reading.wanted(kStart) == Sequences{1, 2});
  CHECK(reading.asks());
  answer(reading, 1, kStart);
  CHECK(reading.asks());
  hear(reading, 2, kStart);
  while (taken(reading) != 0) {
  }
  CHECK_FALSE(reading.asks());
  CHECK(reading.wanted(kStart + Reading::kSilence) == Sequences{4});
  CHECK(reading.asks());
  reading.not_found(4, kStart + Reading::kSilence);
  CHECK_FALSE(reading.asks());
}

TEST_CASE("a message in a gap of the tail is requested at once, and once") {
  Reading reading{kStart, 7};
  hear(reading, 4, kStart);
  CHECK(reading.claims_more());
  CHECK(reading.wanted(kStart) == Sequences{1});
  CHECK(reading.wanted(kStart).empty());
  CHECK(reading.gaps() == 1);
  SECTION("all of it once the leader says how far the stream goes") {
    CHECK(reading.learned(4, kStart));
    CHECK_FALSE(reading.claims_more());
    CHECK(reading.wanted(kStart) == Sequences{2, 3});
    CHECK(reading.wanted(kStart).empty());
    answer(reading, 2, kStart);
    CHECK(taken(reading) == 0);
    answer(reading, 1, kStart);
    answer(reading, 3, kStart);
  }
  SECTION("twice as many as were there before that") {
    answer(reading, 1, kStart);
    CHECK(taken(reading) == 1);
    CHECK(reading.wanted(kStart) == Sequences{2, 3});
    answer(reading, 2, kStart);
    answer(reading, 3, kStart);
    for (std::uint64_t sequence = 2; sequence <= 4; ++sequence) CHECK(taken(reading) == sequence);
    CHECK_FALSE(reading.claims_more());
    return;
  }
  for (std::uint64_t sequence = 1; sequence <= 4; ++sequence) CHECK(taken(reading) == sequence);
}

TEST_CASE("a request without an answer is made again") {
  Reading reading{kStart, 7};
  hear(reading, 2, kStart);
  CHECK(reading.wanted(kStart) == Sequences{1});
  CHECK(reading.next_poll() == kStart + Reading::kAnswerIn);
  CHECK(reading.wanted(kStart + Reading::kAnswerIn) == Sequences{1});
}

TEST_CASE("after a second of silence the next message is asked for, once a second") {
  Reading reading{kStart, 7};
  CHECK(reading.next_poll() == kStart + 1s);
  CHECK(reading.wanted(kStart + 999ms).empty());
  CHECK(reading.wanted(kStart + 1s) == Sequences{1});
  reading.not_found(1, kStart + 1s);
  CHECK(reading.wanted(kStart + 1999ms).empty());
  CHECK(reading.wanted(kStart + 2s) == Sequences{1});
  answer(reading, 1, kStart + 2s);
  CHECK(taken(reading) == 1);
}

TEST_CASE("a lagging replica is asked again soon, then less and less often") {
  Reading reading{kStart, 7};
  reading.learned(1, kStart);
  CHECK(reading.wanted(kStart).empty());
  CHECK(reading.next_poll() == kStart + Reading::kOnItsWay);
  auto now = kStart + Reading::kOnItsWay;
  auto pause = Reading::kFirstRetry;
  for (int i = 0; i < 10; ++i) {
    REQUIRE(reading.wanted(now) == Sequences{1});
    reading.not_found(1, now);
    CHECK(reading.wanted(now + pause - 1ms).empty());
    CHECK(reading.next_poll() == now + pause);
    now += pause;
    pause = std::min(pause * 2, Reading::kLastRetry);
  }
  answer(reading, 1, now);
  CHECK(taken(reading) == 1);
}

TEST_CASE("requests that are sent together and not found make one pause") {
  Reading reading{kStart, 7};
  reading.learned(1000, kStart);
  auto now = kStart + Reading::kOnItsWay;
  auto pause = Reading::kFirstRetry;
  for (int i = 0; i < 4; ++i) {
    const auto wanted = reading.wanted(now);
    CHECK(wanted.size() == Reading::kMaxRequests);
    for (const auto sequence : wanted) reading.not_found(sequence, now);
    CHECK(reading.next_poll() == now + pause);
    now += pause;
    pause *= 2;
  }
}

TEST_CASE("the next message is requested for a number that the tail claims, until the leader denies it") {
  Reading reading{kStart, 7};
  reading.heard(1'000'000'000'000, bytes_of("false"), kStart);
  auto now = kStart;
  auto pause = Reading::kFirstRetry;
  for (int i = 0; i < 8; ++i) {
    REQUIRE(reading.wanted(now) == Sequences{1});
    reading.not_found(1, now);
    CHECK(reading.wanted(now + pause - 1ms).empty());
    CHECK(reading.next_poll() == now + pause);
    now += pause;
    pause = std::min(pause * 2, Reading::kLastRetry);
  }
  CHECK(reading.claims_more());
  reading.ends_at(0);
  CHECK_FALSE(reading.claims_more());
  CHECK(reading.wanted(now).empty());
  hear(reading, 1, now);
  CHECK(taken(reading) == 1);
}

TEST_CASE("a number that the stream never had is not asked for, though two messages had it") {
  Reading reading{kStart, 7};
  constexpr std::uint64_t kNever = 1'000'000'000'000;
  reading.heard(kNever, bytes_of("false"), kStart);
  reading.heard(kNever, bytes_of("false, too"), kStart);
  auto now = kStart;
  for (int i = 0; i < 8; ++i) {
    for (const auto sequence : reading.wanted(now)) reading.not_found(sequence, now);
    now += Reading::kLastRetry;
  }
  reading.ends_at(0);
  const auto wanted = reading.wanted(now);
  CHECK(std::ranges::find(wanted, kNever) == wanted.end());
}

TEST_CASE("two messages of one number are held against the stream") {
  Reading reading{kStart, 7};
  SECTION("before one was given out, only the stream's is") {
    reading.heard(1, bytes_of("false"), kStart);
    hear(reading, 1, kStart);
    CHECK(taken(reading) == 0);
    CHECK(reading.wanted(kStart) == Sequences{1});
    answer(reading, 1, kStart);
    CHECK(taken(reading) == 1);
    CHECK_FALSE(reading.forged());
    CHECK(reading.false_messages() == 1);
  }
  SECTION("the false one after the true one does no harm") {
    hear(reading, 1, kStart);
    CHECK(taken(reading) == 1);
    reading.heard(1, bytes_of("false"), kStart);
    CHECK(reading.wanted(kStart) == Sequences{1});
    answer(reading, 1, kStart);
    CHECK_FALSE(reading.forged());
    CHECK(reading.false_messages() == 1);
  }
  SECTION("the false one given out is found by the true one") {
    reading.heard(1, bytes_of("false"), kStart);
    REQUIRE(reading.take());
    hear(reading, 1, kStart);
    CHECK(reading.wanted(kStart) == Sequences{1});
    answer(reading, 1, kStart);
    REQUIRE(reading.forged());
    CHECK(*reading.forged() == 1);
  }
  SECTION("the false one after the stream's own answer needs no asking") {
    answer(reading, 1, kStart);
    CHECK(taken(reading) == 1);
    reading.heard(1, bytes_of("false"), kStart);
    CHECK(reading.wanted(kStart).empty());
    CHECK(reading.false_messages() == 1);
  }
  SECTION("the same message again is nothing") {
    hear(reading, 1, kStart);
    hear(reading, 1, kStart);
    CHECK(taken(reading) == 1);
    hear(reading, 1, kStart);
    CHECK(reading.wanted(kStart).empty());
    CHECK(reading.false_messages() == 0);
  }
}

TEST_CASE("an invalid message is delivered again as the leader has it") {
  Reading reading{kStart, 7};
  reading.heard(1, bytes_of("damaged"), kStart);
  auto message = reading.take();
  REQUIRE(message);
  CHECK_FALSE(message->of_leader);
  reading.ask_again(kStart);
  CHECK(reading.after() == 0);
  reading.heard(1, bytes_of("damaged too"), kStart);
  CHECK_FALSE(reading.take());
  CHECK(reading.next_poll() <= kStart);
  CHECK(reading.wanted(kStart) == Sequences{1});
  SECTION("which has another") {
    answer(reading, 1, kStart);
    CHECK(reading.false_messages() == 1);
    message = reading.take();
    REQUIRE(message);
    CHECK(message->of_leader);
    CHECK(text_of(message->bytes) == true_text(1));
    // That is what it is, whatever comes or is thought of it.
    reading.ask_again(kStart);
    CHECK(reading.after() == 1);
    hear(reading, 2, kStart);
    CHECK(taken(reading) == 2);
    CHECK_FALSE(reading.forged());
  }
  SECTION("which has the same") {
    reading.answered(1, bytes_of("damaged"), kStart);
    message = reading.take();
    REQUIRE(message);
    CHECK(message->of_leader);
    CHECK(reading.false_messages() == 0);
  }
  SECTION("which has it when the tail has another") {
    auto now = kStart;
    for (int i = 0; i < 8; ++i) {
      reading.not_found(1, now);
      now = reading.next_poll();
      REQUIRE(reading.wanted(now) == Sequences{1});
    }
    reading.not_found(1, now);
    reading.heard(1, bytes_of("damaged"), now);  // which says nothing
    CHECK(reading.next_poll() == now + Reading::kLastRetry);
    hear(reading, 1, now);
    CHECK(reading.next_poll() == now + Reading::kDisputed);
    CHECK(reading.wanted(now + Reading::kDisputed - 1ms).empty());
    CHECK(reading.wanted(now + Reading::kDisputed) == Sequences{1});
    answer(reading, 1, now);
    CHECK(taken(reading) == 1);
  }
  SECTION("which is still empty") {
    for (int i = 0; i < 8; ++i) {
      reading.not_found(1, kStart + i * 1s);
      CHECK(reading.wanted(kStart + i * 1s + 500ms) == Sequences{1});
    }
    reading.ends_at(0);
    CHECK(reading.false_messages() == 1);
    hear(reading, 1, kStart + 9s);
    CHECK(taken(reading) == 1);
  }
}

TEST_CASE("which of two messages was the stream's is not asked after it keeps neither") {
  Reading reading{kStart, 7};
  hear(reading, 1, kStart);
  CHECK(taken(reading) == 1);
  reading.heard(1, bytes_of("false"), kStart);
  CHECK(reading.wanted(kStart) == Sequences{1});
  reading.not_found(1, kStart);
  reading.starts_at(1);
  CHECK(reading.wanted(kStart + 400ms) == Sequences{1});
  reading.not_found(1, kStart + 400ms);
  reading.starts_at(2);
  CHECK(reading.wanted(kStart + 900ms).empty());
}

TEST_CASE("the number of messages kept ahead is bounded, and the next message has room") {
  Reading reading{kStart, 7};
  const std::string large(1U << 20U, 'x');
  for (std::uint64_t sequence = 2; sequence <= 100; ++sequence) {
    reading.heard(sequence, bytes_of(large), kStart);
  }
  reading.heard(1, bytes_of(large), kStart);
  std::uint64_t kept = 0;
  while (reading.take()) ++kept;
  CHECK(kept == Reading::kWindowBytes >> 20U);
  reading.heard(kept + 2 + Reading::kWindow, bytes_of("far"), kStart);
  CHECK_FALSE(reading.wanted(kStart).empty());
}

TEST_CASE("lost, late or doubled messages are all delivered once, in order") {
  const bool held = rc::check([](std::uint32_t seed) {
    std::mt19937 random{seed};
    const auto below = [&](std::uint64_t bound) { return std::uint64_t{random()} % bound; };
    const std::uint64_t last = 1 + below(200);
    Reading reading{kStart, 7};
    auto now = kStart;
    std::uint64_t published = 0;
    std::uint64_t given = 0;
    std::set<std::uint64_t> asked;
    for (int i = 0; i < 20'000 && given < last; ++i) {
      for (const auto sequence : reading.wanted(now)) asked.insert(sequence);
      now += std::chrono::milliseconds{below(300)};
      if (published < last && below(2) == 0) {
        ++published;
        const auto luck = below(4);  // lost in 1 of 4
        if (luck > 0) hear(reading, published, now);
        if (luck == 3) hear(reading, published, now);
      }
      if (published > 0 && below(4) == 0) hear(reading, 1 + below(published), now);
      if (!asked.empty()) {
        const auto sequence = *asked.begin();
        asked.erase(asked.begin());
        const auto luck = below(4);
        if (luck > 1 && sequence <= published) answer(reading, sequence, now);
        if (luck == 1) reading.not_found(sequence, now);
      }
      while (const auto message = reading.take()) {
        RC_ASSERT(message->sequence == given + 1);
        RC_ASSERT(text_of(message->bytes) == true_text(message->sequence));
        ++given;
      }
    }
    RC_ASSERT(given == last);
    RC_ASSERT(!reading.forged());
  });
  CHECK(held);
}

TEST_CASE("whatever numbers a false publisher sends, requests stay few and all true messages are delivered") {
  const bool held = rc::check([](std::uint32_t seed) {
    std::mt19937 random{seed};
    const auto below = [&](std::uint64_t bound) { return std::uint64_t{random()} % bound; };
    const auto forged_each_ms = 1 + below(20);
    const auto ahead = 1 + below(2000);
    const auto texts = 1 + below(1000);
    const auto between = std::chrono::milliseconds{5 + below(200)};
    constexpr std::uint64_t kLast = 40;
    Reading reading{kStart, 7};
    std::uint64_t published = 0;
    std::uint64_t given = 0;
    std::size_t questions = 0;
    std::vector<std::uint64_t> asked;
    auto now = kStart;
    auto publish_at = kStart;
    auto asked_end_at = kStart;
    auto ends = kStart + 10min;
    for (; given < kLast && now < ends; now += 1ms) {
      // The leader's answers take a millisecond.
      for (const auto sequence : asked) {
        if (sequence <= published) {
          answer(reading, sequence, now);
        } else {
          reading.not_found(sequence, now);
        }
      }
      if (published < kLast && now >= publish_at) {
        hear(reading, ++published, now);
        publish_at = now + between;
      }
      for (std::uint64_t i = 0; i < forged_each_ms; ++i) {
        reading.heard(given + 1 + below(ahead), bytes_of("false " + std::to_string(below(texts))), now);
      }
      while (const auto message = reading.take()) {
        if (!message->of_leader && text_of(message->bytes) != true_text(message->sequence)) {
          reading.ask_again(now);
          break;
        }
        RC_ASSERT(text_of(message->bytes) == true_text(message->sequence));
        RC_ASSERT(message->sequence == ++given);
      }
      asked = reading.wanted(now);
      questions += asked.size();
      if ((reading.claims_more() && now >= asked_end_at + 100ms) || now >= asked_end_at + 1s) {
        asked_end_at = now;
        reading.learned(published, now);
        reading.ends_at(published);
      }
    }
    RC_ASSERT(given == kLast);
    RC_ASSERT(!reading.forged());
    // A few for each message, and one each kDisputed.
    RC_ASSERT(questions <= 12 * kLast + static_cast<std::size_t>((now - kStart) / Reading::kDisputed));
  });
  CHECK(held);
}

TEST_CASE("a reader far behind sends ever more requests at once if no leader reports the distance") {
  constexpr std::uint64_t kLast = 10'000;
  Reading reading{kStart, 7};
  hear(reading, kLast, kStart);
  std::size_t rounds = 0;
  while (reading.after() < kLast) {
    const auto wanted = reading.wanted(kStart);
    REQUIRE_FALSE(wanted.empty());
    REQUIRE(wanted.size() <= Reading::kMaxRequests);
    for (const std::uint64_t sequence : wanted) answer(reading, sequence, kStart);
    while (reading.take()) continue;
    ++rounds;
  }
  CHECK(rounds <= kLast / Reading::kMaxRequests + 8);
  // The first that is not there ends it.
  hear(reading, kLast + 1000, kStart);
  const auto wanted = reading.wanted(kStart);
  CHECK(wanted.size() == Reading::kMaxRequests);
  for (const std::uint64_t sequence : wanted) reading.not_found(sequence, kStart);
  CHECK(reading.wanted(kStart + 1s) == Sequences{kLast + 1});
}

TEST_CASE("a reader far behind sends many requests at once, whatever the tail claims") {
  Reading reading{kStart, 7};
  constexpr std::uint64_t kLast = 5000;
  auto now = kStart;
  reading.learned(kLast, now);
  now += Reading::kOnItsWay;
  std::uint64_t given = 0;
  std::size_t rounds = 0;
  while (given < kLast) {
    for (std::uint64_t ahead = 3000; ahead < 3010; ++ahead) {
      reading.heard(given + ahead, bytes_of("false"), now);
    }
    const auto wanted = reading.wanted(now);
    REQUIRE_FALSE(wanted.empty());
    for (const auto sequence : wanted) {
      CHECK(sequence <= kLast);
      answer(reading, sequence, now);
    }
    while (const auto sequence = taken(reading)) given = sequence;
    ++rounds;
    now += 1ms;
  }
  CHECK(rounds <= kLast / Reading::kMaxRequests + 1);
}

TEST_CASE("without a leader replicas are asked ever more at once, and the leader confirms what they gave") {
  Reading reading{kStart, 7};
  reading.leader_answers(false);
  constexpr std::uint64_t kLast = 1000;
  const auto now = kStart + Reading::kSilenceUnled;
  std::size_t rounds = 0;
  for (auto wanted = reading.wanted(now); !wanted.empty(); wanted = reading.wanted(now)) {
    REQUIRE(wanted.size() <= Reading::kMaxRequests);
    for (const std::uint64_t sequence : wanted) {
      if (sequence > kLast) {
        reading.not_found(sequence, now);
      } else {
        reading.answered_by_replica(sequence, bytes_of(true_text(sequence)), now);
      }
    }
    while (taken(reading) != 0) continue;
    ++rounds;
  }
  CHECK(reading.after() == kLast);
  CHECK(rounds <= kLast / Reading::kMaxRequests + 8);
  CHECK(reading.next_poll() <= now + Reading::kSilenceUnled);
  REQUIRE(reading.unconfirmed() == kLast);
  CHECK(reading.is_unconfirmed_after(0));
  const auto confirm = [&](std::uint64_t false_one) {
    reading.leader_answers(true);
    for (auto wanted = reading.wanted(now); reading.unconfirmed(); wanted = reading.wanted(now)) {
      REQUIRE_FALSE(wanted.empty());
      REQUIRE(wanted.size() <= Reading::kMaxRequests);
      CHECK_FALSE(reading.take());
      for (const std::uint64_t sequence : wanted) {
        REQUIRE(sequence <= kLast);
        reading.answered(sequence, bytes_of(sequence == false_one ? "another" : true_text(sequence)), now);
      }
    }
  };
  SECTION("as it has the same") {
    confirm(0);
    CHECK_FALSE(reading.forged());
    hear(reading, kLast + 1, now);
    CHECK(taken(reading) == kLast + 1);
  }
  SECTION("or another, be it in the middle: they may be of several replicas") {
    confirm(kLast / 2);
    CHECK(reading.forged() == kLast / 2);
  }
  SECTION("or has dropped some, undetectably") {
    reading.starts_at(kLast);
    CHECK(reading.unconfirmed() == kLast);
    CHECK_FALSE(reading.is_unconfirmed_after(0));
    CHECK(reading.is_unconfirmed_after(kLast - 1));
    reading.starts_at(kLast + 1);
    CHECK_FALSE(reading.unconfirmed());
  }
  SECTION("but not what the leader has given itself") {
    confirm(0);
    answer(reading, kLast + 1, now);
    reading.leader_answers(false);
    reading.answered_by_replica(kLast + 1, bytes_of("another"), now);
    CHECK(taken(reading) == kLast + 1);
    CHECK_FALSE(reading.unconfirmed());
  }
  SECTION("once there is one again it is asked for what was not given out yet") {
    reading.answered_by_replica(kLast + 2, bytes_of(true_text(kLast + 2)), now);
    confirm(0);
    answer(reading, kLast + 1, now);
    CHECK(taken(reading) == kLast + 1);
    CHECK(taken(reading) == 0);
  }
  SECTION("a message outside the log waits for it") {
    reading.answered_by_replica(kLast + 1, bytes_of("torn"), now);
    REQUIRE(reading.take());
    CHECK(reading.unconfirmed() == kLast + 1);
    reading.ask_again(now);
    CHECK(reading.unconfirmed() == kLast);
    reading.answered_by_replica(kLast + 1, bytes_of("torn"), now);
    CHECK_FALSE(reading.take());
    CHECK(reading.wanted(now).empty());  // it is not asked again without end
    reading.leader_answers(true);
    reading.leader_answers(false);
    reading.leader_answers(true);
    CHECK(reading.wanted(now + Reading::kLastRetry).size() == Reading::kMaxRequests);
  }
}
