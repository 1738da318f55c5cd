// Domain-warped fBm as a surface: the noise is read at a position displaced by two other noises, so that
// ridges bend and valleys swirl.
#pragma once

#include "noise/displaced_fbm.h"
#include "noise/fbm_rows.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

/// H at (x, z) is fBm's at (x + reach * east(x, z), z + reach * south(x, z)). Displacements are rounded to
/// integers of subvoxels, so that warped positions are as exact at the world's ends as at its origin.
class WarpedRows final : public SurfaceRows {
 public:
  WarpedRows(const Surface& surface, InstructionSet set);

  void start(std::span<const std::int64_t> xs) override;
  void row(std::int64_t z, std::int32_t* heights_fx) override;

 private:
  Surface surface_;
  FbmRows east_;
  FbmRows south_;
  DisplacedFbm noise_;
  const NoiseKernels* kernels_;
  std::size_t width_ = 0;
};

}  // namespace talus::terrain
