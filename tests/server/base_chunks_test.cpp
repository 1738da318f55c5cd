// With generator threads, which a gate holds where a test must be sure of what they do.
#include "generation/base_chunks.h"

#include <catch2/catch.hpp>

#include "fake_generator.h"

using namespace talus;
using namespace talus::server;

namespace {

constexpr std::uint64_t kMebibyte = 1U << 20;

ChunkKey at(std::int32_t x) {
  return {{x, 0, 0}, Lod{}};
}

bool queued(ChunkSource& chunks, const WaitingClient& client, ChunkKey key) {
  return chunks.submit(client.mailbox(), key) == ChunkSource::Submission::queued;
}

}  // namespace

TEST_CASE("many waiters, one generation") {
  FakeService fake{3};
  fake.work->close_gate();
  std::vector<std::unique_ptr<WaitingClient>> clients;
  for (int i = 0; i < 50; ++i) {
    clients.push_back(std::make_unique<WaitingClient>());
    REQUIRE(queued(fake.service, *clients.back(), at(1)));
  }
  fake.work->open_gate();
  for (const auto& client : clients) client->await(1);
  CHECK(fake.work->chunks == 1);
  CHECK(fake.work->patches == 1);
}

TEST_CASE("a generated chunk is found from then on, is of the base revision, and never newer") {
  FakeService fake;
  WaitingClient client;
  CHECK(fake.service.find(at(1)) == nullptr);
  REQUIRE(queued(fake.service, client, at(1)));
  client.await(1);
  const EncodedChunkPtr chunk = fake.service.find(at(1));
  REQUIRE(chunk != nullptr);
  CHECK(chunk == *client.answers()[0].second);
  CHECK(chunk->revision() == kBaseRevision);
  CHECK(fake.service.newer(at(1), kBaseRevision) == nullptr);
}

TEST_CASE("a chunk that was made meanwhile is answered without a job") {
  FakeService fake;
  WaitingClient first;
  WaitingClient second;
  REQUIRE(queued(fake.service, first, at(1)));
  first.await(1);
  fake.work->close_gate();
  REQUIRE(queued(fake.service, second, at(1)));
  second.await(1);
  CHECK(second.answers()[0].second == first.answers()[0].second);
  CHECK(fake.work->chunks == 1);
}

TEST_CASE("chunks of one patch share it") {
  FakeService fake{4};
  WaitingClient client;
  for (std::int32_t x = 0; x < 4; ++x) REQUIRE(queued(fake.service, client, at(x)));
  client.await(4);
  CHECK(fake.work->patches == 1);
  CHECK(fake.work->chunks == 4);
}

TEST_CASE("a column is exact once its terrain was generated, and its uniform chunks are found") {
  FakeService fake;
  fake.work->last_mixed_anywhere = 50;
  fake.work->first_mixed = 2;
  fake.work->last_mixed = 3;
  CHECK(fake.service.column(at(0)).last == 50);
  CHECK(fake.service.find({{3, 4, 3}, Lod{}}) == nullptr);
  WaitingClient client;
  REQUIRE(queued(fake.service, client, {{0, 2, 0}, Lod{}}));
  client.await(1);
  const MixedRows column = fake.service.column({{3, 7, 3}, Lod{}});
  CHECK(column.uniform_at(1) == MaterialId{2});
  CHECK_FALSE(column.uniform_at(2).has_value());
  CHECK_FALSE(column.uniform_at(3).has_value());
  CHECK(column.uniform_at(4) == kAir);
  CHECK(fake.service.find({{3, 4, 3}, Lod{}}) != nullptr);
  CHECK(fake.service.find({{3, 1, 3}, Lod{}}) != nullptr);
  CHECK(fake.service.find({{3, 2, 3}, Lod{}}) == nullptr);
  CHECK(fake.work->chunks == 1);
}

