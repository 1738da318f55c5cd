#include "surface/regions/column_spread.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

constexpr auto kStep = static_cast<float>(kSampleStep);

std::int64_t cell_of(std::int64_t column) {
  return floor_div(column, kSampleStep) * kSampleStep;
}

/// The distance between columns if it is the same for all and divides a sample's cell, else 0.
std::int64_t step_of(std::span<const std::int64_t> xs) {
  if (xs.size() < 2) return 0;
  const std::int64_t step = xs[1] - xs[0];
  if (step < 1 || kSampleStep % step != 0 || floor_mod(xs[0], step) != 0) return 0;
  for (std::size_t i = 1; i < xs.size(); ++i) {
    if (xs[i] - xs[i - 1] != step) return 0;
  }
  return step;
}

}  // namespace

std::array<float, 4> line_shares(std::int64_t inside) {
  const float t = static_cast<float>(inside) / kStep;
  return {((2 - t) * t - 1) * t * 0.5F, ((3 * t - 5) * t * t + 2) * 0.5F, ((4 - 3 * t) * t + 1) * t * 0.5F,
          (t - 1) * t * t * 0.5F};
}

std::array<float, 4> line_rises(std::int64_t inside) {
  const float t = static_cast<float>(inside) / kStep;
  constexpr float kHalf = 0.5F / kStep;
  return {((4 - 3 * t) * t - 1) * kHalf, (9 * t - 10) * t * kHalf, ((8 - 9 * t) * t + 1) * kHalf,
          (3 * t - 2) * t * kHalf};
}

void ColumnSpread::start(std::span<const std::int64_t> xs, bool at_samples) {
  samples_.clear();
  offsets_.clear();
  at_samples_ = at_samples;
  columns_a_cell_ = 0;
  first_ = 0;
  row_size_ = padded(xs.size());
  if (at_samples) {
    samples_.assign(xs.begin(), xs.end());
  } else if (const std::int64_t step = step_of(xs); step != 0) {
    start_even(xs, step);
  } else {
    start_uneven(xs);
  }
  scratch_.resize(4 * padded(samples_.size()));
}

void ColumnSpread::start_even(std::span<const std::int64_t> xs, std::int64_t step) {
  columns_a_cell_ = static_cast<std::size_t>(kSampleStep / step);
  const std::int64_t west = cell_of(xs.front());
  for (std::int64_t x = west - kSampleStep; x <= cell_of(xs.back()) + 2 * kSampleStep; x += kSampleStep) {
    samples_.push_back(x);
  }
  first_ = static_cast<std::size_t>((xs.front() - west) / step);
  row_size_ = padded((samples_.size() - 3) * columns_a_cell_);
  for (std::size_t k = 0; k < columns_a_cell_; ++k) {
    fractions_[k] = static_cast<float>(static_cast<std::int64_t>(k) * step) / kStep;
  }
}

void ColumnSpread::start_uneven(std::span<const std::int64_t> xs) {
  for (const std::int64_t x : xs) {
    for (int k = -1; k < 3; ++k) samples_.push_back(cell_of(x) + k * kSampleStep);
  }
  std::sort(samples_.begin(), samples_.end());
  samples_.erase(std::unique(samples_.begin(), samples_.end()), samples_.end());
  for (const std::int64_t x : xs) {
    const auto west = std::lower_bound(samples_.begin(), samples_.end(), cell_of(x)) - samples_.begin();
    offsets_.push_back(
        {static_cast<std::size_t>(west), static_cast<float>(floor_mod(x, kSampleStep)) / kStep});
  }
}

void ColumnSpread::row(const RegionKernels& kernels, const float* values, float* out, float* rise) {
  if (at_samples_) {
    std::copy_n(values, samples_.size(), out);
  } else if (columns_a_cell_ == 0) {
    uneven_row(values, out, rise);
  } else {
    const Cells cells{samples_.size() - 3, columns_a_cell_, fractions_.data(), scratch_.data()};
    kernels.spread(values, cells, out, rise);
  }
}

// Gives the kernel's results to the bit.
void ColumnSpread::uneven_row(const float* values, float* out, float* rise) const {
  for (std::size_t i = 0; i < offsets_.size(); ++i) {
    const float* const at = values + offsets_[i].west;
    const float t = offsets_[i].fraction;
    const float first = (at[1] - at[-1]) * 0.5F;
    const float third = (at[2] - at[-1]) * 0.5F + (at[0] - at[1]) * 1.5F;
    const float second = at[1] - at[0] - first - third;
    out[i] = at[0] + t * (first + t * (second + t * third));
    if (rise != nullptr) rise[i] = (first + t * (second + second + t * (3 * third))) * (1 / kStep);
  }
}

}  // namespace talus::terrain
