// From samples, at every sixteenth column, to the columns between: cubics whose slope at a sample is the
// slope of the line through its neighbours (Catmull and Rom), so that interpolated fields have no creases.
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

/// Weights of the four lines around a row in its samples, and in their rise per column southward. `inside`:
/// rows from the second line to it.
[[nodiscard]] std::array<float, 4> line_shares(std::int64_t inside);
[[nodiscard]] std::array<float, 4> line_rises(std::int64_t inside);

class ColumnSpread {
 public:
  /// The following rows are over these ascending base columns. `at_samples`: true if all of them are samples.
  void start(std::span<const std::int64_t> xs, bool at_samples);

  /// The required samples, ascending multiples of kSampleStep.
  [[nodiscard]] const std::vector<std::int64_t>& samples() const { return samples_; }
  /// Index of the first column in an output row, and minimum length of such a row.
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t row_size() const { return row_size_; }
  /// Columns from one sample to the next, 0 if columns are uneven or all are samples; and their positions
  /// between samples, 0 to 1.
  [[nodiscard]] std::size_t columns_a_cell() const { return columns_a_cell_; }
  [[nodiscard]] const float* fractions() const { return fractions_.data(); }

  /// Interpolates values at the samples, padded, to the columns. `rise`: per column eastward, or null.
  void row(const RegionKernels& kernels, const float* values, float* out, float* rise);

 private:
  void start_even(std::span<const std::int64_t> xs, std::int64_t step);
  void start_uneven(std::span<const std::int64_t> xs);
  void uneven_row(const float* values, float* out, float* rise) const;

  struct Offset {
    std::size_t west = 0;  // index of the sample
    float fraction = 0;
  };

  std::vector<std::int64_t> samples_;
  bool at_samples_ = false;
  std::size_t columns_a_cell_ = 0;  // 0: uneven columns
  std::size_t first_ = 0;
  std::size_t row_size_ = 0;
  std::array<float, kSampleStep> fractions_{};
  std::vector<Offset> offsets_;  // for uneven columns
  AlignedVector<float> scratch_;
};

}  // namespace talus::terrain
