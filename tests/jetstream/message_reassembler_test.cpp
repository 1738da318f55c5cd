// Which messages are given out and asked for, without a network.
#include <algorithm>
#include <random>
#include <set>
#include <string>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "cluster/jetstream/message_reassembler.h"
#include "opened_stream.h"

using talus::nats_test::bytes_of;
using talus::nats_test::text_of;
using talus::server::jetstream::MessageReassembler;
using namespace std::chrono_literals;

namespace {

using TimePoint = MessageReassembler::TimePoint;
using Sequences = std::vector<std::uint64_t>;

std::string true_text(std::uint64_t sequence) {
  return "message " + std::to_string(sequence);
}

void hear(MessageReassembler& reassembler, std::uint64_t sequence, TimePoint now) {
  reassembler.heard(sequence, bytes_of(true_text(sequence)), now);
}
void answer(MessageReassembler& reassembler, std::uint64_t sequence, TimePoint now) {
  reassembler.answered(sequence, bytes_of(true_text(sequence)), now);
}

std::uint64_t taken(MessageReassembler& reassembler) {
  const auto message = reassembler.take();
  if (!message) return 0;
  CHECK(text_of(message->bytes) == true_text(message->sequence));
  return message->sequence;
}

const TimePoint kStart{1h};

}  // namespace

TEST_CASE("messages of the tail are given out in order, and nothing is asked for") {
  MessageReassembler reassembler{kStart, 7};
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    hear(reassembler, sequence, kStart);
    CHECK(reassembler.wanted(kStart).empty());
    CHECK(taken(reassembler) == sequence);
  }
  CHECK(taken(reassembler) == 0);
  CHECK(reassembler.gaps() == 0);
}

TEST_CASE("an answer is waited for until it comes, or what it would bring has come by itself") {
  MessageReassembler reassembler{kStart, 7};
  CHECK_FALSE(reassembler.asks());
  hear(reassembler, 3, kStart);
  CHECK(reassembler.learned(3, kStart));
  CHECK(reassembler.wanted(kStart) == Sequences{1, 2});
  CHECK(reassembler.asks());
  answer(reassembler, 1, kStart);
  CHECK(reassembler.asks());
  hear(reassembler, 2, kStart);
  while (taken(reassembler) != 0) {
  }
  CHECK_FALSE(reassembler.asks());
  CHECK(reassembler.wanted(kStart + MessageReassembler::kSilence) == Sequences{4});
  CHECK(reassembler.asks());
  reassembler.not_found(4, kStart + MessageReassembler::kSilence);
  CHECK_FALSE(reassembler.asks());
}

TEST_CASE("a message in a gap of the tail is requested at once, and once") {
  MessageReassembler reassembler{kStart, 7};
  hear(reassembler, 4, kStart);
  CHECK(reassembler.claims_more());
  CHECK(reassembler.wanted(kStart) == Sequences{1});
  CHECK(reassembler.wanted(kStart).empty());
  CHECK(reassembler.gaps() == 1);
  SECTION("all of it once the leader says how far the stream goes") {
    CHECK(reassembler.learned(4, kStart));
    CHECK_FALSE(reassembler.claims_more());
    CHECK(reassembler.wanted(kStart) == Sequences{2, 3});
    CHECK(reassembler.wanted(kStart).empty());
    answer(reassembler, 2, kStart);
    CHECK(taken(reassembler) == 0);
    answer(reassembler, 1, kStart);
    answer(reassembler, 3, kStart);
  }
  SECTION("twice as many as were there before that") {
    answer(reassembler, 1, kStart);
    CHECK(taken(reassembler) == 1);
    CHECK(reassembler.wanted(kStart) == Sequences{2, 3});
    answer(reassembler, 2, kStart);
    answer(reassembler, 3, kStart);
    for (std::uint64_t sequence = 2; sequence <= 4; ++sequence) CHECK(taken(reassembler) == sequence);
    CHECK_FALSE(reassembler.claims_more());
    return;
  }
  for (std::uint64_t sequence = 1; sequence <= 4; ++sequence) CHECK(taken(reassembler) == sequence);
}

