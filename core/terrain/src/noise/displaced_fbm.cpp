#include "noise/displaced_fbm.h"

#include <talus/terrain/world.h>
#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {

void DisplacedFbm::start(const Fbm& fbm, std::span<const std::int64_t> xs) {
  width_ = xs.size();
  period_fx_ = fbm.period * kSubvoxels;
  lattices_.clear();
  for (int k = 0; k < fbm.octaves && fbm.has_octave(k); ++k) {
    const std::uint64_t seed = derived_seed(fbm.seed, static_cast<std::uint64_t>(k));
    lattices_.push_back({seed, offset_of(seed, Axis::z, fbm.period) * kSubvoxels});
    if (octaves_.size() < lattices_.size()) octaves_.emplace_back();
    DisplacedOctave& octave = octaves_[lattices_.size() - 1];
    octave.weight = octave_weight(fbm, k);
    octave.frequency = static_cast<double>(std::int64_t{1} << k);
    octave.x_inside.resize(padded(width_));
    octave.x_key.resize(padded(width_));
    const std::int64_t offset_fx = offset_of(seed, Axis::x, fbm.period) * kSubvoxels;
    for (std::size_t i = 0; i < width_; ++i) {
      const std::int64_t position = xs[i] * kSubvoxels * (std::int64_t{1} << k) + offset_fx;
      octave.x_inside[i] = static_cast<double>(floor_mod(position, period_fx_));
      octave.x_key[i] = axis_key(seed, Axis::x, floor_div(position, period_fx_));
    }
  }
  for (auto* floats : {&scratch_.east, &scratch_.south, &scratch_.u, &scratch_.v, &noise_}) {
    floats->resize(padded(width_));
  }
  for (auto* hashes :
       {&scratch_.west_hash, &scratch_.east_hash, &scratch_.north_hash, &scratch_.south_hash}) {
    hashes->resize(padded(width_));
  }
}

const float* DisplacedFbm::row(std::int64_t z, const float* east, const float* south, float reach_fx) {
  for (std::size_t k = 0; k < lattices_.size(); ++k) {
    const Lattice& lattice = lattices_[k];
    const std::int64_t position = z * kSubvoxels * (std::int64_t{1} << k) + lattice.z_offset_fx;
    octaves_[k].z_inside = static_cast<double>(floor_mod(position, period_fx_));
    octaves_[k].z_key = axis_key(lattice.seed, Axis::z, floor_div(position, period_fx_));
  }
  kernels_->sum(octaves_.data(), lattices_.size(), static_cast<double>(period_fx_), east, south, reach_fx,
                width_, scratch_, noise_.data());
  return noise_.data();
}

}  // namespace talus::terrain
