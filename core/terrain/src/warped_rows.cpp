#include "warped_rows.h"

namespace talus::terrain {
namespace {

// To the nearest integer, ties to even: a float of this size has no fraction, so the sum rounds by itself.
std::int64_t rounded(float value) {
  constexpr float kNoFraction = 12582912.0F;  // 1.5 * 2^23
  return static_cast<std::int64_t>((value + kNoFraction) - kNoFraction);
}

}  // namespace

WarpedRows::WarpedRows(const Surface& surface, InstructionSet set)
    : surface_{surface}, east_{set}, south_{set}, noise_{surface.noise}, kernels_{&noise_kernels(set)} {}

void WarpedRows::start(std::span<const std::int64_t> xs) {
  xs_.assign(xs.begin(), xs.end());
  warped_.resize(xs.size());
  east_.start(surface_.warp.east, xs);
  south_.start(surface_.warp.south, xs);
}

void WarpedRows::row(std::int64_t z, std::int32_t* heights_fx) {
  const float* east = east_.row(z, 0, xs_.size());
  const float* south = south_.row(z, 0, xs_.size());
  const float reach_fx = surface_.warp.reach_fx;
  for (std::size_t i = 0; i < xs_.size(); ++i) {
    warped_[i] = noise_.at(xs_[i] * kSubvoxels + rounded(east[i] * reach_fx),
                           z * kSubvoxels + rounded(south[i] * reach_fx));
  }
  kernels_->shape(warped_.data(), xs_.size(), surface_.gain, surface_.exponent, surface_.highest_fx,
                  heights_fx);
}

}  // namespace talus::terrain
