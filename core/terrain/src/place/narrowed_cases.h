// Of a list of cases, those that can be the first that holds somewhere along a row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernels/places.h"
#include "place/places.h"

namespace talus::terrain {

/// Most rows lie in one or two of a world's biomes, and most of their ranges on the same sides of all limits
/// as those of the row before: then what was left of that is kept. Of one list of cases, which must live as
/// long. For one thread at a time.
class NarrowedCases {
 public:
  explicit NarrowedCases(std::span<const Places::Case> all) : all_{all}, cases_(all.size()) {}

  /// What is left of them, valid until the next call: without the conditions that hold all along the row,
  /// without cases that hold nowhere, and without those after a case that holds everywhere. `ranges[q]` is
  /// that of quantity q.
  [[nodiscard]] std::span<const Places::Case> in(std::span<const ValueRange> ranges);

 private:
  enum class Holds : std::uint8_t { nowhere, somewhere, everywhere };
  /// The limits next to the ends of a quantity's range, among those that it was compared with: at least
  /// `from`, less than `to`.
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
  std::vector<Places::Case> cases_;  // more are kept for their memory
  std::size_t count_ = 0;            // in use
  std::vector<Limits> limits_;       // none before the first row
};

}  // namespace talus::terrain