TEST_CASE("a cancelled chunk is not generated") {
  FakeService fake;
  fake.work->close_gate();
  WaitingClient client;
  REQUIRE(queued(fake.service, client, at(0)));    // holds the only thread at the gate, now or soon
  REQUIRE(queued(fake.service, client, at(100)));  // waits behind it
  fake.service.cancel(client.id(), at(100));
  fake.work->open_gate();
  client.await(1);
  REQUIRE(queued(fake.service, client, at(200)));
  client.await(2);
  CHECK(fake.work->chunks == 2);
}

TEST_CASE("a chunk cancelled while its patch is made is not generated") {
  FakeService fake;
  fake.work->close_gate();
  WaitingClient client;
  REQUIRE(queued(fake.service, client, at(100)));
  fake.work->await_somebody_at_gate();  // the only thread: what comes now is taken together
  REQUIRE(queued(fake.service, client, at(0)));
  REQUIRE(queued(fake.service, client, at(1)));
  fake.service.cancel(client.id(), at(100));
  fake.work->open_gate();
  client.await(2);
  CHECK(fake.work->chunks == 2);
}

TEST_CASE("out of memory is an answer, and the next request may succeed") {
  FakeService fake;
  fake.work->out_of_memory = true;
  WaitingClient client;
  REQUIRE(queued(fake.service, client, at(0)));
  client.await(1);
  CHECK_FALSE(client.answers()[0].second.has_value());
  fake.work->out_of_memory = false;
  REQUIRE(queued(fake.service, client, at(0)));
  client.await(2);
  CHECK(client.answers()[1].second.has_value());
}

TEST_CASE("heights come by their ticket, failed ones too") {
  FakeService fake;
  WaitingClient client;
  fake.service.submit_heights(client.mailbox(), 6, {{1, 2}, {3, 4}});
  client.await(1);
  CHECK(client.heights()[0].first == 6);
  CHECK(client.heights()[0].second.value().size() == 2);
  fake.work->out_of_memory = true;
  fake.service.submit_heights(client.mailbox(), 7, {{1, 2}});
  client.await(2);
  CHECK(client.heights()[1].first == 7);
  CHECK_FALSE(client.heights()[1].second.has_value());
}

TEST_CASE("a client that cannot be woken harms nobody") {
  FakeService fake;
  const auto broken = std::make_shared<Mailbox>(ClientId{1'000'000}, [] { throw std::bad_alloc{}; });
  REQUIRE(fake.service.submit(broken, at(1)) == ChunkSource::Submission::queued);
  fake.service.submit_heights(broken, 1, {{1, 2}});
  WaitingClient client;
  REQUIRE(queued(fake.service, client, at(2)));
  fake.service.submit_heights(client.mailbox(), 1, {{1, 2}});
  client.await(2);
}

TEST_CASE("a client that was refused by a full queue is told when there is room, once") {
  FakeService fake{1, 2};
  fake.work->close_gate();
  WaitingClient greedy;
  WaitingClient late;
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
  fake.service.cancel(holder.id(), at(0));
  fake.work->open_gate();
  late.await_room();
  REQUIRE(queued(fake.service, late, at(200)));
  late.await(1);
  CHECK(fake.work->chunks == 1);
}

