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
  const std::uint64_t needed = threads_ * kPatchesAtWork * std::max(bytes, largest);
  const std::uint64_t share = budget_.limit_bytes() == 0 ? needed : budget_.limit_bytes() / kLargestShare;
  if (needed > share && !warned_.exchange(true)) {
    log_->warn(
        "generators at work may take {} MiB, more than an eighth of limits.memory_bytes ({} MiB): raise "
        "that, or set fewer threads.generator or a smaller generation.patch_tiles",
        needed >> 20U, budget_.limit_bytes() >> 20U);
  }
  budget_.set(MemoryUse::generators, std::min(needed, share));
}

}  // namespace talus::server
