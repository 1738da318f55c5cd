#include "noise/point_fbm.h"

#include <bit>

#include <talus/terrain/lattice_hash.h>
#include <talus/terrain/world.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

// The 16 directions of kernels/gradients-inl.h, by the same bits of the same hash.
constexpr std::array<float, 4> kMagnitudes{1.38703985F, 1.17587560F, 0.78569496F, 0.27589938F};

float with_sign(float magnitude, std::uint32_t bits) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(magnitude) ^ (bits & 0x80000000U));
}

}  // namespace

PointFbm::PointFbm(const Fbm& fbm)
    : period_fx_{fbm.period * kSubvoxels}, reciprocal_{1.0F / static_cast<float>(fbm.period * kSubvoxels)} {
  for (int k = 0; k < fbm.octaves && fbm.has_octave(k); ++k) {
    Octave& octave = octaves_.emplace_back();
    octave.seed = derived_seed(fbm.seed, static_cast<std::uint64_t>(k));
    octave.weight = octave_weight(fbm, k);
    octave.x_offset_fx = offset_of(octave.seed, Axis::x, fbm.period) * kSubvoxels;
    octave.z_offset_fx = offset_of(octave.seed, Axis::z, fbm.period) * kSubvoxels;
  }
}

bool PointFbm::move(Place& place, std::int64_t position) const {
  const std::int64_t before = place.cell;
  step_to(position - place.position, period_fx_, place.cell, place.inside);
  place.position = position;
  return place.cell != before;
}

void PointFbm::draw(Octave& octave) {
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::int64_t cell_x = octave.x.cell + static_cast<std::int64_t>(corner % 2);
    const std::int64_t cell_z = octave.z.cell + static_cast<std::int64_t>(corner / 2);
    const std::uint32_t hash =
        corner_hash(axis_hash(octave.seed, Axis::x, cell_x), axis_hash(octave.seed, Axis::z, cell_z));
    const std::uint32_t second = hash << 1;
    const std::uint32_t direction = ((hash >> 28) & 3U) ^ ((second >> 31) != 0 ? 3U : 0U);
    octave.gradient_x[corner] = with_sign(kMagnitudes[direction], hash ^ second);
    octave.gradient_z[corner] = with_sign(kMagnitudes[direction ^ 3U], hash);
  }
  octave.drawn = true;
}

float PointFbm::at(std::int64_t x_fx, std::int64_t z_fx) {
  float sum = 0;
  std::int64_t frequency = 1;
  for (Octave& octave : octaves_) {
    const bool west_or_east = move(octave.x, x_fx * frequency + octave.x_offset_fx);
    const bool north_or_south = move(octave.z, z_fx * frequency + octave.z_offset_fx);
    if (west_or_east || north_or_south || !octave.drawn) draw(octave);
    const float u = static_cast<float>(octave.x.inside) * reciprocal_;
    const float v = static_cast<float>(octave.z.inside) * reciprocal_;
    const auto corner = [&](std::size_t i, float dx, float dz) {
      return octave.gradient_x[i] * dx + octave.gradient_z[i] * dz;
    };
    const float faded_u = fade(u);
    const float north = lerp(corner(0, u, v), corner(1, u - 1.0F, v), faded_u);
    const float south = lerp(corner(2, u, v - 1.0F), corner(3, u - 1.0F, v - 1.0F), faded_u);
    sum += octave.weight * lerp(north, south, fade(v));
    frequency *= 2;
  }
  return sum;
}

}  // namespace talus::terrain
