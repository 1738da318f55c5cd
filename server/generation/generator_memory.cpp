#include "generation/generator_memory.h"

#include <algorithm>
#include <utility>

namespace talus::server {

GeneratorMemory::GeneratorMemory(MemoryBudget& budget, std::size_t threads, Logger log)
    : budget_{budget}, threads_{threads}, log_{std::move(log)} {}

void GeneratorMemory::note_patch(std::size_t bytes) {
  std::size_t largest = largest_patch_bytes_.load();
  while (bytes > largest && !largest_patch_bytes_.compare_exchange_weak(largest, bytes)) {
  }
  tell_budget();
}

void GeneratorMemory::add_begun(std::ptrdiff_t change) {
  if (change == 0) return;
  begun_ += static_cast<std::size_t>(change);
  tell_budget();
}

std::size_t GeneratorMemory::max_begun() const {
  const std::uint64_t each = kPatchesAtWork * largest_patch_bytes_.load();
  if (budget_.limit_bytes() == 0 || each == 0) return kMostBegun;
  const std::uint64_t fit = budget_.limit_bytes() / kLargestShare / each;
  return std::clamp<std::uint64_t>(fit, threads_ + 2, threads_ + kMostBegun) - threads_;
}

void GeneratorMemory::tell_budget() {
  const std::uint64_t each = kPatchesAtWork * largest_patch_bytes_.load();
  const std::uint64_t at_work = threads_ * each;
  const std::uint64_t needed = at_work + begun_.load() * each;
  const std::uint64_t share = budget_.limit_bytes() == 0 ? needed : budget_.limit_bytes() / kLargestShare;
  if (at_work > share && !warned_.exchange(true)) {
    log_->warn(
        "generators at work may take {} MiB, more than an eighth of limits.memory_bytes ({} MiB): raise "
        "that, or set fewer threads.generator or a smaller generation.patch_tiles",
        at_work >> 20U, budget_.limit_bytes() >> 20U);
  }
  budget_.set(MemoryUse::generators, std::min(needed, share));
}

}  // namespace talus::server
