#include "chunks/generation/work_queue.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>

#include <rapidcheck.h>

#include "work_queue_helpers.h"

using namespace talus;
using namespace talus::server;

TEST_CASE("one job, however many wait") {
  WorkQueue queue{kPatch, 100};
  const std::vector<MailboxPtr> clients{client_box(), client_box(), client_box()};
  for (const auto& client : clients) {
    REQUIRE(add(queue, client, at(1)));
    REQUIRE(add(queue, client, at(1)));
  }
  CHECK(queue.jobs() == 1);
  CHECK(take_batch(queue).keys == std::vector{at(1)});
  CHECK(queue.begin(at(1)));
  CHECK(end_job(queue, at(1)) == clients);
}

TEST_CASE("a batch is all that waits for a patch") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  for (const ChunkKey key : {at(0), at(7), at(3, 9), at(-1)}) REQUIRE(add(queue, client, key));
  CHECK(take_batch(queue).keys == std::vector{at(0), at(3, 9)});
  CHECK(take_batch(queue).keys == std::vector{at(7)});
  CHECK(take_batch(queue).keys == std::vector{at(-1)});
}

TEST_CASE("a patch is not taken again until it is released") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  REQUIRE(add(queue, client, at(0)));
  const auto batch = take_batch(queue);
  REQUIRE(add(queue, client, at(1)));
  CHECK_FALSE(queue.take().has_value());
  (void)queue.finish(at(0));
  queue.release(batch.patch);
  CHECK(take_batch(queue).keys == std::vector{at(1)});
}

TEST_CASE("a job dies with its last waiter") {
  WorkQueue queue{kPatch, 100};
  const auto first = client_box();
  const auto second = client_box();
  REQUIRE(add(queue, first, at(1)));
  REQUIRE(add(queue, second, at(1)));
  queue.cancel(first->owner(), at(1));
  CHECK(queue.jobs() == 1);
  queue.cancel(second->owner(), at(1));
  CHECK(queue.jobs() == 0);
  CHECK_FALSE(queue.take().has_value());
}

TEST_CASE("a client waits for a chunk in the version for which it asked first") {
  WorkQueue queue{kPatch, 100};
  const auto edited = client_box();
  const auto both = client_box();
  REQUIRE(queue.add({edited, Version::edited}, std::array{at(0)}) == 1);
  REQUIRE(queue.add({both, Version::generated}, std::array{at(0)}) == 1);
  REQUIRE(queue.add({both, Version::edited}, std::array{at(0)}) == 1);
  (void)take_batch(queue);
  REQUIRE(queue.add({both, Version::edited}, std::array{at(0)}) == 1);
  CHECK(queue.finish(at(0)) == std::vector<Waiter>{{edited, Version::edited}, {both, Version::generated}});
}

TEST_CASE("a job whose waiters left while it was taken is not begun") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  REQUIRE(add(queue, client, at(1)));
  const auto batch = take_batch(queue);
  queue.cancel(client->owner(), at(1));
  CHECK_FALSE(queue.begin(at(1)));
  queue.release(batch.patch);
  CHECK(queue.jobs() == 0);
}

TEST_CASE("clients take turns, however much one of them wants") {
  WorkQueue queue{kPatch, 1000};
  const auto greedy = client_box();
  const auto modest = client_box();
  for (std::int32_t patch = 0; patch < 50; ++patch) REQUIRE(add(queue, greedy, at(patch * kPatch)));
  REQUIRE(add(queue, modest, at(-1)));
  (void)take_batch(queue);
  CHECK(take_batch(queue).keys == std::vector{at(-1)});
}

TEST_CASE("pieces in flight are limited per client, so that the next client finds a thread") {
  WorkQueue queue{kPatch, 1000};
  const auto greedy = client_box();
  const auto walker = client_box();
  for (std::int32_t patch = 0; patch < 10; ++patch) REQUIRE(add(queue, greedy, at(patch * kPatch)));
  WorkCosts costs{100, 10, 0, {}};
  costs.max_in_flight = 2;
  const auto first = queue.take(costs);
  REQUIRE(first.has_value());
  REQUIRE(queue.take(costs).has_value());
  CHECK_FALSE(queue.take(costs).has_value());
  REQUIRE(add(queue, walker, at(1000 * kPatch)));
  const auto walkers = queue.take(costs);
  REQUIRE(walkers.has_value());
  CHECK(walkers->turn.client == walker->owner());
  CHECK_FALSE(queue.take(costs).has_value());
  queue.reconcile(*first, 110);
  const auto next = queue.take(costs);
  REQUIRE(next.has_value());
  CHECK(next->turn.client == greedy->owner());
}

