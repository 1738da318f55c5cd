// The noise of octaves between their lines, in vectors (kernels/noise.h). Included once per instruction set,
// hence this include guard:
#if defined(TALUS_OCTAVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_OCTAVES_INL
#undef TALUS_OCTAVES_INL
#else
#define TALUS_OCTAVES_INL
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "kernels/noise.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The octave's noise at the columns from i on.
template <class Tag>
HWY_INLINE hn::Vec<Tag> noise_at(Tag f, const OctaveRow& octave, std::size_t i) {
  const auto line_0 = hn::Add(hn::Mul(hn::LoadU(f, octave.value_0 + i), hn::Set(f, octave.value_0_share)),
                              hn::Mul(hn::LoadU(f, octave.slope_0 + i), hn::Set(f, octave.slope_0_share)));
  const auto line_1 = hn::Add(hn::Mul(hn::LoadU(f, octave.value_1 + i), hn::Set(f, octave.value_1_share)),
                              hn::Mul(hn::LoadU(f, octave.slope_1 + i), hn::Set(f, octave.slope_1_share)));
  return hn::Add(line_0, line_1);
}

/// Calls use(v, sum of all octaves) for each vector v of kVectors from column `at` on. Several vectors share
/// one broadcast of each octave's weights.
template <std::size_t kVectors, class Tag, class Use>
HWY_INLINE void with_noise(Tag f, const OctaveRow* octaves, std::size_t count, std::size_t at,
                           const Use& use) {
  hn::Vec<Tag> sums[kVectors];
  for (auto& sum : sums) sum = hn::Zero(f);
  for (const OctaveRow* octave = octaves; octave != octaves + count; ++octave) {
    for (std::size_t v = 0; v < kVectors; ++v) {
      sums[v] = hn::Add(sums[v], noise_at(f, *octave, at + v * hn::Lanes(f)));
    }
  }
  for (std::size_t v = 0; v < kVectors; ++v) use(v, sums[v]);
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
