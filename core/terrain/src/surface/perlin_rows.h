// The thesis' surface: Perlin fBm raised to a power.
#pragma once

#include "noise/fbm_rows.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

class PerlinRows final : public SurfaceRows {
 public:
  PerlinRows(const Surface& surface, InstructionSet set)
      : surface_{surface}, noise_{set}, kernels_{&noise_kernels(set)} {}

  void start(std::span<const std::int64_t> xs) override {
    width_ = xs.size();
    noise_.start(surface_.noise, xs);
  }

  void row(std::int64_t z, std::int32_t* heights_fx) override {
    kernels_->shape(noise_.row(z), width_, surface_.gain, surface_.exponent, surface_.highest_fx, heights_fx);
  }

 private:
  Surface surface_;
  FbmRows noise_;
  const NoiseKernels* kernels_;
  std::size_t width_ = 0;
};

}  // namespace talus::terrain