TEST_CASE("a request without an answer is made again") {
  MessageReassembler reassembler{kStart, 7};
  hear(reassembler, 2, kStart);
  CHECK(reassembler.wanted(kStart) == Sequences{1});
  CHECK(reassembler.next_poll() == kStart + MessageReassembler::kAnswerIn);
  CHECK(reassembler.wanted(kStart + MessageReassembler::kAnswerIn) == Sequences{1});
}

TEST_CASE("after a second of silence the next message is asked for, once a second") {
  MessageReassembler reassembler{kStart, 7};
  CHECK(reassembler.next_poll() == kStart + 1s);
  CHECK(reassembler.wanted(kStart + 999ms).empty());
  CHECK(reassembler.wanted(kStart + 1s) == Sequences{1});
  reassembler.not_found(1, kStart + 1s);
  CHECK(reassembler.wanted(kStart + 1999ms).empty());
  CHECK(reassembler.wanted(kStart + 2s) == Sequences{1});
  answer(reassembler, 1, kStart + 2s);
  CHECK(taken(reassembler) == 1);
}

TEST_CASE("a lagging replica is asked again soon, then less and less often") {
  MessageReassembler reassembler{kStart, 7};
  reassembler.learned(1, kStart);
  CHECK(reassembler.wanted(kStart).empty());
  CHECK(reassembler.next_poll() == kStart + MessageReassembler::kOnItsWay);
  auto now = kStart + MessageReassembler::kOnItsWay;
  auto pause = MessageReassembler::kFirstRetry;
  for (int i = 0; i < 10; ++i) {
    REQUIRE(reassembler.wanted(now) == Sequences{1});
    reassembler.not_found(1, now);
    CHECK(reassembler.wanted(now + pause - 1ms).empty());
    CHECK(reassembler.next_poll() == now + pause);
    now += pause;
    pause = std::min(pause * 2, MessageReassembler::kLastRetry);
  }
  answer(reassembler, 1, now);
  CHECK(taken(reassembler) == 1);
}

TEST_CASE("requests that are sent together and not found make one pause") {
  MessageReassembler reassembler{kStart, 7};
  reassembler.learned(1000, kStart);
  auto now = kStart + MessageReassembler::kOnItsWay;
  auto pause = MessageReassembler::kFirstRetry;
  for (int i = 0; i < 4; ++i) {
    const auto wanted = reassembler.wanted(now);
    CHECK(wanted.size() == MessageReassembler::kMaxRequests);
    for (const auto sequence : wanted) reassembler.not_found(sequence, now);
    CHECK(reassembler.next_poll() == now + pause);
    now += pause;
    pause *= 2;
  }
}

TEST_CASE("the next message is requested for a number that the tail claims, until the leader denies it") {
  MessageReassembler reassembler{kStart, 7};
  reassembler.heard(1'000'000'000'000, bytes_of("false"), kStart);
  auto now = kStart;
  auto pause = MessageReassembler::kFirstRetry;
  for (int i = 0; i < 8; ++i) {
    REQUIRE(reassembler.wanted(now) == Sequences{1});
    reassembler.not_found(1, now);
    CHECK(reassembler.wanted(now + pause - 1ms).empty());
    CHECK(reassembler.next_poll() == now + pause);
    now += pause;
    pause = std::min(pause * 2, MessageReassembler::kLastRetry);
  }
  CHECK(reassembler.claims_more());
  reassembler.ends_at(0);
  CHECK_FALSE(reassembler.claims_more());
  CHECK(reassembler.wanted(now).empty());
  hear(reassembler, 1, now);
  CHECK(taken(reassembler) == 1);
}