TEST_CASE("turns are worth time, not pieces: cheap pieces go several to a turn") {
  WorkQueue queue{kPatch, 1000};
  const auto walker = client_box();
  const auto explorer = client_box();
  // The walker's patches are in memory, the explorer's are not.
  WorkCosts costs{100, 10, 0, [](const PatchKey& patch) { return patch.x >= 1000; }};
  for (std::int32_t patch = 0; patch < 40; ++patch) {
    REQUIRE(add(queue, explorer, at(patch * kPatch)));
    REQUIRE(add(queue, walker, at((1000 + patch) * kPatch)));
  }
  std::map<ClientId, int> pieces;
  for (int piece = 0; piece < 33; ++piece) {
    const auto work = queue.take(costs);
    REQUIRE(work.has_value());
    ++pieces[work->turn.client];
  }
  // A turn is worth one piece of 110 and a little debt, or ten of 10.
  CHECK(pieces[explorer->owner()] == 3);
  CHECK(pieces[walker->owner()] == 30);
}

TEST_CASE(
    "whatever pieces cost, clients that always have some get the same time to within a turn and a piece") {
  CHECK(rc::check([] {
    WorkQueue queue{1, 100'000};
    const auto expected =
        WorkCosts{*rc::gen::inRange<std::uint64_t>(1, 1000), *rc::gen::inRange<std::uint64_t>(0, 10), 0, {}};
    const auto costs = *rc::gen::container<std::vector<std::uint64_t>>(
        *rc::gen::inRange<std::size_t>(2, 6), rc::gen::inRange<std::uint64_t>(1, 5000));
    std::map<ClientId, std::size_t> numbers;
    std::vector<MailboxPtr> clients;
    std::vector<std::uint64_t> spent(costs.size());
    for (std::size_t number = 0; number < costs.size(); ++number) {
      clients.push_back(client_box());
      numbers[clients.back()->owner()] = number;
    }
    std::int32_t next = 0;
    const auto ask = [&](std::size_t number) { RC_ASSERT(add(queue, clients[number], at(++next))); };
    for (std::size_t number = 0; number < costs.size(); ++number) {
      ask(number);
      ask(number);
    }
    const std::uint64_t dearest =
        std::max(*std::max_element(costs.begin(), costs.end()), expected.patch + expected.chunk);
    for (int piece = 0; piece < 300; ++piece) {
      auto work = queue.take(expected);
      RC_ASSERT(work.has_value());
      const std::size_t number = numbers.at(work->turn.client);
      const auto& batch = std::get<WorkQueue::Batch>(work->what);
      for (const ChunkKey key : batch.keys) (void)queue.finish(key);
      queue.release(batch.patch);
      queue.reconcile(*work, costs[number]);
      spent[number] += costs[number];
      ask(number);
      const auto [least, most] = std::minmax_element(spent.begin(), spent.end());
      RC_ASSERT(*most - *least <= 2 * (expected.patch + dearest));
    }
  }));
}

TEST_CASE("a client that left owing pays when it comes back") {
  WorkQueue queue{kPatch, 1000};
  const auto debtor = client_box();
  const auto other = client_box();
  for (std::int32_t patch = 0; patch < 20; ++patch) REQUIRE(add(queue, other, at(patch * kPatch)));
  REQUIRE(add(queue, debtor, at(-1)));
  const WorkCosts costs{10, 0, 0, {}};
  (void)queue.take(costs);
  const auto dear = queue.take(costs);
  REQUIRE(dear->turn.client == debtor->owner());
  queue.reconcile(*dear, 50);
  CHECK(queue.take(costs)->turn.client ==
        other->owner());  // which takes it through a turn in which it has nothing
  REQUIRE(add(queue, debtor, at(-100)));
  int others = 1;
  while (queue.take(costs)->turn.client == other->owner()) ++others;
  CHECK(others >= 4);
}

TEST_CASE("a client that had nothing waiting goes before clients that always have") {
  WorkQueue queue{kPatch, 1000};
  std::vector<MailboxPtr> greedy;
  for (std::int32_t i = 0; i < 5; ++i) {
    greedy.push_back(client_box());
    for (std::int32_t patch = 0; patch < 10; ++patch) {
      REQUIRE(add(queue, greedy.back(), at((i * 10 + patch) * kPatch)));
    }
  }
  for (int piece = 0; piece < 7; ++piece) (void)queue.take();
  const auto walker = client_box();
  REQUIRE(add(queue, walker, at(-1)));
  CHECK(queue.take()->turn.client == walker->owner());
}

TEST_CASE("a client that asks for one thing after the other goes first once in a round") {
  WorkQueue queue{kPatch, 1000};
  std::vector<MailboxPtr> others;
  for (std::int32_t i = 0; i < 5; ++i) {
    others.push_back(client_box());
    for (std::int32_t patch = 0; patch < 20; ++patch) {
      REQUIRE(add(queue, others.back(), at((i * 20 + patch) * kPatch)));
    }
  }
  const auto sly = client_box();
  int turns = 0;
  for (std::int32_t piece = 0; piece < 60; ++piece) {
    REQUIRE(add(queue, sly, at(-1 - piece * kPatch)));
    if (queue.take()->turn.client == sly->owner()) ++turns;
  }
  CHECK(turns <= 11);  // one of six, and the first
}

TEST_CASE("the same asked in the same order is done in the same order") {
  const auto order = [] {
    WorkQueue queue{kPatch, 1000};
    std::vector<MailboxPtr> clients;
    for (int i = 0; i < 7; ++i) clients.push_back(client_box());
    for (std::int32_t i = 0; i < 100; ++i) {
      REQUIRE(add(queue, clients[static_cast<std::size_t>(i * i % 7)], at(i * 37 % 101 * kPatch)));
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
  const auto patient = client_box();
  const auto urgent = client_box();
  for (std::int32_t patch = 1; patch <= 10; ++patch) REQUIRE(add(queue, patient, at(patch * kPatch)));
  REQUIRE(add(queue, patient, at(0)));  // after ten others
  REQUIRE(add(queue, urgent, at(0)));   // at once
  (void)take_batch(queue);
  CHECK(take_batch(queue).keys == std::vector{at(0)});
  CHECK(end_job(queue, at(0)) == std::vector{patient, urgent});
}

TEST_CASE("in a batch the chunks of the client whose turn it is come first") {
  WorkQueue queue{kPatch, 1000};
  const auto first = client_box();
  const auto second = client_box();
  REQUIRE(add(queue, first, at(100)));
  for (std::int32_t y = 0; y < 5; ++y) REQUIRE(add(queue, first, at(0, y)));
  REQUIRE(add(queue, second, at(0, 9)));
  (void)take_batch(queue);
  CHECK(take_batch(queue).keys.front() == at(0, 9));
}

TEST_CASE("a flow without room gets no new jobs, but may wait for existing ones") {
  WorkQueue queue{kPatch, 1};
  REQUIRE(add(queue, client_box(), at(1)));
  CHECK(add(queue, client_box(), at(1)));
  CHECK_FALSE(add(queue, client_box(), at(2)));
}

TEST_CASE("a flow has room for as many jobs as are free, however many clients it has") {
  WorkQueue queue{kPatch, 90};
  const auto jobs_of = [&](FlowId flow, std::int32_t z) {
    int jobs = 0;
    for (std::int32_t x = 0; x < 200; ++x) jobs += add(queue, client_box(flow), {{x, 0, z}, Lod{}}) ? 1 : 0;
    return jobs;
  };
  CHECK(jobs_of(kFlow, 0) == 45);
  CHECK(jobs_of(kOtherFlow, 1000) == 23);
  CHECK(jobs_of(FlowId{3'000'000}, 2000) == 11);  // whoever comes finds room
  CHECK(queue.jobs() == 79);
}

TEST_CASE("a client of a flow leaves room for the next") {
  WorkQueue queue{kPatch, 40};
  const auto greedy = client_box(kFlow);
  const auto next = client_box(kFlow);
  std::int32_t x = 0;
  while (add(queue, greedy, at(x))) ++x;
  CHECK(x == 14);  // 14 wait, the flow has 26 - 14 places more
  CHECK(queue.has_room(kFlow));
  CHECK(add(queue, next, at(1000)));
}

TEST_CASE("a client that waits for nothing is not refused, and gets all that it asks for at once") {
  WorkQueue queue{kPatch, 4, 1};
  for (int i = 0; i < 4; ++i) REQUIRE(add(queue, client_box(kFlow), at(100 + i)));
  const auto client = client_box(kFlow);
  std::vector<ChunkKey> keys;
  for (std::int32_t x = 0; x < 9; ++x) keys.push_back(at(x));
  CHECK(queue.add({client}, keys) == 9);
  CHECK(queue.jobs() == 13);
  CHECK_FALSE(add(queue, client, at(50)));
  CHECK(queue.waits(client->owner()));
  while (queue.waits(client->owner())) (void)take_batch(queue);
  CHECK(add(queue, client, at(50)));
}

TEST_CASE("if no new jobs are accepted, a client may wait for existing ones, up to the first that is new") {
  WorkQueue queue{kPatch, 100, 1};
  REQUIRE(add(queue, client_box(), at(0)));
  REQUIRE(add(queue, client_box(), at(1)));
  CHECK(queue.add({client_box()}, std::array{at(0), at(1), at(2), at(0)}, Urgency::later, false) == 2);
  CHECK(queue.jobs() == 2);
}

TEST_CASE("jobs of one patch end in any order") {
  CHECK(rc::check([] {
    WorkQueue queue{64, 1000};
    const auto client = client_box();
    std::vector<ChunkKey> keys;
    for (std::int32_t x = 0; x < 60; ++x) keys.push_back(at(x));
    RC_ASSERT(queue.add({client}, keys) == keys.size());
    const bool taken = *rc::gen::arbitrary<bool>();
    const auto order =
        *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, keys.size()));
    if (taken) RC_ASSERT(take_batch(queue).keys == keys);
    std::set<ChunkKey> left{keys.begin(), keys.end()};
    for (const std::size_t index : order) {
      if (left.erase(keys[index]) == 0) continue;
      if (taken) {
        RC_ASSERT(queue.finish(keys[index]).size() == 1U);
      } else {
        queue.cancel(client->owner(), keys[index]);
      }
      RC_ASSERT(queue.jobs() == left.size());
    }
    for (const ChunkKey key : left) {
      if (taken) {
        RC_ASSERT(queue.begin(key));
        RC_ASSERT(queue.finish(key).size() == 1U);
      } else {
        queue.cancel(client->owner(), key);
      }
    }
    RC_ASSERT(queue.jobs() == 0U);
    RC_ASSERT(queue.waits(client->owner()) == false);
  }));
}

TEST_CASE("a job that is finished is not begun again") {
  WorkQueue queue{kPatch, 100};
  REQUIRE(queue.add({client_box()}, std::array{at(0), at(1)}) == 2);
  const auto batch = take_batch(queue);
  (void)queue.finish(at(1));
  CHECK_FALSE(queue.begin(at(1)));
  CHECK(queue.begin(at(0)));
  queue.release(batch.patch);
}

TEST_CASE("jobs of a batch that a thread did not finish are removed with it") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box(kFlow);
  REQUIRE(queue.add({client}, std::array{at(0), at(1), at(2)}) == 3);
  const auto batch = take_batch(queue);
  (void)queue.finish(at(1));
  queue.release(batch.patch);
  CHECK(queue.jobs() == 0);
  CHECK(add(queue, client, at(0)));
  CHECK(take_batch(queue).keys == std::vector{at(0)});
}

