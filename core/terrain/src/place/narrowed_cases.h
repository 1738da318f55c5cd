// Of a list of cases, those that can be the first that holds somewhere along a row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernels/places.h"
#include "place/places.h"

namespace talus::terrain {

/// Most rows lie in one or two of a world's biomes. Keeps its memory from row to row. For one thread at a
/// time.
class NarrowedCases {
 public:
  /// What is left of `cases`, valid until the next call: without the conditions that hold all along the row,
  /// without cases that hold nowhere, and without those after a case that holds everywhere. `ranges[q]` is
  /// that of quantity q.
  [[nodiscard]] std::span<const Places::Case> of(std::span<const Places::Case> cases,
                                                 std::span<const ValueRange> ranges);

 private:
  enum class Holds : std::uint8_t { nowhere, somewhere, everywhere };
  [[nodiscard]] static Holds holds(const Places::Condition& condition, const ValueRange& range);

  std::vector<Places::Case> cases_;  // more may be kept for their memory
};

}  // namespace talus::terrain
