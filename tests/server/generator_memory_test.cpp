#include "chunks/generation/generator_memory.h"

#include <barrier>
#include <catch2/catch.hpp>
#include <memory>
#include <thread>

#include "chunks/generation/patch_size.h"
#include "runtime/log/logger.h"

using namespace talus::server;

namespace {

constexpr std::size_t kMebibyte = std::size_t{1} << 20;

Logger silent() {
  return make_logger("off", "text");
}

}  // namespace

TEST_CASE("a patch in the making takes what its halo does") {
  using namespace std::chrono_literals;
  CHECK(patch_size(1, 1ms, 128).bytes_in_the_making() == 288 * 288 * 64);
  CHECK(patch_size(4, 1ms, 0).bytes_in_the_making() == 128 * 128 * 64);
}

TEST_CASE("returned patches are limited to an eighth of the budget, also before any was made") {
  MemoryBudget budget{256 * kMebibyte};
  GeneratorMemory memory{budget, 2, silent(), 10 * kMebibyte};
  CHECK(memory.max_begun() == 3);
  memory.note_patch(4 * kMebibyte);  // five times this is more
  CHECK(memory.max_begun() == 1);
  memory.note_patch(100 * kMebibyte);
  CHECK(memory.max_begun() == 0);
}

TEST_CASE("small patches are put back up to a number, and without a limit of memory as well") {
  MemoryBudget small{256 * kMebibyte};
  CHECK(GeneratorMemory{small, 2, silent(), 1000}.max_begun() == GeneratorMemory::kMaxBegun);
  MemoryBudget none{0};
  CHECK(GeneratorMemory{none, 2, silent(), kMebibyte << 10}.max_begun() == GeneratorMemory::kMaxBegun);
}

TEST_CASE("returned patches count in the budget as long as they exist") {
  MemoryBudget budget{256 * kMebibyte};
  GeneratorMemory memory{budget, 2, silent(), 2 * kMebibyte};
  memory.note_patch(1);
  const auto at_work = budget.used(MemoryUse::generators);
  CHECK(at_work == 4 * kMebibyte);
  memory.add_begun(2);
  memory.add_begun(1);
  CHECK(budget.used(MemoryUse::generators) == at_work + 6 * kMebibyte);
  memory.add_begun(-3);
  CHECK(budget.used(MemoryUse::generators) == at_work);
}

TEST_CASE("an end that is reported before its begin is harmless") {
  MemoryBudget budget{256 * kMebibyte};
  GeneratorMemory memory{budget, 2, silent(), 2 * kMebibyte};
  memory.note_patch(1);
  const auto at_work = budget.used(MemoryUse::generators);
  memory.add_begun(-1);
  CHECK(budget.used(MemoryUse::generators) == at_work);
  memory.add_begun(1);
  CHECK(budget.used(MemoryUse::generators) == at_work);
}

// Else connections may be refused for good: nothing else would tell the budget of what is no more.
TEST_CASE("patches that threads return and take at once count in the budget at the end") {
  MemoryBudget budget{256 * kMebibyte};
  GeneratorMemory memory{budget, 2, silent(), 2 * kMebibyte};
  memory.note_patch(1);
  const auto at_work = budget.used(MemoryUse::generators);
  constexpr int kRounds = 20'000;
  std::barrier both{2};
  std::thread other{[&] {
    for (int round = 0; round < kRounds; ++round) {
      both.arrive_and_wait();
      memory.add_begun(-1);
      both.arrive_and_wait();
    }
  }};
  int wrong = 0;
  for (int round = 0; round < kRounds; ++round) {
    memory.add_begun(2);
    both.arrive_and_wait();
    memory.add_begun(-1);
    both.arrive_and_wait();
    if (budget.used(MemoryUse::generators) != at_work) ++wrong;
  }
  other.join();
  CHECK(wrong == 0);
}