TEST_CASE("a flow has room while it has fewer jobs than are free") {
  WorkQueue queue{kPatch, 8};
  for (std::int32_t y = 0; y < 4; ++y) REQUIRE(add(queue, client_box(kFlow), at(0, y)));
  CHECK_FALSE(queue.has_room(kFlow));
  CHECK(queue.has_room(kOtherFlow));
  CHECK_FALSE(add(queue, client_box(kFlow), at(0, 4)));
  (void)take_batch(queue);
  (void)queue.finish(at(0, 0));
  CHECK(queue.has_room(kFlow));
}

TEST_CASE("a job counts for a flow that waits for it") {
  WorkQueue queue{kPatch, 4};
  const auto first = client_box(kFlow);
  const auto second = client_box(kOtherFlow);
  REQUIRE(add(queue, first, at(0)));
  REQUIRE(add(queue, second, at(0)));
  REQUIRE(add(queue, client_box(kFlow), at(1)));
  CHECK_FALSE(queue.has_room(kFlow));
  queue.cancel(first->owner(), at(0));
  CHECK(queue.has_room(kFlow));
  queue.cancel(second->owner(), at(0));
  CHECK(queue.jobs() == 1);
}

TEST_CASE("a patch is not given up while a client waits for any of it") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  REQUIRE(add(queue, client, at(0)));
  const auto batch = take_batch(queue);
  CHECK_FALSE(queue.drop_unwanted(batch));
  queue.cancel(client->owner(), at(0));
  REQUIRE(add(queue, client, at(1)));
  CHECK_FALSE(queue.drop_unwanted(batch));
  queue.cancel(client->owner(), at(1));
  CHECK(queue.drop_unwanted(batch));
  CHECK(queue.jobs() == 0);
}

