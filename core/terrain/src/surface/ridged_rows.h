// Ridged multifractal noise (Musgrave, in Ebert et al., Texturing and Modeling, 2003, ch. 16) as a surface:
// sharp crests at the zeros of the noise, smooth ground in the valleys between them.
#pragma once

#include <talus/vectors/aligned.h>

#include "kernels/ridges.h"
#include "noise/fbm_rows.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

/// With n_k the noise of octave k, between -1 and 1:
///   s_0 = (1 - |n_0|)^2,   s_k = (1 - |n_k|)^2 * min(feedback * s_(k-1), 1)
/// The sum of 2^-k s_k, normalised over all octaves of the spec and less 1/2, replaces fBm.
class RidgedRows final : public SurfaceRows {
 public:
  RidgedRows(const Surface& surface, InstructionSet set);

  void start(std::span<const std::int64_t> xs) override;
  void row(std::int64_t z, std::int32_t* heights_fx) override;

 private:
  Surface surface_;
  FbmRows noise_;
  const NoiseKernels* shape_;
  const RidgeKernels* ridges_;
  AlignedVector<float> weights_;  // one per octave
  AlignedVector<float> sums_;     // padded
  std::size_t width_ = 0;
};

}  // namespace talus::terrain