TEST_CASE("a number that the stream never had is not asked for, though two messages had it") {
  MessageReassembler reassembler{kStart, 7};
  constexpr std::uint64_t kNever = 1'000'000'000'000;
  reassembler.heard(kNever, bytes_of("false"), kStart);
  reassembler.heard(kNever, bytes_of("false, too"), kStart);
  auto now = kStart;
  for (int i = 0; i < 8; ++i) {
    for (const auto sequence : reassembler.wanted(now)) reassembler.not_found(sequence, now);
    now += MessageReassembler::kLastRetry;
  }
  reassembler.ends_at(0);
  const auto wanted = reassembler.wanted(now);
  CHECK(std::ranges::find(wanted, kNever) == wanted.end());
}

TEST_CASE("two messages of one number are held against the stream") {
  MessageReassembler reassembler{kStart, 7};
  SECTION("before one was given out, only the stream's is") {
    reassembler.heard(1, bytes_of("false"), kStart);
    hear(reassembler, 1, kStart);
    CHECK(taken(reassembler) == 0);
    CHECK(reassembler.wanted(kStart) == Sequences{1});
    answer(reassembler, 1, kStart);
    CHECK(taken(reassembler) == 1);
    CHECK_FALSE(reassembler.forged());
    CHECK(reassembler.false_messages() == 1);
  }
  SECTION("the false one after the true one does no harm") {
    hear(reassembler, 1, kStart);
    CHECK(taken(reassembler) == 1);
    reassembler.heard(1, bytes_of("false"), kStart);
    CHECK(reassembler.wanted(kStart) == Sequences{1});
    answer(reassembler, 1, kStart);
    CHECK_FALSE(reassembler.forged());
    CHECK(reassembler.false_messages() == 1);
  }
  SECTION("the false one given out is found by the true one") {
    reassembler.heard(1, bytes_of("false"), kStart);
    REQUIRE(reassembler.take());
    hear(reassembler, 1, kStart);
    CHECK(reassembler.wanted(kStart) == Sequences{1});
    answer(reassembler, 1, kStart);
    REQUIRE(reassembler.forged());
    CHECK(*reassembler.forged() == 1);
  }
  SECTION("the false one after the stream's own answer needs no asking") {
    answer(reassembler, 1, kStart);
    CHECK(taken(reassembler) == 1);
    reassembler.heard(1, bytes_of("false"), kStart);
    CHECK(reassembler.wanted(kStart).empty());
    CHECK(reassembler.false_messages() == 1);
  }
  SECTION("the same message again is nothing") {
    hear(reassembler, 1, kStart);
    hear(reassembler, 1, kStart);
    CHECK(taken(reassembler) == 1);
    hear(reassembler, 1, kStart);
    CHECK(reassembler.wanted(kStart).empty());
    CHECK(reassembler.false_messages() == 0);
  }
}

TEST_CASE("an invalid message is delivered again as the leader has it") {
  MessageReassembler reassembler{kStart, 7};
  reassembler.heard(1, bytes_of("damaged"), kStart);
  auto message = reassembler.take();
  REQUIRE(message);
  CHECK_FALSE(message->of_leader);
  reassembler.ask_again(kStart);
  CHECK(reassembler.after() == 0);
  reassembler.heard(1, bytes_of("damaged too"), kStart);
  CHECK_FALSE(reassembler.take());
  CHECK(reassembler.next_poll() <= kStart);
  CHECK(reassembler.wanted(kStart) == Sequences{1});
  SECTION("which has another") {
    answer(reassembler, 1, kStart);
    CHECK(reassembler.false_messages() == 1);
    message = reassembler.take();
    REQUIRE(message);
    CHECK(message->of_leader);
    CHECK(text_of(message->bytes) == true_text(1));
    // That is what it is, whatever comes or is thought of it.
    reassembler.ask_again(kStart);
    CHECK(reassembler.after() == 1);
    hear(reassembler, 2, kStart);
    CHECK(taken(reassembler) == 2);
    CHECK_FALSE(reassembler.forged());
  }
  SECTION("which has the same") {
    reassembler.answered(1, bytes_of("damaged"), kStart);
    message = reassembler.take();
    REQUIRE(message);
    CHECK(message->of_leader);
    CHECK(reassembler.false_messages() == 0);
  }
  SECTION("which has it when the tail has another") {
    auto now = kStart;
    for (int i = 0; i < 8; ++i) {
      reassembler.not_found(1, now);
      now = reassembler.next_poll();
      REQUIRE(reassembler.wanted(now) == Sequences{1});
    }
    reassembler.not_found(1, now);
    reassembler.heard(1, bytes_of("damaged"), now);  // which says nothing
    CHECK(reassembler.next_poll() == now + MessageReassembler::kLastRetry);
    hear(reassembler, 1, now);
    CHECK(reassembler.next_poll() == now + MessageReassembler::kDisputed);
    CHECK(reassembler.wanted(now + MessageReassembler::kDisputed - 1ms).empty());
    CHECK(reassembler.wanted(now + MessageReassembler::kDisputed) == Sequences{1});
    answer(reassembler, 1, now);
    CHECK(taken(reassembler) == 1);
  }
  SECTION("which is still empty") {
    for (int i = 0; i < 8; ++i) {
      reassembler.not_found(1, kStart + i * 1s);
      CHECK(reassembler.wanted(kStart + i * 1s + 500ms) == Sequences{1});
    }
    reassembler.ends_at(0);
    CHECK(reassembler.false_messages() == 1);
    hear(reassembler, 1, kStart + 9s);
    CHECK(taken(reassembler) == 1);
  }
}

