// From samples, every sixteenth column, to the columns between: cubics with the samples' own slopes, those of
// the lines through their neighbours (Catmull and Rom). So nothing that is interpolated has a crease.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/vectors/aligned.h>

#include "kernels/regions.h"
#include "surface/regions/regions.h"

namespace talus::terrain {

/// How much of each of the four lines around a row its samples are, and of how they rise a column southward.
/// `inside`: rows from the second line to it.
[[nodiscard]] std::array<float, 4> line_shares(std::int64_t inside);
[[nodiscard]] std::array<float, 4> line_rises(std::int64_t inside);

class ColumnSpread {
 public:
  /// Over these ascending base columns. `at_samples`: each of them is one, and nothing is between.
  void start(std::span<const std::int64_t> xs, bool at_samples);

  /// The samples that are needed, ascending multiples of kSampleStep.
  [[nodiscard]] const std::vector<std::int64_t>& samples() const { return samples_; }
  /// The first column's place in a row that is written, and how long such a row is at least.
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t row_size() const { return row_size_; }
  /// From one sample to the next, 0 where columns are uneven or samples; and where they lie, of the way.
  [[nodiscard]] std::size_t columns_a_cell() const { return columns_a_cell_; }
  [[nodiscard]] const float* fractions() const { return fractions_.data(); }

  /// From values at the samples, padded, those at the columns, and how they rise a column eastward, which may
  /// be null.
  void row(const RegionKernels& kernels, const float* values, float* out, float* rise);

 private:
  void start_even(std::span<const std::int64_t> xs, std::int64_t step);
  void start_uneven(std::span<const std::int64_t> xs);
  void uneven_row(const float* values, float* out, float* rise) const;

  struct Offset {
    std::size_t west = 0;  // the sample
    float fraction = 0;
  };

  std::vector<std::int64_t> samples_;
  bool at_samples_ = false;
  std::size_t columns_a_cell_ = 0;  // 0: they are uneven
  std::size_t first_ = 0;
  std::size_t row_size_ = 0;
  std::array<float, kSampleStep> fractions_{};
  std::vector<Offset> offsets_;  // of uneven columns
  AlignedVector<float> scratch_;
};

}  // namespace talus::terrain
