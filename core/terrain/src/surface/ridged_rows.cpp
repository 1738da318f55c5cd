#include "surface/ridged_rows.h"

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {

RidgedRows::RidgedRows(const Surface& surface, InstructionSet set)
    : surface_{surface}, noise_{set}, shape_{&noise_kernels(set)}, ridges_{&ridge_kernels(set)} {
  for (int k = 0; k < surface.noise.octaves; ++k) weights_.push_back(octave_weight(surface.noise, k));
}

void RidgedRows::start(std::span<const std::int64_t> xs) {
  width_ = xs.size();
  sums_.resize(padded(width_));
  noise_.start(surface_.noise, xs, FbmRows::Weights::one);
}

void RidgedRows::row(std::int64_t z, std::int32_t* heights_fx) {
  const auto octaves = noise_.octaves(z);
  ridges_->sum(octaves.data(), weights_.data(), octaves.size(), width_, surface_.feedback, sums_.data());
  shape_->shape(sums_.data(), width_, surface_.gain, surface_.exponent, surface_.highest_fx, heights_fx);
}

}  // namespace talus::terrain
