#include "chunks/generation/generator_memory.h"

#include <algorithm>
#include <utility>

namespace talus::server {

GeneratorMemory::GeneratorMemory(MemoryBudget& budget, std::size_t threads, Logger log,
                                 std::size_t piece_bytes, std::size_t ground_bytes)
    : budget_{budget},
      threads_{threads},
      piece_bytes_{piece_bytes},
      ground_bytes_{ground_bytes},
      log_{std::move(log)} {
  (void)bytes();  // logs if they lack room
}

void GeneratorMemory::note_patch(std::size_t bytes) {
  std::size_t largest = largest_patch_bytes_.load();
  while (bytes > largest && !largest_patch_bytes_.compare_exchange_weak(largest, bytes)) {
  }
  tell_budget();
}

void GeneratorMemory::add_begun(std::ptrdiff_t change) {
  if (change == 0) return;
  begun_ += change;
  tell_budget();
}

std::size_t GeneratorMemory::max_begun() const {
  const std::uint64_t each = each_bytes();
  if (budget_.limit_bytes() == 0 || each == 0) return kMaxBegun;
  return std::min<std::uint64_t>(kMaxBegun, budget_.limit_bytes() / kLargestShare / each);
}

std::uint64_t GeneratorMemory::each_bytes() const {
  return std::max<std::uint64_t>(piece_bytes_, kPatchesAtWork * largest_patch_bytes_.load());
}

std::uint64_t GeneratorMemory::bytes() {
  const std::uint64_t at_work = ground_bytes_ + threads_ * each_bytes();
  const auto begun = static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(0, begun_.load())) * each_bytes();
  if (budget_.limit_bytes() == 0) return at_work + begun;
  const std::uint64_t share = budget_.limit_bytes() / kLargestShare;
  if (at_work > share + share / 4 && !warned_.exchange(true)) {
    log_->warn(
        "generators at work may take {} MiB, more than an eighth of limits.memory_bytes ({} MiB), and the "
        "rest is beyond it: raise that to {} MiB, or set fewer threads.generator or a smaller "
        "generation.patch_tiles",
        at_work >> 20U, budget_.limit_bytes() >> 20U, (at_work * kLargestShare >> 20U) + 1);
  }
  return std::min(at_work, share) + std::min(begun, share);
}

// A thread that reported a value that another has changed since would leave the budget with the old one. So
// each thread reads again after reporting: either it sees the other's change, or the other reports after it.
void GeneratorMemory::tell_budget() {
  std::uint64_t told = 0;
  std::uint64_t now = bytes();
  do {
    told = now;
    budget_.set(MemoryUse::generators, told);
    now = bytes();
  } while (now != told);
}

}  // namespace talus::server
