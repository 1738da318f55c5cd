// What work for the generators costs, as measured so far. For one thread; GenerationPool locks.
#pragma once

#include <chrono>
#include <cstdint>

#include "chunks/generation/work_costs.h"

namespace talus::server {

/// Thread time that one piece of work took, and what it made in it.
struct MeasuredWork {
  std::chrono::nanoseconds patch_time{};
  std::chrono::nanoseconds chunk_time{};
  std::chrono::nanoseconds height_time{};
  std::chrono::nanoseconds map_time{};
  std::uint64_t patches = 0;
  std::uint64_t chunks = 0;
  std::uint64_t heights = 0;  // columns
};

class CostModel {
 public:
  void add(const MeasuredWork& work);

  /// Means of all that was added, in nanoseconds and never 0; guesses where nothing of a kind was.
  [[nodiscard]] WorkCosts costs() const;

 private:
  MeasuredWork total_;
};

}  // namespace talus::server
