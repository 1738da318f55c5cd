// Full queues and short memory: who is refused, and who is told when there is room.
#include "chunks/chunks.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "chunks_bench.h"
#include "fake_generator.h"

namespace talus::server::chunks_test {

TEST_CASE("a client that a full queue refused is notified once when there is room") {
  FakeService fake{1, 4};
  fake.work->close_gate();
  WaitingClient greedy;
  WaitingClient late;
  late.mailbox()->join(greedy.mailbox()->flow_use());
  REQUIRE(queued(fake.service, greedy, at(0)));
  REQUIRE(queued(fake.service, greedy, at(100)));
  CHECK_FALSE(queued(fake.service, late, at(200)));
  CHECK_FALSE(queued(fake.service, late, at(300)));
  CHECK(queued(fake.service, late, at(0)));  // that job is there
  fake.work->open_gate();
  late.await_room();
  greedy.await(2);
  CHECK(late.rooms() == 1);
  CHECK(greedy.rooms() == 0);
  REQUIRE(queued(fake.service, late, at(200)));
  late.await(2);
  CHECK(late.rooms() == 1);
}

TEST_CASE("a job that is cancelled makes room for a client that was refused") {
  FakeService fake{1, 1};
  fake.work->close_gate();
  WaitingClient holder;
  REQUIRE(queued(fake.service, holder, at(0)));
  fake.work->await_somebody_at_gate();  // the only thread has the only job
  WaitingClient late;
  CHECK_FALSE(queued(fake.service, late, at(200)));
  cancel(fake.service, holder, at(0));
  fake.work->open_gate();
  late.await_room();
  REQUIRE(queued(fake.service, late, at(200)));
  late.await(1);
  CHECK(fake.work->chunks == 1);
}

TEST_CASE(
    "a flow that fills its part of the queue keeps no other out, and idle clients are notified of room") {
  // Without start(): jobs end by cancellation, so all happens in this thread.
  constexpr std::int32_t kJobs = 400;
  Metrics metrics;
  MemoryBudget memory{0};
  ManualClock clock;
  Chunks chunks{std::make_unique<FakeGenerator>(std::make_shared<FakeWork>()),
                {1, 4, kJobs, 1 << 20, 1 << 20, 0},
                make_logger("off", "text"),
                metrics,
                memory,
                clock};
  WaitingClient greedy;
  WaitingClient beside;
  beside.mailbox()->join(greedy.mailbox()->flow_use());
  std::int32_t greedy_jobs = 0;
  while (queued(chunks, greedy, at(greedy_jobs))) ++greedy_jobs;
  CHECK(greedy_jobs == 134);  // a third
  std::int32_t jobs = greedy_jobs;
  while (queued(chunks, beside, at(jobs))) ++jobs;
  CHECK(queued(chunks, WaitingClient{}, at(kJobs)));
  WaitingClient late;
  late.mailbox()->join(greedy.mailbox()->flow_use());
  while (queued(chunks, late, at(jobs + 1))) {
    REQUIRE(queued(chunks, WaitingClient{}, at(++jobs)));
    cancel(chunks, late, at(jobs));
  }
  const auto told = [&](WaitingClient& client) {
    client.take_mail();
    return client.rooms();
  };
  CHECK(told(late) == 0);
  cancel(chunks, beside, at(greedy_jobs));
  cancel(chunks, beside, at(greedy_jobs + 1));
  CHECK(told(late) == 1);
  CHECK(told(greedy) == 0);  // any of its chunks that comes tells as much
}

TEST_CASE("a client refused for lack of memory is notified when there is memory again") {
  FakeService fake{1, 1000, 800 * kMebibyte};
  fake.work->close_gate();
  WaitingClient other;
  REQUIRE(queued(fake.service, other, at(100)));
  fake.memory.set(MemoryUse::sessions, 600 * kMebibyte);
  WaitingClient client;
  CHECK_FALSE(queued(fake.service, client, at(1)));
  fake.memory.set(MemoryUse::sessions, 500 * kMebibyte);  // not yet below 5/8
  client.take_mail();
  CHECK(client.rooms() == 0);
  fake.memory.set(MemoryUse::sessions, 100 * kMebibyte);
  client.take_mail();
  CHECK(client.rooms() == 1);
  REQUIRE(queued(fake.service, client, at(1)));
  fake.work->open_gate();
  client.await(1);
}

TEST_CASE("if sessions keep the memory, each is still served, one after the other") {
  FakeService fake{1, 1000, 800 * kMebibyte};
  fake.memory.set(MemoryUse::sessions, 640 * kMebibyte);
  fake.work->close_gate();
  WaitingClient first;
  REQUIRE(queued(fake.service, first, at(1)));
  std::vector<std::unique_ptr<WaitingClient>> others;
  for (std::int32_t i = 0; i < 5; ++i) {
    others.push_back(std::make_unique<WaitingClient>());
    others.back()->mailbox()->join(first.mailbox()->flow_use());
    CHECK_FALSE(queued(fake.service, *others.back(), at(100 * (i + 1))));
  }
  const auto told = [&] {
    for (const auto& other : others) other->take_mail();
    return std::count_if(others.begin(), others.end(), [](const auto& other) { return other->rooms() > 0; });
  };
  fake.work->open_gate();
  others[0]->await_room();
  CHECK(told() == 1);
  // It asks for nothing more: housekeeping tells the next.
  (void)fake.service.fit_caches();
  CHECK(told() == 2);
  for (std::int32_t i = 1; i < 5; ++i) {
    WaitingClient& next = *others[static_cast<std::size_t>(i)];
    next.await_room();
    REQUIRE(queued(fake.service, next, at(100 * (i + 1))));
    next.await(1);
  }
}

TEST_CASE("jobs are in the memory budget while they wait") {
  FakeService fake;
  fake.work->close_gate();
  WaitingClient client;
  REQUIRE(queued(fake.service, client, at(0)));
  REQUIRE(queued(fake.service, client, at(100)));
  CHECK(fake.memory.used(MemoryUse::jobs) > 0);
  cancel(fake.service, client, at(100));
  fake.work->open_gate();
  client.await(1);
  fake.work->close_gate();
  REQUIRE(queued(fake.service, client, at(200)));
  fake.work->await_somebody_at_gate();  // the only thread has told of the first job's end by now
  const std::uint64_t one = fake.memory.used(MemoryUse::jobs);
  REQUIRE(queued(fake.service, client, at(300)));
  CHECK(fake.memory.used(MemoryUse::jobs) == 2 * one);
}

TEST_CASE("caches shrink by slices as soon as everything else grows, and grow again") {
  FakeService fake{1, 4000, 128 * kMebibyte, 64 * kMebibyte};
  fake.work->payload_bytes = 5'000;
  fake.work->patch_columns = 10'000;
  fake.work->first_mixed = 0;
  fake.work->last_mixed = 1'000'000;  // so that no patch is let go because its chunks are all cached
  WaitingClient client;
  std::size_t asked = 0;
  const auto fill = [&] {
    for (std::int32_t x = 0; x < 4000; ++x) {
      REQUIRE(queued(fake.service, client, at(x)));
      if (x % 500 == 499) client.await(asked += 500);
    }
    REQUIRE(fake.service.fit_caches());
  };
  // What a slice may free of either cache, in bytes.
  constexpr std::uint64_t kChunkSlice = Chunks::kChunksPerFit * 5'300;
  constexpr std::uint64_t kPatchSlice = Chunks::kTilesPerFit / 16 * 41'000;
  const auto used = [&](MemoryUse use) { return fake.memory.used(use); };
  fill();
  CHECK(used(MemoryUse::chunk_cache) > 20'000'000);
  CHECK(used(MemoryUse::patch_cache) > 30'000'000);
  fake.memory.set(MemoryUse::sessions, UINT64_MAX / 4);
  int calls = 0;
  for (bool fits = false; !fits; ++calls) {
    const std::uint64_t chunks = used(MemoryUse::chunk_cache);
    const std::uint64_t patches = used(MemoryUse::patch_cache);
    fits = fake.service.fit_caches();
    REQUIRE(used(MemoryUse::chunk_cache) + kChunkSlice >= chunks);
    REQUIRE(used(MemoryUse::patch_cache) + kPatchSlice >= patches);
    REQUIRE(calls < 1000);
  }
  CHECK(calls > 30);
  CHECK(used(MemoryUse::chunk_cache) <= 4 * kMebibyte);  // half of a sixteenth
  CHECK(used(MemoryUse::patch_cache) <= 4 * kMebibyte);
  CHECK(fake.service.status().chunk_cache_bytes <= 4 * kMebibyte);
  CHECK(fake.service.fit_caches());
  fake.memory.set(MemoryUse::sessions, 0);
  CHECK(fake.service.fit_caches());
  fill();
  CHECK(used(MemoryUse::chunk_cache) > 20'000'000);
}

TEST_CASE("generators count for at most an eighth of the budget, so that new clients can connect") {
  FakeService fake{2, 1000, 128 * kMebibyte};
  fake.work->patch_columns = 4'000'000;
  WaitingClient client;
  REQUIRE(queued(fake.service, client, {{1, 2, 3}, Lod{}}));
  client.await(1);
  CHECK(fake.memory.used(MemoryUse::generators) == 16 * kMebibyte);
  CHECK(fake.memory.takes_connections());
  CHECK(fake.memory.takes_work());
}

}  // namespace talus::server::chunks_test
