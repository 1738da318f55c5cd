#include "surface/warped_rows.h"

namespace talus::terrain {

WarpedRows::WarpedRows(const Surface& surface, InstructionSet set)
    : surface_{surface}, east_{set}, south_{set}, noise_{set}, kernels_{&noise_kernels(set)} {}

void WarpedRows::start(std::span<const std::int64_t> xs) {
  width_ = xs.size();
  east_.start(surface_.warp.east, xs);
  south_.start(surface_.warp.south, xs);
  noise_.start(surface_.noise, xs);
}

void WarpedRows::row(std::int64_t z, std::int32_t* heights_fx) {
  const float* east = east_.row(z);
  const float* south = south_.row(z);
  kernels_->shape(noise_.row(z, east, south, surface_.warp.reach_fx), width_, surface_.gain,
                  surface_.exponent, surface_.highest_fx, heights_fx);
}

}  // namespace talus::terrain