TEST_CASE("which of two messages was the stream's is not asked after it keeps neither") {
  MessageReassembler reassembler{kStart, 7};
  hear(reassembler, 1, kStart);
  CHECK(taken(reassembler) == 1);
  reassembler.heard(1, bytes_of("false"), kStart);
  CHECK(reassembler.wanted(kStart) == Sequences{1});
  reassembler.not_found(1, kStart);
  reassembler.starts_at(1);
  CHECK(reassembler.wanted(kStart + 400ms) == Sequences{1});
  reassembler.not_found(1, kStart + 400ms);
  reassembler.starts_at(2);
  CHECK(reassembler.wanted(kStart + 900ms).empty());
}

TEST_CASE("the number of messages kept ahead is bounded, and the next message has room") {
  MessageReassembler reassembler{kStart, 7};
  const std::string large(1U << 20U, 'x');
  for (std::uint64_t sequence = 2; sequence <= 100; ++sequence) {
    reassembler.heard(sequence, bytes_of(large), kStart);
  }
  reassembler.heard(1, bytes_of(large), kStart);
  std::uint64_t kept = 0;
  while (reassembler.take()) ++kept;
  CHECK(kept == MessageReassembler::kWindowBytes >> 20U);
  reassembler.heard(kept + 2 + MessageReassembler::kWindow, bytes_of("far"), kStart);
  CHECK_FALSE(reassembler.wanted(kStart).empty());
}

