#include "surface/height_map_rows.h"

#include <algorithm>
#include <cmath>

#include <talus/voxel/coords.h>

#include "surface/cubic.h"

namespace talus::terrain {
namespace {

constexpr int kVoxelBits = 16;

// Maps 0 to 2^16 to 0 to 2^24, level at both ends: 3 s^2 - 2 s^3.
std::int64_t smooth(std::int64_t s) {
  return (s * s * (3 * 65536 - 2 * s)) >> 24;
}

}  // namespace

HeightMapRows::HeightMapRows(const Surface& surface, std::unique_ptr<SurfaceRows> around)
    : map_{surface.map}, highest_fx_{highest_height_fx(surface)}, around_{std::move(around)} {}

std::int32_t HeightMapRows::sample_of(std::int64_t index, int samples) const {
  if (index >= 0 && index < samples) return static_cast<std::int32_t>(index);
  if (map_.outside == Outside::sea) return kNoSample;
  if (map_.outside == Outside::repeat) {
    return static_cast<std::int32_t>(floor_mod(index, std::int64_t{samples}));
  }
  // Mirrored back and forth; the samples at the edges count once.
  const std::int64_t turn = floor_mod(index, 2 * (std::int64_t{samples} - 1));
  return static_cast<std::int32_t>(turn < samples ? turn : 2 * (std::int64_t{samples} - 1) - turn);
}

HeightMapRows::Taps HeightMapRows::taps_at(std::int64_t column, std::int64_t origin_q16,
                                           std::int64_t spacing_q16, int samples) const {
  const std::int64_t distance = column * (std::int64_t{1} << kVoxelBits) - origin_q16;
  Taps taps;
  taps.first = floor_div(distance, spacing_q16) - 1;
  taps.weight = cubic_weights((floor_mod(distance, spacing_q16) << kPlaceBits) / spacing_q16);
  for (std::size_t i = 0; i < 4; ++i) {
    taps.sample[i] = sample_of(taps.first + static_cast<std::int64_t>(i), samples);
  }
  return taps;
}

std::int64_t HeightMapRows::share_of_map(std::int64_t column, std::int64_t origin_q16,
                                         std::int64_t spacing_q16, int samples) const {
  const std::int64_t distance = column * (std::int64_t{1} << kVoxelBits) - origin_q16;
  const std::int64_t inside = std::min(distance, (samples - 1) * spacing_q16 - distance);
  if (inside <= 0) return 0;
  return inside >= map_.margin_q16 ? kAllMap : smooth((inside << 16) / map_.margin_q16);
}

void HeightMapRows::start(std::span<const std::int64_t> xs) {
  const Field& heights = *map_.heights_fx;
  columns_.clear();
  for (const std::int64_t x : xs) {
    columns_.push_back(taps_at(x, map_.x_q16, map_.spacing_x_q16, heights.width));
  }
  for (Line& line : lines_) line.drawn = false;
  if (!around_) return;
  around_->start(xs);
  shares_.clear();
  for (const std::int64_t x : xs) {
    shares_.push_back(share_of_map(x, map_.x_q16, map_.spacing_x_q16, heights.width));
  }
  const auto [least, most] = std::minmax_element(shares_.begin(), shares_.end());
  min_share_ = *least;
  max_share_ = *most;
}

void HeightMapRows::draw(std::int64_t sample_z, std::int32_t map_row, Line& line) const {
  line.drawn = true;
  line.sample_z = sample_z;
  line.values.assign(columns_.size(), 0);
  if (map_row == kNoSample) return;
  const std::int32_t* samples = map_.heights_fx->row(map_row).data();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Taps& taps = columns_[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (taps.sample[k] != kNoSample) line.values[i] += taps.weight[k] * samples[taps.sample[k]];
    }
  }
}

void HeightMapRows::map_row(std::int64_t z, std::int32_t* heights_fx) {
  const Taps taps = taps_at(z, map_.z_q16, map_.spacing_z_q16, map_.heights_fx->depth);
  std::array<const std::int64_t*, 4> values{};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int64_t sample_z = taps.first + static_cast<std::int64_t>(k);
    Line& line = lines_[static_cast<std::size_t>(floor_mod(sample_z, std::int64_t{4}))];
    if (!line.drawn || line.sample_z != sample_z) draw(sample_z, taps.sample[k], line);
    values[k] = line.values.data();
  }
  constexpr std::int64_t kHalf = std::int64_t{1} << (2 * kCubicBits - 1);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::int64_t sum = taps.weight[0] * values[0][i] + taps.weight[1] * values[1][i] +
                             taps.weight[2] * values[2][i] + taps.weight[3] * values[3][i];
    // A cubic overshoots its samples next to a cliff.
    heights_fx[i] = static_cast<std::int32_t>(
        std::clamp<std::int64_t>((sum + kHalf) >> (2 * kCubicBits), 0, highest_fx_));
  }
}

void HeightMapRows::blend_row(std::int64_t z, std::int32_t* heights_fx) {
  const std::int64_t share_z = share_of_map(z, map_.z_q16, map_.spacing_z_q16, map_.heights_fx->depth);
  const bool no_map = share_z == 0 || max_share_ == 0;
  if (no_map) return around_->row(z, heights_fx);
  const bool all_map = share_z == kAllMap && min_share_ == kAllMap;
  if (all_map) return map_row(z, heights_fx);
  around_->row(z, heights_fx);
  of_map_.resize(columns_.size());
  map_row(z, of_map_.data());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::int64_t share = (shares_[i] * share_z) / kAllMap;
    heights_fx[i] = static_cast<std::int32_t>(
        (share * of_map_[i] + (kAllMap - share) * heights_fx[i] + kAllMap / 2) / kAllMap);
  }
}

void HeightMapRows::row(std::int64_t z, std::int32_t* heights_fx) {
  if (around_) {
    blend_row(z, heights_fx);
  } else {
    map_row(z, heights_fx);
  }
}

}  // namespace talus::terrain
