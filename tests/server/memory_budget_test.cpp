#include "limits/memory/memory_budget.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include <rapidcheck.h>

#include "limits/memory/memory_reservation.h"

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
  budget.set(MemoryUse::jobs, 1);
  hold(budget, 500 * kMebibyte);
  CHECK_FALSE(budget.takes_connections());
  CHECK(budget.takes_work());
  hold(budget, 600 * kMebibyte);
  CHECK_FALSE(budget.takes_work());
  hold(budget, 550 * kMebibyte);
  CHECK_FALSE(budget.takes_work());
  CHECK_FALSE(budget.takes_jobs());
  hold(budget, 499 * kMebibyte);
  CHECK(budget.takes_work());
  CHECK(budget.takes_jobs());
  CHECK_FALSE(budget.takes_connections());
  hold(budget, 399 * kMebibyte);
  CHECK(budget.takes_connections());
}

TEST_CASE("permanent memory of edits refuses no client once all sessions have ended") {
  MemoryBudget budget{kBudget};
  budget.set(MemoryUse::edits, 450 * kMebibyte);
  budget.set(MemoryUse::sessions, 50 * kMebibyte);
  CHECK_FALSE(budget.takes_connections());
  budget.set(MemoryUse::sessions, 1);
  CHECK_FALSE(budget.takes_connections());  // another may end
  budget.set(MemoryUse::sessions, 0);
  CHECK(budget.takes_connections());
  budget.set(MemoryUse::sessions, kMebibyte);
  CHECK(budget.takes_connections());
}

TEST_CASE(
    "the cache of edits is a cache: it shrinks, others leave it its room, and it does not refuse clients") {
  MemoryBudget budget{kBudget};
  budget.set(MemoryUse::edit_cache, 600 * kMebibyte);
  CHECK(budget.takes_connections());
  CHECK(budget.takes_work());
  hold(budget, 300 * kMebibyte);
  CHECK(budget.for_edit_cache(kBudget) == 50 * kMebibyte);  // an eighth of what is left of 700
  CHECK(budget.for_edit_cache(kMebibyte) == kMebibyte);
  budget.set(MemoryUse::edit_cache, 50 * kMebibyte);
  CHECK(budget.for_caches(kBudget) == 350 * kMebibyte);
  hold(budget, 700 * kMebibyte);
  CHECK(budget.for_edit_cache(kBudget) == kBudget / 64);
  CHECK(MemoryBudget{0}.for_edit_cache(kMebibyte) == kMebibyte);
}

TEST_CASE("without jobs no client waits for memory that is not returned") {
  MemoryBudget budget{kBudget};
  int resumed = 0;
  budget.when_jobs_resume([&] { ++resumed; });
  budget.set(MemoryUse::jobs, 100 * kMebibyte);
  hold(budget, 550 * kMebibyte);
  CHECK_FALSE(budget.takes_jobs());
  budget.set(MemoryUse::jobs, 0);
  CHECK(budget.takes_jobs());
  CHECK(budget.takes_work());
  CHECK(resumed == 1);
  // Idle sessions and generators come to 3/4 at most.
  hold(budget, 600 * kMebibyte);
  CHECK(budget.takes_work());
  // Somewhat above one may have jobs, and nobody more of anything else.
  hold(budget, 650 * kMebibyte);
  CHECK(budget.takes_jobs());
  CHECK_FALSE(budget.takes_work());
  budget.set(MemoryUse::jobs, 1);
  CHECK_FALSE(budget.takes_jobs());
  budget.set(MemoryUse::jobs, 0);
  CHECK(budget.takes_jobs());
  CHECK(resumed == 2);
  // The last eighth is nobody's.
  hold(budget, 700 * kMebibyte);
  CHECK_FALSE(budget.takes_jobs());
  hold(budget, 699 * kMebibyte);
  CHECK(budget.takes_jobs());
  CHECK(resumed == 3);
}

