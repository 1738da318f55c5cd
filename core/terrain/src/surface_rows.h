// The surface over many columns, row after row.
#pragma once

#include <cstdint>
#include <span>

#include <talus/terrain/surface.h>

#include "fbm_rows.h"

namespace talus::terrain {

/// Keeps its memory from one start() to the next. For one thread at a time.
class SurfaceRows {
 public:
  explicit SurfaceRows(InstructionSet set) : noise_{set}, kernels_{&noise_kernels(set)} {}

  /// From here on rows are of this surface over these ascending base columns.
  void start(const Surface& surface, std::span<const std::int64_t> xs) {
    surface_ = surface;
    width_ = xs.size();
    noise_.start(surface.noise, xs);
  }

  /// Writes H at (xs[i], z) for all i.
  void row(std::int64_t z, std::int32_t* heights_fx) {
    kernels_->shape(noise_.row(z, 0, width_), width_, surface_.gain, surface_.exponent, surface_.highest_fx,
                    heights_fx);
  }

 private:
  FbmRows noise_;
  const NoiseKernels* kernels_;
  Surface surface_;
  std::size_t width_ = 0;
};

}  // namespace talus::terrain
