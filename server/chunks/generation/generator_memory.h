// Reports the memory of generators at work to a MemoryBudget. Callable from any thread.
#pragma once

#include <atomic>
#include <cstddef>

#include "limits/memory/memory_budget.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Estimates by the largest patch so far, as what a generator allocates grows with what it makes.
class GeneratorMemory {
 public:
  /// A generator at work holds this many times the bytes of a patch: fields of the patch and its halo, planes
  /// for the next, the patch itself, and one to spare.
  static constexpr std::size_t kPatchesAtWork = 5;
  /// Maximum part of the budget that counts as the generators': more would refuse all clients for good.
  static constexpr std::uint64_t kLargestShare = 8;

  /// `piece_bytes`: estimate of what a patch in the making takes with its halo; 0: unknown. `ground_bytes`:
  /// what all generators keep together.
  GeneratorMemory(MemoryBudget& budget, std::size_t threads, Logger log, std::size_t piece_bytes = 0,
                  std::size_t ground_bytes = 0);

  /// Maximum number of patches that were begun and wait, so that no more yield: as many as are an eighth of
  /// the budget. 0 if memory is too short for one: then each is made whole.
  [[nodiscard]] std::size_t max_begun() const;
  static constexpr std::size_t kMaxBegun = 16;
  /// Changes the number of patches that were begun and wait.
  void add_begun(std::ptrdiff_t change);

  /// A patch of `bytes` was made. If the generators need a quarter more than their share, which is as much as
  /// patches differ, this is logged once.
  void note_patch(std::size_t bytes);

 private:
  /// Returns the bytes of a patch in the making.
  [[nodiscard]] std::uint64_t each_bytes() const;
  /// Returns the bytes of the generators as they count in the budget.
  [[nodiscard]] std::uint64_t bytes();
  void tell_budget();

  MemoryBudget& budget_;
  const std::size_t threads_;
  const std::size_t piece_bytes_;
  const std::size_t ground_bytes_;
  const Logger log_;
  std::atomic<std::size_t> largest_patch_bytes_{0};
  std::atomic<std::ptrdiff_t> begun_{0};  // below 0 if a change is reported before the one before it
  std::atomic<bool> warned_{false};
};

}  // namespace talus::server