TEST_CASE("lost, late or doubled messages are all delivered once, in order") {
  const bool held = rc::check([](std::uint32_t seed) {
    std::mt19937 random{seed};
    const auto below = [&](std::uint64_t bound) { return std::uint64_t{random()} % bound; };
    const std::uint64_t last = 1 + below(200);
    MessageReassembler reassembler{kStart, 7};
    auto now = kStart;
    std::uint64_t published = 0;
    std::uint64_t given = 0;
    std::set<std::uint64_t> asked;
    for (int i = 0; i < 20'000 && given < last; ++i) {
      for (const auto sequence : reassembler.wanted(now)) asked.insert(sequence);
      now += std::chrono::milliseconds{below(300)};
      if (published < last && below(2) == 0) {
        ++published;
        const auto luck = below(4);  // lost in 1 of 4
        if (luck > 0) hear(reassembler, published, now);
        if (luck == 3) hear(reassembler, published, now);
      }
      if (published > 0 && below(4) == 0) hear(reassembler, 1 + below(published), now);
      if (!asked.empty()) {
        const auto sequence = *asked.begin();
        asked.erase(asked.begin());
        const auto luck = below(4);
        if (luck > 1 && sequence <= published) answer(reassembler, sequence, now);
        if (luck == 1) reassembler.not_found(sequence, now);
      }
      while (const auto message = reassembler.take()) {
        RC_ASSERT(message->sequence == given + 1);
        RC_ASSERT(text_of(message->bytes) == true_text(message->sequence));
        ++given;
      }
    }
    RC_ASSERT(given == last);
    RC_ASSERT(!reassembler.forged());
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
    MessageReassembler reassembler{kStart, 7};
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
          answer(reassembler, sequence, now);
        } else {
          reassembler.not_found(sequence, now);
        }
      }
      if (published < kLast && now >= publish_at) {
        hear(reassembler, ++published, now);
        publish_at = now + between;
      }
      for (std::uint64_t i = 0; i < forged_each_ms; ++i) {
        reassembler.heard(given + 1 + below(ahead), bytes_of("false " + std::to_string(below(texts))), now);
      }
      while (const auto message = reassembler.take()) {
        if (!message->of_leader && text_of(message->bytes) != true_text(message->sequence)) {
          reassembler.ask_again(now);
          break;
        }
        RC_ASSERT(text_of(message->bytes) == true_text(message->sequence));
        RC_ASSERT(message->sequence == ++given);
      }
      asked = reassembler.wanted(now);
      questions += asked.size();
      if ((reassembler.claims_more() && now >= asked_end_at + 100ms) || now >= asked_end_at + 1s) {
        asked_end_at = now;
        reassembler.learned(published, now);
        reassembler.ends_at(published);
      }
    }
    RC_ASSERT(given == kLast);
    RC_ASSERT(!reassembler.forged());
    // A few for each message, and one each kDisputed.
    RC_ASSERT(questions <=
              12 * kLast + static_cast<std::size_t>((now - kStart) / MessageReassembler::kDisputed));
  });
  CHECK(held);
}

TEST_CASE("a reader far behind sends ever more requests at once if no leader reports the distance") {
  constexpr std::uint64_t kLast = 10'000;
  MessageReassembler reassembler{kStart, 7};
  hear(reassembler, kLast, kStart);
  std::size_t rounds = 0;
  while (reassembler.after() < kLast) {
    const auto wanted = reassembler.wanted(kStart);
    REQUIRE_FALSE(wanted.empty());
    REQUIRE(wanted.size() <= MessageReassembler::kMaxRequests);
    for (const std::uint64_t sequence : wanted) answer(reassembler, sequence, kStart);
    while (reassembler.take()) continue;
    ++rounds;
  }
  CHECK(rounds <= kLast / MessageReassembler::kMaxRequests + 8);
  // The first that is not there ends it.
  hear(reassembler, kLast + 1000, kStart);
  const auto wanted = reassembler.wanted(kStart);
  CHECK(wanted.size() == MessageReassembler::kMaxRequests);
  for (const std::uint64_t sequence : wanted) reassembler.not_found(sequence, kStart);
  CHECK(reassembler.wanted(kStart + 1s) == Sequences{kLast + 1});
}

TEST_CASE("a reader far behind sends many requests at once, whatever the tail claims") {
  MessageReassembler reassembler{kStart, 7};
  constexpr std::uint64_t kLast = 5000;
  auto now = kStart;
  reassembler.learned(kLast, now);
  now += MessageReassembler::kOnItsWay;
  std::uint64_t given = 0;
  std::size_t rounds = 0;
  while (given < kLast) {
    for (std::uint64_t ahead = 3000; ahead < 3010; ++ahead) {
      reassembler.heard(given + ahead, bytes_of("false"), now);
    }
    const auto wanted = reassembler.wanted(now);
    REQUIRE_FALSE(wanted.empty());
    for (const auto sequence : wanted) {
      CHECK(sequence <= kLast);
      answer(reassembler, sequence, now);
    }
    while (const auto sequence = taken(reassembler)) given = sequence;
    ++rounds;
    now += 1ms;
  }
  CHECK(rounds <= kLast / MessageReassembler::kMaxRequests + 1);
}

