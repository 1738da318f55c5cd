#include "chunks/generation/answer_batcher.h"

#include <catch2/catch.hpp>
#include <new>

#include "runtime/manual_clock.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

ChunkKey at(std::int32_t x) {
  return {{x, 0, 0}, Lod{}};
}

struct Owner {
  int woken = 0;
  MailboxPtr mailbox;
  explicit Owner(std::uint64_t id) : mailbox{std::make_shared<Mailbox>(ClientId{id}, [this] { ++woken; })} {}

  /// x of the chunks that came since the last time.
  std::vector<std::int32_t> take() {
    std::vector<std::int32_t> xs;
    for (const Mail& mail : mailbox->take()) xs.push_back(std::get<ChunkReady>(mail).key.coord.x);
    return xs;
  }
};

using Xs = std::vector<std::int32_t>;

struct Bench {
  Logger log = make_logger("off", "text");
  ManualClock clock;
  AnswerBatcher answers{log, clock};
  ChunkAnswer answer = tl::make_unexpected(GenerationError{"of no use here"});
};

}  // namespace

TEST_CASE("each waiting client receives its answers once, in the order in which they were made") {
  Bench bench;
  Owner one{1};
  Owner other{2};
  for (std::int32_t x = 0; x < 5; ++x) {
    bench.answers.add(x % 2 == 0 ? std::vector{Waiter{one.mailbox}, Waiter{other.mailbox}}
                                 : std::vector{Waiter{one.mailbox}},
                      at(x), bench.answer);
  }
  bench.answers.wake();
  CHECK(one.take() == Xs{0, 1, 2, 3, 4});
  CHECK(other.take() == Xs{0, 2, 4});
}

TEST_CASE("answers wait for the interval or the end, and wake their owner once") {
  Bench bench;
  Owner owner{1};
  bench.answers.add(std::vector{Waiter{owner.mailbox}}, at(0), bench.answer);
  bench.clock.advance(AnswerBatcher::kInterval - 1us);
  bench.answers.add(std::vector{Waiter{owner.mailbox}}, at(1), bench.answer);
  CHECK(owner.woken == 0);
  CHECK(owner.take().empty());
  bench.clock.advance(1us);
  bench.answers.add(std::vector{Waiter{owner.mailbox}}, at(2), bench.answer);
  CHECK(owner.woken == 1);
  CHECK(owner.take() == Xs{0, 1, 2});

  bench.answers.add(std::vector{Waiter{owner.mailbox}}, at(3), bench.answer);
  bench.answers.wake();
  CHECK(owner.woken == 2);
  CHECK(owner.take() == Xs{3});
  bench.answers.wake();
  CHECK(owner.woken == 2);
}

TEST_CASE("pending answers are delivered at the end") {
  Bench bench;
  Owner owner{1};
  {
    AnswerBatcher answers{bench.log, bench.clock};
    answers.add(std::vector{Waiter{owner.mailbox}}, at(0), bench.answer);
    CHECK(owner.woken == 0);
  }
  CHECK(owner.woken == 1);
  CHECK(owner.take() == Xs{0});
}

TEST_CASE("an owner that cannot be woken delays no other owner") {
  Bench bench;
  const auto broken = std::make_shared<Mailbox>(ClientId{1}, [] { throw std::bad_alloc{}; });
  Owner owner{2};
  bench.answers.add(std::vector{Waiter{broken}, Waiter{owner.mailbox}}, at(0), bench.answer);
  bench.answers.wake();
  CHECK(owner.woken == 1);
  CHECK_NOTHROW(deliver(broken, QueueHasRoom{}, bench.log));
}
