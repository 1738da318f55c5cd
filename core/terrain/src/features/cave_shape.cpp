#include "features/cave_shape.h"

#include <algorithm>
#include <cstdlib>

#include <talus/terrain/world.h>

namespace talus::terrain {
namespace {

constexpr std::int32_t kOne = 1 << 16;               // of what a dome's shape is counted in
constexpr std::int32_t kWall_noise = kNoiseOne / 6;  // noise from a chamber's wall to its full height

std::int32_t noise_of(float value) {
  return static_cast<std::int32_t>(value * static_cast<float>(kNoiseOne));
}

// A dome's height at `share` of the way in from its wall: steep beside the wall, level in the middle.
std::int32_t bulge(std::int32_t share) {
  const std::int64_t out = kOne - share;
  return static_cast<std::int32_t>(kOne - ((out * out) >> 16));
}

std::int32_t part(std::int32_t whole, std::int32_t share) {
  return static_cast<std::int32_t>((std::int64_t{whole} * share) >> 16);
}

}  // namespace

void CaveShape::start(std::span<const std::int64_t> xs) {
  width_ = xs.size();
  tunnels_.start(plan_.tunnels, xs);
  chambers_.start(plan_.chambers, xs);
  climb_.start(plan_.climb, xs);
  if (tunnel_noise_.size() < width_) {
    tunnel_noise_.resize(width_);
    chamber_noise_.resize(width_);
  }
}

std::int32_t CaveShape::lowest_floor_fx() const {
  const std::int32_t deepest = std::max(plan_.height_fx, plan_.chamber_height_fx) / 4;
  return std::max(kSubvoxels, plan_.low_fx - deepest);
}

bool CaveShape::row(std::int64_t z, std::size_t first, std::size_t last, std::int32_t* floor_fx,
                    std::int32_t* roof_fx) {
  std::fill_n(floor_fx, width_, 0);
  std::fill_n(roof_fx, width_, 0);
  if (first >= last) return false;
  const float* tunnels = tunnels_.row(z, first, last);
  const float* chambers = chambers_.row(z, first, last);
  for (std::size_t i = first; i < last; ++i) {
    tunnel_noise_[i] = std::abs(noise_of(tunnels[i]));
    chamber_noise_[i] = noise_of(chambers[i]);
  }
  const auto has_air = [&](std::size_t i) {
    return tunnel_noise_[i] < plan_.half_width_noise || chamber_noise_[i] > plan_.threshold_noise;
  };
  while (first < last && !has_air(first)) ++first;
  if (first == last) return false;
  while (!has_air(last - 1)) --last;
  const float* climb = climb_.row(z, first, last);
  for (std::size_t i = first; i < last; ++i) {
    if (has_air(i)) open(tunnel_noise_[i], chamber_noise_[i], climb[i], floor_fx[i], roof_fx[i]);
  }
  return true;
}

void CaveShape::open(std::int32_t tunnel_noise, std::int32_t chamber_noise, float climb_noise,
                     std::int32_t& floor_fx, std::int32_t& roof_fx) const {
  const std::int32_t up = std::clamp(kOne / 2 + 4 * noise_of(climb_noise), 0, kOne);
  const std::int32_t middle_fx = plan_.low_fx + part(plan_.climb_fx, up);
  std::int32_t rise_fx = 0;
  std::int32_t drop_fx = 0;
  // Three quarters of a height lie above the middle. A floor is the flatter half: a dome's dome.
  const auto widen = [&](std::int32_t height_fx, std::int32_t dome) {
    rise_fx = std::max(rise_fx, part(height_fx, dome) - part(height_fx, dome) / 4);
    drop_fx = std::max(drop_fx, part(height_fx, bulge(dome)) / 4);
  };
  const std::int32_t in = plan_.half_width_noise - tunnel_noise;
  if (in > 0) {
    const std::int64_t share = (std::int64_t{in} << 16) / plan_.half_width_noise;
    widen(plan_.height_fx, bulge(static_cast<std::int32_t>(share)));
  }
  const std::int32_t deep = chamber_noise - plan_.threshold_noise;
  if (deep > 0) {
    const std::int64_t share = std::min<std::int64_t>(kOne, (std::int64_t{deep} << 16) / kWall_noise);
    widen(plan_.chamber_height_fx, bulge(static_cast<std::int32_t>(share)));
  }
  floor_fx = std::max(kSubvoxels, middle_fx - drop_fx);
  roof_fx = std::max(floor_fx, middle_fx + rise_fx);
}

}  // namespace talus::terrain