TEST_CASE("without a leader replicas are asked ever more at once, and the leader confirms what they gave") {
  MessageReassembler reassembler{kStart, 7};
  reassembler.leader_answers(false);
  constexpr std::uint64_t kLast = 1000;
  const auto now = kStart + MessageReassembler::kSilenceUnled;
  std::size_t rounds = 0;
  for (auto wanted = reassembler.wanted(now); !wanted.empty(); wanted = reassembler.wanted(now)) {
    REQUIRE(wanted.size() <= MessageReassembler::kMaxRequests);
    for (const std::uint64_t sequence : wanted) {
      if (sequence > kLast) {
        reassembler.not_found(sequence, now);
      } else {
        reassembler.answered_by_replica(sequence, bytes_of(true_text(sequence)), now);
      }
    }
    while (taken(reassembler) != 0) continue;
    ++rounds;
  }
  CHECK(reassembler.after() == kLast);
  CHECK(rounds <= kLast / MessageReassembler::kMaxRequests + 8);
  CHECK(reassembler.next_poll() <= now + MessageReassembler::kSilenceUnled);
  REQUIRE(reassembler.unconfirmed() == kLast);
  CHECK(reassembler.is_unconfirmed_after(0));
  const auto confirm = [&](std::uint64_t false_one) {
    reassembler.leader_answers(true);
    for (auto wanted = reassembler.wanted(now); reassembler.unconfirmed(); wanted = reassembler.wanted(now)) {
      REQUIRE_FALSE(wanted.empty());
      REQUIRE(wanted.size() <= MessageReassembler::kMaxRequests);
      CHECK_FALSE(reassembler.take());
      for (const std::uint64_t sequence : wanted) {
        REQUIRE(sequence <= kLast);
        reassembler.answered(sequence, bytes_of(sequence == false_one ? "another" : true_text(sequence)),
                             now);
      }
    }
  };
  SECTION("as it has the same") {
    confirm(0);
    CHECK_FALSE(reassembler.forged());
    hear(reassembler, kLast + 1, now);
    CHECK(taken(reassembler) == kLast + 1);
  }
  SECTION("or another, be it in the middle: they may be of several replicas") {
    confirm(kLast / 2);
    CHECK(reassembler.forged() == kLast / 2);
  }
  SECTION("or has dropped some, undetectably") {
    reassembler.starts_at(kLast);
    CHECK(reassembler.unconfirmed() == kLast);
    CHECK_FALSE(reassembler.is_unconfirmed_after(0));
    CHECK(reassembler.is_unconfirmed_after(kLast - 1));
    reassembler.starts_at(kLast + 1);
    CHECK_FALSE(reassembler.unconfirmed());
  }
  SECTION("but not what the leader has given itself") {
    confirm(0);
    answer(reassembler, kLast + 1, now);
    reassembler.leader_answers(false);
    reassembler.answered_by_replica(kLast + 1, bytes_of("another"), now);
    CHECK(taken(reassembler) == kLast + 1);
    CHECK_FALSE(reassembler.unconfirmed());
  }
  SECTION("once there is one again it is asked for what was not given out yet") {
    reassembler.answered_by_replica(kLast + 2, bytes_of(true_text(kLast + 2)), now);
    confirm(0);
    answer(reassembler, kLast + 1, now);
    CHECK(taken(reassembler) == kLast + 1);
    CHECK(taken(reassembler) == 0);
  }
  SECTION("a message outside the log waits for it") {
    reassembler.answered_by_replica(kLast + 1, bytes_of("torn"), now);
    REQUIRE(reassembler.take());
    CHECK(reassembler.unconfirmed() == kLast + 1);
    reassembler.ask_again(now);
    CHECK(reassembler.unconfirmed() == kLast);
    reassembler.answered_by_replica(kLast + 1, bytes_of("torn"), now);
    CHECK_FALSE(reassembler.take());
    CHECK(reassembler.wanted(now).empty());  // it is not asked again without end
    reassembler.leader_answers(true);
    reassembler.leader_answers(false);
    reassembler.leader_answers(true);
    CHECK(reassembler.wanted(now + MessageReassembler::kLastRetry).size() ==
          MessageReassembler::kMaxRequests);
  }
}
