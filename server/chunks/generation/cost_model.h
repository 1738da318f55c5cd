// Measured costs of work for the generators. For one thread; GenerationPool locks.
#pragma once

#include <chrono>
#include <cstdint>

#include "chunks/generation/work_costs.h"

namespace talus::server {

/// Thread time that one piece of work took, and the number of things that it made.
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

  /// Means of all that was added, in nanoseconds and never 0; guesses if nothing of a kind was added.
  [[nodiscard]] WorkCosts costs() const;

 private:
  MeasuredWork total_;
};

}  // namespace talus::server