TEST_CASE("of those that were refused, the first are told first, and not all at once") {
  // Without start(): jobs end by cancellation, so all happens in this thread.
  constexpr std::size_t kJobs = 4 * GenerationPool::kJobsPerClient;
  Metrics metrics;
  MemoryBudget memory{0};
  ManualClock clock;
  BaseChunks chunks{std::make_unique<FakeGenerator>(std::make_shared<FakeWork>()),
                    {1, 4, kJobs, 1 << 20, 1 << 20},
                    std::make_shared<spdlog::logger>("silent"),
                    metrics,
                    memory,
                    clock};
  WaitingClient greedy;
  for (std::size_t x = 0; x < kJobs; ++x) REQUIRE(queued(chunks, greedy, at(static_cast<std::int32_t>(x))));
  std::vector<std::unique_ptr<WaitingClient>> refused;
  for (int i = 0; i < 6; ++i) {
    refused.push_back(std::make_unique<WaitingClient>());
    CHECK_FALSE(queued(chunks, *refused.back(), at(-1 - i)));
  }
  const auto told = [&] {
    std::vector<int> rooms;
    for (const auto& client : refused) {
      client->take_mail();
      rooms.push_back(client->rooms());
    }
    return rooms;
  };
  std::int32_t cancelled = 0;
  const auto cancel = [&](std::size_t jobs) {
    for (std::size_t i = 0; i < jobs; ++i) chunks.cancel(greedy.id(), at(cancelled++));
  };
  cancel(kJobs / 4);
  CHECK(told() == std::vector{0, 0, 0, 0, 0, 0});
  cancel(1);
  CHECK(told() == std::vector{1, 0, 0, 0, 0, 0});
  cancel(1);
  CHECK(told() == std::vector{1, 1, 0, 0, 0, 0});
  cancel(kJobs - static_cast<std::size_t>(cancelled));
  CHECK(told() == std::vector{1, 1, 1, 1, 1, 1});
}

TEST_CASE("a client that was refused for want of memory is told when it is there again") {
  FakeService fake{1, 1000, 800 * kMebibyte};
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
  client.await(1);
}

TEST_CASE("jobs are in the memory budget while they wait") {
  FakeService fake;
  fake.work->close_gate();
  WaitingClient client;
  REQUIRE(queued(fake.service, client, at(0)));
  REQUIRE(queued(fake.service, client, at(100)));
  CHECK(fake.memory.used(MemoryUse::jobs) > 0);
  fake.service.cancel(client.id(), at(100));
  fake.work->open_gate();
  client.await(1);
  fake.work->close_gate();
  REQUIRE(queued(fake.service, client, at(200)));
  fake.work->await_somebody_at_gate();  // the only thread has told of the first job's end by now
  const std::uint64_t one = fake.memory.used(MemoryUse::jobs);
  REQUIRE(queued(fake.service, client, at(300)));
  CHECK(fake.memory.used(MemoryUse::jobs) == 2 * one);
}

TEST_CASE("caches shrink as soon as everything else grows, and grow again") {
  FakeService fake{1, 1000, 128 * kMebibyte, 64 * kMebibyte};
  fake.work->payload_bytes = 20'000;
  WaitingClient client;
  std::size_t asked = 0;
  const auto fill = [&] {
    for (std::int32_t x = 0; x < 1000; ++x) REQUIRE(queued(fake.service, client, at(x)));
    client.await(asked += 1000);
    fake.service.fit_caches();
  };
  fill();
  CHECK(fake.memory.used(MemoryUse::chunk_cache) > 20'000'000);
  fake.memory.set(MemoryUse::sessions, UINT64_MAX / 4);
  fake.service.fit_caches();
  CHECK(fake.memory.used(MemoryUse::chunk_cache) <= 4 * kMebibyte);  // half of a sixteenth
  CHECK(fake.service.status().chunk_cache_bytes <= 4 * kMebibyte);
  fake.memory.set(MemoryUse::sessions, 0);
  fake.service.fit_caches();
  fill();
  CHECK(fake.memory.used(MemoryUse::chunk_cache) > 20'000'000);
}

TEST_CASE("generators count for an eighth of the budget at most, so that somebody can come") {
  FakeService fake{2, 1000, 128 * kMebibyte};
  fake.work->patch_columns = 4'000'000;
  WaitingClient client;
  REQUIRE(queued(fake.service, client, {{1, 2, 3}, Lod{}}));
  client.await(1);
  CHECK(fake.memory.used(MemoryUse::generators) == 16 * kMebibyte);
  CHECK(fake.memory.takes_connections());
  CHECK(fake.memory.takes_work());
}
