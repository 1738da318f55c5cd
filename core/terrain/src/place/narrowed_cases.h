// Narrows a list of cases to those that can be the first that holds somewhere along a row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernels/places.h"
#include "place/places.h"

namespace talus::terrain {

/// Most rows lie in one or two biomes of the world, and most of their ranges lie on the same sides of all
/// limits as the ranges of the row before, so the last result is cached. Not thread-safe; the list must
/// outlive it.
class NarrowedCases {
 public:
  explicit NarrowedCases(std::span<const Places::Case> all) : all_{all}, cases_(all.size()) {}

  /// Returns the remaining cases, valid until the next call: without conditions that hold along the whole
  /// row, without cases that hold nowhere, and without cases after one that holds everywhere. `ranges[q]` is
  /// the range of quantity q.
  [[nodiscard]] std::span<const Places::Case> in(std::span<const ValueRange> ranges);

 private:
  enum class Holds : std::uint8_t { nowhere, somewhere, everywhere };
  /// The limits nearest to the ends of a quantity's range among those it was compared with: a range with ends
  /// in [from, to) gives the same result.
  struct Limits {
    QuantityNumber quantity = 0;
    ValueRange from;
    ValueRange to;
  };
  [[nodiscard]] static Holds holds(const Places::Condition& condition, const ValueRange& range);
  [[nodiscard]] bool as_before(std::span<const ValueRange> ranges) const;
  void compared(const Places::Condition& condition, const ValueRange& range);
  void narrow(std::span<const ValueRange> ranges);

  std::span<const Places::Case> all_;
  std::vector<Places::Case> cases_;  // extra elements are kept for their memory
  std::size_t count_ = 0;            // in use
  std::vector<Limits> limits_;       // empty before the first row
};

}  // namespace talus::terrain
