#include "ridges.h"

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/ridges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/octaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;

void sum(const OctaveRow* octaves, const float* weights, std::size_t count, std::size_t width, float feedback,
         float* out) {
  const Floats f;
  const auto one = hn::Set(f, 1.0F);
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    auto total = hn::Set(f, -0.5F);
    auto shown = one;  // weight of this octave by the signal of the one before
    for (std::size_t k = 0; k < count; ++k) {
      const auto ridge = hn::Sub(one, hn::Abs(noise_at(f, octaves[k], i)));
      const auto signal = hn::Mul(hn::Mul(ridge, ridge), shown);
      total = hn::Add(total, hn::Mul(hn::Set(f, weights[k]), signal));
      shown = hn::Min(hn::Mul(hn::Set(f, feedback), signal), one);
    }
    hn::StoreU(total, f, out + i);
  }
}

}  // namespace

constexpr RidgeKernels kRidges{sum};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const RidgeKernels& ridge_kernels(InstructionSet set) {
  static constexpr const RidgeKernels* kTables[] = TALUS_TABLES(kRidges);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