TEST_CASE("while work is taken, it and the caches together are below the budget") {
  CHECK(rc::check([] {
    MemoryBudget budget{*rc::gen::inRange<std::uint64_t>(64 * kMebibyte, 1024 * 1024 * kMebibyte)};
    const auto beside = *rc::gen::inRange<std::uint64_t>(MemoryBudget::kProgramBytes, budget.limit_bytes());
    hold(budget, beside);
    if (!budget.takes_work()) return;
    budget.set(MemoryUse::edit_cache, budget.for_edit_cache(UINT64_MAX));
    budget.set(MemoryUse::column_cache, *rc::gen::inRange<std::uint64_t>(0, budget.limit_bytes() / 64));
    const std::uint64_t caches = budget.for_caches(UINT64_MAX) + budget.used(MemoryUse::edit_cache) +
                                 budget.used(MemoryUse::column_cache);
    RC_ASSERT(beside + caches <= budget.limit_bytes() / 8 * 7 + 7);
  }));
}

TEST_CASE("memory that a holder reports is returned with it, whatever other threads do") {
  MemoryBudget budget{kBudget};
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (std::uint64_t i = 0; i < 1000; ++i) {
        MemoryReservation share{budget, MemoryUse::sessions};
        share.hold(i * 5000);
        share.hold(i * 100);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(budget.used(MemoryUse::sessions) == 0);
}

TEST_CASE("work resumes once each time that enough memory is returned, by any holder") {
  MemoryBudget budget{kBudget};
  budget.set(MemoryUse::jobs, 1);
  int resumed = 0;
  budget.when_jobs_resume([&] {
    CHECK(budget.takes_jobs());
    ++resumed;
  });
  for (int again = 1; again <= 3; ++again) {
    hold(budget, 600 * kMebibyte);
    hold(budget, 500 * kMebibyte - 1);
    CHECK(resumed == again - 1);
    budget.add(MemoryUse::sessions, -1);
    CHECK(resumed == again);
    hold(budget, 100 * kMebibyte);
    CHECK(resumed == again);
  }
  budget.when_jobs_resume(nullptr);
  hold(budget, 600 * kMebibyte);
  hold(budget, 100 * kMebibyte);
  CHECK(resumed == 3);
}

TEST_CASE("the gate ends in the state that the level implies, whatever threads take and give at once") {
  MemoryBudget budget{kBudget};
  std::atomic<int> resumed{0};
  budget.when_jobs_resume([&] { ++resumed; });
  for (int round = 0; round < 200; ++round) {
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread) {
      threads.emplace_back([&] {
        for (int i = 0; i < 50; ++i) {
          budget.add(MemoryUse::jobs, 200 * kMebibyte);
          budget.add(MemoryUse::jobs, -std::int64_t{200 * kMebibyte});
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    REQUIRE(budget.takes_work());
    REQUIRE(budget.takes_connections());
  }
}

TEST_CASE("a gate closes at one level and opens below another") {
  HysteresisGate gate{10, 5, 12};
  std::uint64_t now = 0;
  bool settled = false;
  const auto update = [&](std::uint64_t to) {
    now = to;
    return gate.update([&] { return now; }, [&] { return settled; });
  };
  CHECK_FALSE(update(9));
  CHECK(gate.open());
  CHECK_FALSE(update(10));
  CHECK_FALSE(gate.open());
  CHECK_FALSE(update(5));
  CHECK_FALSE(gate.open());
  CHECK(update(4));
  CHECK(gate.open());
  CHECK_FALSE(update(9));
  CHECK(gate.open());
  settled = true;
  CHECK_FALSE(update(11));
  CHECK(gate.open());
  CHECK_FALSE(update(12));
  CHECK_FALSE(gate.open());
  CHECK(update(11));
  settled = false;
  CHECK_FALSE(update(11));
  CHECK_FALSE(gate.open());
}
