#include "generation/work_queue.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <rapidcheck.h>

using namespace talus;
using namespace talus::server;

namespace {

class Nobody final : public ChunkClient {
 public:
  void chunk_ready(ChunkKey, ChunkAnswer) override {}
  void heights_ready(std::uint64_t, HeightsAnswer) override {}
};

ChunkKey at(std::int32_t x, std::int32_t y = 0) {
  return {{x, y, 0}, Lod{}};
}

WorkQueue::Batch take_batch(WorkQueue& queue) {
  auto work = queue.take();
  REQUIRE(work.has_value());
  return std::get<WorkQueue::Batch>(*std::move(work));
}

constexpr int kPatch = 4;

}  // namespace

TEST_CASE("one job, however many wait") {
  WorkQueue queue{kPatch, 100};
  const std::vector<ChunkClientPtr> clients{std::make_shared<Nobody>(), std::make_shared<Nobody>(),
                                            std::make_shared<Nobody>()};
  for (const auto& client : clients) {
    REQUIRE(queue.add(client, at(1)));
    REQUIRE(queue.add(client, at(1)));
  }
  CHECK(queue.jobs() == 1);
  CHECK(take_batch(queue).keys == std::vector{at(1)});
  CHECK(queue.begin(at(1)));
  CHECK(queue.finish(at(1)) == clients);
}

TEST_CASE("a batch is all that waits for a patch") {
  WorkQueue queue{kPatch, 100};
  const auto client = std::make_shared<Nobody>();
  for (const ChunkKey key : {at(0), at(7), at(3, 9), at(-1)}) REQUIRE(queue.add(client, key));
  CHECK(take_batch(queue).keys == std::vector{at(0), at(3, 9)});
  CHECK(take_batch(queue).keys == std::vector{at(7)});
  CHECK(take_batch(queue).keys == std::vector{at(-1)});
}

TEST_CASE("a patch is nobody else's until it is released") {
  WorkQueue queue{kPatch, 100};
  const auto client = std::make_shared<Nobody>();
  REQUIRE(queue.add(client, at(0)));
  const auto batch = take_batch(queue);
  REQUIRE(queue.add(client, at(1)));
  CHECK_FALSE(queue.take().has_value());
  (void)queue.finish(at(0));
  queue.release(batch.patch);
  CHECK(take_batch(queue).keys == std::vector{at(1)});
}

TEST_CASE("a job dies with its last waiter") {
  WorkQueue queue{kPatch, 100};
  const auto first = std::make_shared<Nobody>();
  const auto second = std::make_shared<Nobody>();
  REQUIRE(queue.add(first, at(1)));
  REQUIRE(queue.add(second, at(1)));
  queue.cancel(*first, at(1));
  CHECK(queue.jobs() == 1);
  queue.cancel(*second, at(1));
  CHECK(queue.jobs() == 0);
  CHECK_FALSE(queue.take().has_value());
}

TEST_CASE("a job whose waiters left while it was taken is not begun") {
  WorkQueue queue{kPatch, 100};
  const auto client = std::make_shared<Nobody>();
  REQUIRE(queue.add(client, at(1)));
  const auto batch = take_batch(queue);
  queue.cancel(*client, at(1));
  CHECK_FALSE(queue.begin(at(1)));
  queue.release(batch.patch);
  CHECK(queue.jobs() == 0);
}

TEST_CASE("clients take turns, however much one of them wants") {
  WorkQueue queue{kPatch, 1000};
  const auto greedy = std::make_shared<Nobody>();
  const auto modest = std::make_shared<Nobody>();
  for (std::int32_t patch = 0; patch < 50; ++patch) REQUIRE(queue.add(greedy, at(patch * kPatch)));
  REQUIRE(queue.add(modest, at(-1)));
  (void)take_batch(queue);
  CHECK(take_batch(queue).keys == std::vector{at(-1)});
}

TEST_CASE("a full queue refuses new jobs, not new waiters") {
  WorkQueue queue{kPatch, 1};
  REQUIRE(queue.add(std::make_shared<Nobody>(), at(1)));
  CHECK(queue.add(std::make_shared<Nobody>(), at(1)));
  CHECK_FALSE(queue.add(std::make_shared<Nobody>(), at(2)));
}

TEST_CASE("every job is taken once or cancelled, and nothing is left behind") {
  CHECK(rc::check([] {
    WorkQueue queue{kPatch, 1000};
    const std::vector<std::shared_ptr<Nobody>> clients{std::make_shared<Nobody>(), std::make_shared<Nobody>(),
                                                       std::make_shared<Nobody>()};
    std::map<ChunkKey, std::set<const ChunkClient*>> waiting;
    std::vector<WorkQueue::Batch> taken;
    const auto finish = [&](const WorkQueue::Batch& batch) {
      for (const ChunkKey key : batch.keys) {
        const auto expected = waiting[key];
        waiting.erase(key);
        RC_ASSERT(queue.begin(key) == !expected.empty());
        if (expected.empty()) continue;
        std::set<const ChunkClient*> got;
        for (const auto& client : queue.finish(key)) got.insert(client.get());
        RC_ASSERT(got == expected);
      }
      queue.release(batch.patch);
    };
    const auto steps = *rc::gen::container<std::vector<std::tuple<int, int, int>>>(
        rc::gen::tuple(rc::gen::inRange(0, 6), rc::gen::inRange(0, 3), rc::gen::inRange(0, 12)));
    for (const auto& [step, who, where] : steps) {
      const auto& client = clients[static_cast<std::size_t>(who)];
      if (step < 3) {
        RC_ASSERT(queue.add(client, at(where)));
        waiting[at(where)].insert(client.get());
      } else if (step == 3) {
        queue.cancel(*client, at(where));
        if (waiting.contains(at(where))) waiting[at(where)].erase(client.get());
      } else if (step == 4) {
        if (auto work = queue.take()) taken.push_back(std::get<WorkQueue::Batch>(*std::move(work)));
      } else if (!taken.empty()) {
        finish(taken.back());
        taken.pop_back();
      }
    }
    for (const auto& batch : taken) finish(batch);
    while (auto work = queue.take()) finish(std::get<WorkQueue::Batch>(*std::move(work)));
    RC_ASSERT(queue.jobs() == 0U);
    RC_ASSERT(queue.clients() == 0U);
    for (const auto& [key, clients_waiting] : waiting) RC_ASSERT(clients_waiting.empty());
  }));
}
