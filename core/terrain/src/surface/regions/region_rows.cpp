#include "surface/regions/region_rows.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

std::int64_t cell_of(std::int64_t column) {
  return floor_div(column, kSampleStep) * kSampleStep;
}

/// The distance between neighbours, where it is the same everywhere and a sample's cell has a whole number of
/// them; else 0.
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

RegionRows::RegionRows(const Regions& regions, float highest_fx, InstructionSet set)
    : regions_{regions},
      highest_fx_{highest_fx},
      kernels_{&region_kernels(set)},
      lines_{regions_.slow, regions_.shape, set},
      shape_{set} {}

void RegionRows::start(std::span<const std::int64_t> xs) {
  width_ = xs.size();
  lay_out(xs);
  lines_.start(samples_);
  shape_.start(regions_.shape, xs);
  const std::size_t spread_width = columns_a_cell_ == 0 ? width_ : samples_.size() * columns_a_cell_;
  for (std::size_t slow = 0; slow < kSlowCount; ++slow) {
    spread_[slow].resize(padded(spread_width));
    at_columns_[slow] = spread_[slow].data() + skipped_;
  }
  for (auto& octave : octaves_) octave.resize(padded(width_));
  blended_.resize(samples_.size());
  heights_.resize(padded(width_));
}

void RegionRows::lay_out(std::span<const std::int64_t> xs) {
  samples_.clear();
  places_.clear();
  skipped_ = 0;
  const std::int64_t step = step_of(xs);
  columns_a_cell_ = step == 0 ? 0 : static_cast<std::size_t>(kSampleStep / step);
  if (step != 0) {
    for (std::int64_t x = cell_of(xs.front()); x <= cell_of(xs.back()) + kSampleStep; x += kSampleStep) {
      samples_.push_back(x);
    }
    skipped_ = static_cast<std::size_t>((xs.front() - samples_.front()) / step);
    for (std::size_t k = 0; k < columns_a_cell_; ++k) {
      fractions_[k] =
          static_cast<float>(static_cast<std::int64_t>(k) * step) / static_cast<float>(kSampleStep);
    }
    return;
  }
  for (const std::int64_t x : xs) {
    samples_.push_back(cell_of(x));
    if (floor_mod(x, kSampleStep) != 0) samples_.push_back(cell_of(x) + kSampleStep);
  }
  std::sort(samples_.begin(), samples_.end());
  samples_.erase(std::unique(samples_.begin(), samples_.end()), samples_.end());
  for (const std::int64_t x : xs) {
    const auto west = static_cast<std::size_t>(
        std::lower_bound(samples_.begin(), samples_.end(), cell_of(x)) - samples_.begin());
    const std::int64_t inside = floor_mod(x, kSampleStep);
    places_.push_back(
        {west, inside == 0 ? west : west + 1, static_cast<float>(inside) / static_cast<float>(kSampleStep)});
  }
}

void RegionRows::spread(const float* samples, std::size_t slow) {
  float* const out = spread_[slow].data();
  if (columns_a_cell_ != 0) {
    return kernels_->spread(samples, samples_.size() - 1, columns_a_cell_, fractions_.data(), out);
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& at = places_[i];
    out[i] = samples[at.west] + (samples[at.east] - samples[at.west]) * at.fraction;
  }
}

void RegionRows::row(std::int64_t z, std::int32_t* heights_fx) {
  const std::int64_t north_z = cell_of(z);
  const auto fraction = static_cast<float>(z - north_z) / static_cast<float>(kSampleStep);
  const SlowLine& north = lines_.at(north_z);
  if (z == north_z) {
    for (std::size_t slow = 0; slow < kSlowCount; ++slow) spread(north[slow].data(), slow);
  } else {
    const SlowLine& south = lines_.at(north_z + kSampleStep);
    for (std::size_t slow = 0; slow < kSlowCount; ++slow) {
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        blended_[i] = north[slow][i] + (south[slow][i] - north[slow][i]) * fraction;
      }
      spread(blended_.data(), slow);
    }
  }
  RegionRow at{slow(Slow::base),        slow(Slow::belt),        slow(Slow::hills),
               slow(Slow::mesa),        slow(Slow::terrace),     slow(Slow::river),
               slow(Slow::tributary_a), slow(Slow::tributary_b), {}};
  for (std::size_t k = 0; k < kShapeOctaves; ++k) {
    if (k < static_cast<std::size_t>(kSlowOctaves)) {
      at.shape[k] = at_columns_[static_cast<std::size_t>(Slow::shape_0) + k];
    } else {
      const float* const octave = shape_.octave(static_cast<int>(k), z);
      std::copy_n(octave, width_, octaves_[k].begin());
      at.shape[k] = octaves_[k].data();
    }
  }
  kernels_->compose(at, regions_.at_columns, width_, highest_fx_, heights_.data());
  std::copy_n(heights_.begin(), width_, heights_fx);
}

}  // namespace talus::terrain
