#include "strata.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/strata.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

#include "kernels/octaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::round_to_even;

/// `noise.with<kVectors>(f, at, use)` calls use(v, noise of vector v from column `at` on).
template <class Noise>
HWY_INLINE bool stack_by(const Noise noise_of, const LayerShape& shape, std::size_t width,
                         const std::int32_t* limit, const std::int32_t* below, std::uint8_t* open,
                         std::int32_t* top) {
  // Whether kVectors vectors of columns from `at` on have reached the limit.
  // By value, as the compiler cannot tell that what is stored is not of the shape.
  const auto stack_at = [=, own = shape]<std::size_t kVectors>(auto f, std::size_t at) HWY_ATTR {
    const hn::RebindToSigned<decltype(f)> d;
    auto missing = hn::Zero(d);  // less than 0 where the limit is not reached
    noise_of.template with<kVectors>(f, at, [&](std::size_t v, auto noise) HWY_ATTR {
      const std::size_t x = at + v * hn::Lanes(d);
      const auto swell = hn::Add(hn::Set(f, 1.0F), hn::Mul(hn::Set(f, own.swing), noise));
      const auto thickness = hn::Mul(hn::Set(f, own.mean_fx), hn::Max(hn::Zero(f), swell));
      const auto rise = round_to_even(f, hn::Min(thickness, hn::Set(f, own.max_fx)));
      const auto most = hn::LoadU(d, limit + x);
      const auto reached = hn::Min(hn::Add(hn::LoadU(d, below + x), rise), most);
      missing = hn::Min(missing, hn::Sub(reached, most));
      hn::StoreU(reached, d, top + x);
    });
    return hn::AllTrue(d, hn::Eq(missing, hn::Zero(d)));
  };
  const hn::ScalableTag<float> f;
  const std::size_t lanes = hn::Lanes(f);
  constexpr std::size_t kVectors =
      std::min<std::size_t>(4, kSegment / hn::MaxLanes(hn::ScalableTag<float>{}));
  bool any = false;
  for (std::size_t x = 0; x < width; x += kSegment, ++open) {
    const std::size_t end = std::min(x + kSegment, width);
    if (*open == 0) {
      std::copy(limit + x, limit + end, top + x);
      continue;
    }
    bool full = true;
    std::size_t at = x;
    for (; at + kVectors * lanes <= end; at += kVectors * lanes) {
      full = stack_at.template operator()<kVectors>(f, at) && full;
    }
    for (; at + lanes <= end; at += lanes) full = stack_at.template operator()<1>(f, at) && full;
    if (at < end && width >= lanes) {
      // The last vector overlaps columns that are done already, and gives them the same.
      full = stack_at.template operator()<1>(f, width - lanes) && full;
    } else {
      for (; at < end; ++at) full = stack_at.template operator()<1>(hn::CappedTag<float, 1>{}, at) && full;
    }
    *open = full ? 0 : 1;
    any = any || !full;
  }
  return any;
}

struct OctavesNoise {
  const OctaveRow* octaves;
  std::size_t count;

  template <std::size_t kVectors, class Tag, class Use>
  HWY_INLINE void with(Tag f, std::size_t at, const Use& use) const {
    with_noise<kVectors>(f, octaves, count, at, use);
  }
};

bool stack(const OctaveRow* octaves, std::size_t count, const LayerShape& shape, std::size_t width,
           const std::int32_t* limit, const std::int32_t* below, std::uint8_t* open, std::int32_t* top) {
  return stack_by(OctavesNoise{octaves, count}, shape, width, limit, below, open, top);
}

struct NoiseBetween {
  const float* north;
  const float* south;
  float share;

  template <std::size_t kVectors, class Tag, class Use>
  HWY_INLINE void with(Tag f, std::size_t at, const Use& use) const {
    for (std::size_t v = 0; v < kVectors; ++v) {
      const auto from = hn::LoadU(f, north + at + v * hn::Lanes(f));
      const auto to = hn::LoadU(f, south + at + v * hn::Lanes(f));
      use(v, hn::Add(from, hn::Mul(hn::Set(f, share), hn::Sub(to, from))));
    }
  }
};

bool stack_between(const float* north, const float* south, float share, const LayerShape& shape,
                   std::size_t width, const std::int32_t* limit, const std::int32_t* below,
                   std::uint8_t* open, std::int32_t* top) {
  return stack_by(NoiseBetween{north, south, share}, shape, width, limit, below, open, top);
}

}  // namespace

constexpr StrataKernels kStrata{stack, stack_between};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const StrataKernels& strata_kernels(InstructionSet set) {
  static constexpr const StrataKernels* kTables[] = TALUS_TABLES(kStrata);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
