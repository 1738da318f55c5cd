#include "memory/memory_budget.h"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include <rapidcheck.h>

#include "fake_generator.h"

using namespace talus;
using namespace talus::server;

namespace {

constexpr std::uint64_t kMebibyte = 1U << 20;
constexpr std::uint64_t kBudget = 800 * kMebibyte;

/// So much beside the caches, the program's share included.
void hold(MemoryBudget& budget, std::uint64_t bytes) {
  budget.set(MemoryUse::sessions, bytes - MemoryBudget::kProgramBytes);
}

}  // namespace

TEST_CASE("without a budget nothing is refused") {
  MemoryBudget budget{0};
  budget.set(MemoryUse::sessions, UINT64_MAX / 4);
  CHECK(budget.takes_work());
  CHECK(budget.takes_connections());
  CHECK(budget.for_caches(kBudget) == kBudget);
}

TEST_CASE("caches give way before anything is refused") {
  MemoryBudget budget{kBudget};
  budget.set(MemoryUse::chunk_cache, kBudget);
  hold(budget, 450 * kMebibyte);
  CHECK(budget.takes_work());
  CHECK(budget.takes_connections());
  CHECK(budget.for_caches(kBudget) == 250 * kMebibyte);
}

TEST_CASE("connections are refused before work is, and neither flaps") {
  MemoryBudget budget{kBudget};
  hold(budget, 500 * kMebibyte);
  CHECK_FALSE(budget.takes_connections());
  CHECK(budget.takes_work());
  hold(budget, 600 * kMebibyte);
  CHECK_FALSE(budget.takes_work());
  hold(budget, 550 * kMebibyte);
  CHECK_FALSE(budget.takes_work());
  hold(budget, 499 * kMebibyte);
  CHECK(budget.takes_work());
  CHECK_FALSE(budget.takes_connections());
  hold(budget, 399 * kMebibyte);
  CHECK(budget.takes_connections());
}

TEST_CASE("while work is taken, it and the caches together are below the budget") {
  CHECK(rc::check([] {
    MemoryBudget budget{*rc::gen::inRange<std::uint64_t>(64 * kMebibyte, 1024 * 1024 * kMebibyte)};
    const auto beside = *rc::gen::inRange<std::uint64_t>(MemoryBudget::kProgramBytes, budget.limit_bytes());
    hold(budget, beside);
    if (!budget.takes_work()) return;
    RC_ASSERT(beside + budget.for_caches(UINT64_MAX) <= budget.limit_bytes() / 8 * 7 + 7);
  }));
}

TEST_CASE("what a holder told is given back with it, whatever other threads do") {
  MemoryBudget budget{kBudget};
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (std::uint64_t i = 0; i < 1000; ++i) {
        MemoryShare share{budget, MemoryUse::sessions};
        share.hold(i * 5000);
        share.hold(i * 100);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(budget.used(MemoryUse::sessions) == 0);
}

TEST_CASE("caches shrink as soon as everything else grows, and grow again") {
  const auto work = std::make_shared<FakeWork>();
  work->payload_bytes = 1000;
  Metrics metrics;
  MemoryBudget budget{kBudget};
  ChunkService service{std::make_unique<FakeGenerator>(work),
                       {1, 4, 1000, 64 * kMebibyte, 64 * kMebibyte},
                       std::make_shared<spdlog::logger>("silent"),
                       metrics,
                       budget};
  service.start();
  const auto client = std::make_shared<WaitingClient>();
  for (std::int32_t x = 0; x < 1000; ++x)
    REQUIRE(service.submit(client, {{x, 0, 0}, Lod{}}) == ChunkService::Submission::queued);
  client->await(1000);
  CHECK(service.status().chunk_cache_bytes > 1'000'000);
  budget.set(MemoryUse::sessions, UINT64_MAX / 4);
  service.fit_caches();
  const std::uint64_t held = budget.used(MemoryUse::chunk_cache) + budget.used(MemoryUse::patch_cache);
  CHECK(held <= kBudget / 16);
  CHECK(budget.for_caches(UINT64_MAX) == kBudget / 16);
}

TEST_CASE("generators are reckoned with an eighth of the budget at most, so that somebody can come") {
  const auto work = std::make_shared<FakeWork>();
  work->patch_columns = 4'000'000;
  Metrics metrics;
  MemoryBudget budget{128 * kMebibyte};
  ChunkService service{std::make_unique<FakeGenerator>(work),
                       {2, 4, 1000, kMebibyte, kMebibyte},
                       std::make_shared<spdlog::logger>("silent"),
                       metrics,
                       budget};
  service.start();
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(service.submit(client, {{1, 2, 3}, Lod{}}) == ChunkService::Submission::queued);
  client->await(1);
  CHECK(budget.used(MemoryUse::generators) == 16 * kMebibyte);
  CHECK(budget.takes_connections());
  CHECK(budget.takes_work());
}
