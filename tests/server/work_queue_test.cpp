#include "generation/work_queue.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <rapidcheck.h>

using namespace talus;
using namespace talus::server;

namespace {

class Nobody final : public ChunkClient {
 public:
  void chunks_ready(std::vector<ReadyChunk>) override {}
  void heights_ready(std::uint64_t, HeightsAnswer) override {}
};

ChunkKey at(std::int32_t x, std::int32_t y = 0) {
  return {{x, y, 0}, Lod{}};
}

WorkQueue::Batch take_batch(WorkQueue& queue) {
  auto work = queue.take();
  REQUIRE(work.has_value());
  return std::get<WorkQueue::Batch>(std::move(work)->what);
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

TEST_CASE("of one client only so many pieces are under way, so that the next who comes finds a thread") {
  WorkQueue queue{kPatch, 1000};
  const auto greedy = std::make_shared<Nobody>();
  const auto walker = std::make_shared<Nobody>();
  for (std::int32_t patch = 0; patch < 10; ++patch) REQUIRE(queue.add(greedy, at(patch * kPatch)));
  WorkPrices prices{100, 10, 0, {}};
  prices.most_at_once = 2;
  const auto first = queue.take(prices);
  REQUIRE(first.has_value());
  REQUIRE(queue.take(prices).has_value());
  CHECK_FALSE(queue.take(prices).has_value());
  REQUIRE(queue.add(walker, at(1000 * kPatch)));
  const auto walkers = queue.take(prices);
  REQUIRE(walkers.has_value());
  CHECK(walkers->client == walker);
  CHECK_FALSE(queue.take(prices).has_value());
  queue.settle(*first, 110);
  const auto next = queue.take(prices);
  REQUIRE(next.has_value());
  CHECK(next->client == greedy);
}

TEST_CASE("turns weigh what they cost: cheap pieces go several to a turn") {
  WorkQueue queue{kPatch, 1000};
  const auto walker = std::make_shared<Nobody>();
  const auto explorer = std::make_shared<Nobody>();
  // The walker's patches are at hand, the explorer's are not.
  WorkPrices prices{100, 10, 0, [](const PatchKey& patch) { return patch.x >= 1000; }};
  for (std::int32_t patch = 0; patch < 40; ++patch) {
    REQUIRE(queue.add(explorer, at(patch * kPatch)));
    REQUIRE(queue.add(walker, at((1000 + patch) * kPatch)));
  }
  std::map<const ChunkClient*, int> pieces;
  for (int piece = 0; piece < 33; ++piece) {
    const auto work = queue.take(prices);
    REQUIRE(work.has_value());
    ++pieces[work->client.get()];
  }
  // A turn is worth one piece of 110 and a little debt, or ten of 10.
  CHECK(pieces[explorer.get()] == 3);
  CHECK(pieces[walker.get()] == 30);
}

TEST_CASE(
    "whatever pieces cost, clients that always have some get the same time but for a turn and a piece") {
  CHECK(rc::check([] {
    WorkQueue queue{1, 100'000};
    const auto prices =
        WorkPrices{*rc::gen::inRange<std::uint64_t>(1, 1000), *rc::gen::inRange<std::uint64_t>(0, 10), 0, {}};
    const auto costs = *rc::gen::container<std::vector<std::uint64_t>>(
        *rc::gen::inRange<std::size_t>(2, 6), rc::gen::inRange<std::uint64_t>(1, 5000));
    std::map<const ChunkClient*, std::size_t> numbers;
    std::vector<ChunkClientPtr> clients;
    std::vector<std::uint64_t> spent(costs.size());
    for (std::size_t number = 0; number < costs.size(); ++number) {
      clients.push_back(std::make_shared<Nobody>());
      numbers[clients.back().get()] = number;
    }
    std::int32_t next = 0;
    const auto ask = [&](std::size_t number) { RC_ASSERT(queue.add(clients[number], at(++next))); };
    for (std::size_t number = 0; number < costs.size(); ++number) {
      ask(number);
      ask(number);
    }
    const std::uint64_t dearest =
        std::max(*std::max_element(costs.begin(), costs.end()), prices.patch + prices.chunk);
    for (int piece = 0; piece < 300; ++piece) {
      auto work = queue.take(prices);
      RC_ASSERT(work.has_value());
      const std::size_t number = numbers.at(work->client.get());
      const auto& batch = std::get<WorkQueue::Batch>(work->what);
      for (const ChunkKey key : batch.keys) (void)queue.finish(key);
      queue.release(batch.patch);
      queue.settle(*work, costs[number]);
      spent[number] += costs[number];
      ask(number);
      const auto [least, most] = std::minmax_element(spent.begin(), spent.end());
      RC_ASSERT(*most - *least <= 2 * (prices.patch + dearest));
    }
  }));
}

TEST_CASE("who left owing pays when it comes back") {
  WorkQueue queue{kPatch, 1000};
  const auto debtor = std::make_shared<Nobody>();
  const auto other = std::make_shared<Nobody>();
  for (std::int32_t patch = 0; patch < 20; ++patch) REQUIRE(queue.add(other, at(patch * kPatch)));
  REQUIRE(queue.add(debtor, at(-1)));
  const WorkPrices prices{10, 0, 0, {}};
  (void)queue.take(prices);
  const auto dear = queue.take(prices);
  REQUIRE(dear->client == debtor);
  queue.settle(*dear, 50);
  CHECK(queue.take(prices)->client == other);  // which takes it through a turn in which it has nothing
  REQUIRE(queue.add(debtor, at(-100)));
  int others = 1;
  while (queue.take(prices)->client == other) ++others;
  CHECK(others >= 4);
}

TEST_CASE("who had nothing waiting goes before those who always have") {
  WorkQueue queue{kPatch, 1000};
  std::vector<std::shared_ptr<Nobody>> greedy;
  for (std::int32_t i = 0; i < 5; ++i) {
    greedy.push_back(std::make_shared<Nobody>());
    for (std::int32_t patch = 0; patch < 10; ++patch) {
      REQUIRE(queue.add(greedy.back(), at((i * 10 + patch) * kPatch)));
    }
  }
  for (int piece = 0; piece < 7; ++piece) (void)queue.take();
  const auto walker = std::make_shared<Nobody>();
  REQUIRE(queue.add(walker, at(-1)));
  CHECK(queue.take()->client == walker);
}

TEST_CASE("who asks for one thing after the other goes first once in a round") {
  WorkQueue queue{kPatch, 1000};
  std::vector<std::shared_ptr<Nobody>> others;
  for (std::int32_t i = 0; i < 5; ++i) {
    others.push_back(std::make_shared<Nobody>());
    for (std::int32_t patch = 0; patch < 20; ++patch) {
      REQUIRE(queue.add(others.back(), at((i * 20 + patch) * kPatch)));
    }
  }
  const auto sly = std::make_shared<Nobody>();
  int turns = 0;
  for (std::int32_t piece = 0; piece < 60; ++piece) {
    REQUIRE(queue.add(sly, at(-1 - piece * kPatch)));
    if (queue.take()->client == sly) ++turns;
  }
  CHECK(turns <= 11);  // one of six, and the first
}

TEST_CASE("the same asked in the same order is done in the same order") {
  const auto order = [] {
    WorkQueue queue{kPatch, 1000};
    std::vector<std::shared_ptr<Nobody>> clients;
    for (int i = 0; i < 7; ++i) clients.push_back(std::make_shared<Nobody>());
    for (std::int32_t i = 0; i < 100; ++i) {
      REQUIRE(queue.add(clients[static_cast<std::size_t>(i * i % 7)], at(i * 37 % 101 * kPatch)));
    }
    std::vector<PatchKey> taken;
    while (auto work = queue.take({3, 1, 0, [](const PatchKey& patch) { return patch.x % 2 == 0; }})) {
      taken.push_back(std::get<WorkQueue::Batch>(work->what).patch);
    }
    return taken;
  };
  CHECK(order() == order());
}

TEST_CASE("a job for which two wait is done when the more urgent one's turn comes") {
  WorkQueue queue{kPatch, 1000};
  const auto patient = std::make_shared<Nobody>();
  const auto urgent = std::make_shared<Nobody>();
  for (std::int32_t patch = 1; patch <= 10; ++patch) REQUIRE(queue.add(patient, at(patch * kPatch)));
  REQUIRE(queue.add(patient, at(0)));  // after ten others
  REQUIRE(queue.add(urgent, at(0)));   // at once
  (void)take_batch(queue);
  CHECK(take_batch(queue).keys == std::vector{at(0)});
  CHECK(queue.finish(at(0)) == std::vector<ChunkClientPtr>{patient, urgent});
}

TEST_CASE("in a batch the chunks of the client whose turn it is come first") {
  WorkQueue queue{kPatch, 1000};
  const auto first = std::make_shared<Nobody>();
  const auto second = std::make_shared<Nobody>();
  REQUIRE(queue.add(first, at(100)));
  for (std::int32_t y = 0; y < 5; ++y) REQUIRE(queue.add(first, at(0, y)));
  REQUIRE(queue.add(second, at(0, 9)));
  (void)take_batch(queue);
  CHECK(take_batch(queue).keys.front() == at(0, 9));
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
        if (auto work = queue.take()) taken.push_back(std::get<WorkQueue::Batch>(std::move(work)->what));
      } else if (!taken.empty()) {
        finish(taken.back());
        taken.pop_back();
      }
    }
    for (const auto& batch : taken) finish(batch);
    while (auto work = queue.take()) finish(std::get<WorkQueue::Batch>(std::move(work)->what));
    RC_ASSERT(queue.jobs() == 0U);
    RC_ASSERT(queue.clients() == 0U);
    for (const auto& [key, clients_waiting] : waiting) RC_ASSERT(clients_waiting.empty());
  }));
}