TEST_CASE("flows take turns, and clients within a flow") {
  WorkQueue queue{kPatch, 10'000};
  std::vector<MailboxPtr> many;
  for (std::int32_t i = 0; i < 10; ++i) {
    many.push_back(client_box(kFlow));
    for (std::int32_t patch = 0; patch < 20; ++patch) {
      REQUIRE(add(queue, many.back(), at((i * 20 + patch) * kPatch)));
    }
  }
  const auto alone = client_box();
  for (std::int32_t patch = 0; patch < 100; ++patch) REQUIRE(add(queue, alone, at(-1 - patch * kPatch)));
  std::map<ClientId, int> pieces;
  for (int piece = 0; piece < 100; ++piece) ++pieces[queue.take()->turn.client];
  CHECK(pieces[alone->owner()] == 50);
  for (const auto& each : many) CHECK(pieces[each->owner()] == 5);
}

TEST_CASE("a client that comes and goes gains nothing within its flow, and its flow nothing by it") {
  WorkQueue queue{kPatch, 10'000};
  const auto steady = client_box(kFlow);
  const auto other = client_box(kOtherFlow);
  for (std::int32_t patch = 0; patch < 200; ++patch) {
    REQUIRE(add(queue, steady, at(patch * kPatch)));
    REQUIRE(add(queue, other, at((1000 + patch) * kPatch)));
  }
  std::map<FlowId, int> flows;
  int newcomers = 0;
  for (std::int32_t piece = 0; piece < 120; ++piece) {
    REQUIRE(add(queue, client_box(kFlow), at(-1 - piece * kPatch)));
    const auto work = queue.take();
    ++flows[work->turn.flow];
    if (work->turn.flow == kFlow && work->turn.client != steady->owner()) ++newcomers;
  }
  CHECK(flows[kOtherFlow] == 60);
  CHECK(newcomers < 60);  // the one that was there first is not forgotten
}

TEST_CASE("a flow that is new goes first, but for one turn's worth of time") {
  WorkQueue queue{kPatch, 10'000};
  const auto player = client_box();
  for (std::int32_t patch = 0; patch < 100; ++patch) REQUIRE(add(queue, player, at(patch * kPatch)));
  const WorkCosts costs{10, 0, 0, {}};
  const auto run = [&](std::uint64_t cost) {
    const auto work = queue.take(costs);
    const auto& batch = std::get<WorkQueue::Batch>(work->what);
    for (const ChunkKey key : batch.keys) (void)queue.finish(key);
    queue.release(batch.patch);
    queue.reconcile(*work, cost);
    return work->turn.flow;
  };
  (void)run(10);
  std::map<FlowId, int> pieces;
  // Each newcomer of the other flow asks for what costs as much as ten patches, and is gone.
  for (std::int32_t i = 0; i < 60; ++i) {
    REQUIRE(add(queue, client_box(kOtherFlow), at(-1 - i * kPatch)));
    const bool dear = pieces[kOtherFlow] * 10 <= pieces[player->flow()];
    const FlowId flow = run(dear ? 100 : 10);
    ++pieces[flow];
  }
  CHECK(pieces[player->flow()] >= 30);
}

TEST_CASE("pieces in flight are limited per flow, whichever of its clients they are for") {
  WorkQueue queue{kPatch, 1000};
  WorkCosts costs{100, 10, 0, {}};
  costs.max_in_flight = 2;
  for (std::int32_t i = 0; i < 5; ++i) REQUIRE(add(queue, client_box(kFlow), at(i * kPatch)));
  REQUIRE(queue.take(costs).has_value());
  REQUIRE(queue.take(costs).has_value());
  CHECK_FALSE(queue.take(costs).has_value());
}

TEST_CASE("a client that waits for both gets heights and patches in turns") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  for (std::uint64_t i = 0; i < 3; ++i) {
    REQUIRE(add(queue, client, at(static_cast<std::int32_t>(i) * kPatch)));
    queue.add(HeightsTask{client, i, HeightsQuery{.columns = {{0, 0}}}});
  }
  std::string order;
  while (const auto work = queue.take()) order += std::holds_alternative<HeightsTask>(work->what) ? 'h' : 'p';
  CHECK(order == "hphphp");
}

TEST_CASE("cancelled heights are not begun") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  queue.add(HeightsTask{client, 1, HeightsQuery{.columns = {{0, 0}}}});
  queue.add(HeightsTask{client, 2, HeightsQuery{.columns = {{0, 0}}}});
  queue.cancel_heights(client->owner(), 1);
  queue.cancel_heights(client->owner(), 7);
  CHECK(std::get<HeightsTask>(queue.take()->what).ticket() == 2);
  CHECK_FALSE(queue.take().has_value());
}

TEST_CASE("heights that are put back go on, unless they were cancelled") {
  WorkQueue queue{kPatch, 100};
  const auto client = client_box();
  queue.add(HeightsTask{client, 1, HeightsQuery{.columns = {{0, 0}, {1000, 0}}}});
  auto work = queue.take();
  auto& task = std::get<HeightsTask>(work->what);
  task.add({{7}, {}, {}});
  queue.put_back(std::move(task));
  queue.reconcile(*work, 1);
  work = queue.take();
  REQUIRE(work.has_value());
  CHECK(std::get<HeightsTask>(work->what).left() == 1);
  queue.cancel_heights(client->owner(), 1);
  queue.put_back(std::move(std::get<HeightsTask>(work->what)));
  queue.reconcile(*work, 1);
  CHECK_FALSE(queue.take().has_value());
  CHECK(queue.clients() == 0);
}

TEST_CASE("every job is taken once or cancelled, and nothing is left behind") {
  CHECK(rc::check([] {
    WorkQueue queue{kPatch, 1000};
    const std::vector<MailboxPtr> clients{client_box(), client_box(), client_box()};
    std::map<ChunkKey, std::set<ClientId>> waiting;
    std::vector<WorkQueue::Work> taken;
    const auto finish = [&](WorkQueue::Work& work) {
      const auto& batch = std::get<WorkQueue::Batch>(work.what);
      for (const ChunkKey key : batch.keys) {
        const auto expected = waiting[key];
        waiting.erase(key);
        RC_ASSERT(queue.begin(key) == !expected.empty());
        if (expected.empty()) continue;
        std::set<ClientId> got;
        for (const MailboxPtr& client : end_job(queue, key)) got.insert(client->owner());
        RC_ASSERT(got == expected);
      }
      queue.release(batch.patch);
      queue.reconcile(work, 1);
    };
    const auto put_back = [&](WorkQueue::Work& work) {
      auto& batch = std::get<WorkQueue::Batch>(work.what);
      for (const ChunkKey key : batch.keys) {
        if (waiting[key].empty()) waiting.erase(key);
      }
      if (batch.begun == nullptr) batch.begun = std::make_unique<BegunPatch>();
      queue.put_back(std::move(batch), work.turn);
      queue.reconcile(work, 1);
    };
    const auto steps = *rc::gen::container<std::vector<std::tuple<int, int, int>>>(
        rc::gen::tuple(rc::gen::inRange(0, 7), rc::gen::inRange(0, 3), rc::gen::inRange(0, 12)));
    for (const auto& [step, who, where] : steps) {
      const auto& client = clients[static_cast<std::size_t>(who)];
      if (step < 3) {
        const Urgency urgency = step == 0 ? Urgency::soon : Urgency::later;
        RC_ASSERT(queue.add({client}, std::array{at(where)}, urgency) == 1U);
        waiting[at(where)].insert(client->owner());
      } else if (step == 3) {
        queue.cancel(client->owner(), at(where));
        if (waiting.contains(at(where))) waiting[at(where)].erase(client->owner());
      } else if (step == 6) {
        queue.hasten(client->owner(), at(where));
      } else if (step == 4) {
        if (auto work = queue.take()) taken.push_back(*std::move(work));
      } else if (!taken.empty()) {
        if (where % 3 == 0) {
          put_back(taken.back());
        } else {
          finish(taken.back());
        }
        taken.pop_back();
      }
    }
    for (auto& work : taken) finish(work);
    while (auto work = queue.take()) finish(*work);
    RC_ASSERT(queue.begun() == 0U);
    RC_ASSERT(queue.jobs() == 0U);
    RC_ASSERT(queue.clients() == 0U);
    for (const auto& [key, clients_waiting] : waiting) RC_ASSERT(clients_waiting.empty());
  }));
}
