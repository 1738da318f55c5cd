// Helpers shared by the kernels of every instruction set. Included once per set, hence this include guard:
#if defined(TALUS_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VECTORS_INL
#undef TALUS_VECTORS_INL
#else
#define TALUS_VECTORS_INL
#endif

#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Calls body(tag, i) for vectors that cover [0, width) and access nothing past it. The last vector may
/// overlap the one before, so body must be idempotent.
template <class Tag, class Body>
HWY_INLINE void over_row(Tag tag, std::size_t width, const Body& body) {
  const std::size_t lanes = hn::Lanes(tag);
  if (width < lanes) {
    for (std::size_t i = 0; i < width; ++i) body(hn::CappedTag<hn::TFromD<Tag>, 1>{}, i);
    return;
  }
  std::size_t i = 0;
  for (; i + lanes <= width; i += lanes) body(tag, i);
  if (i < width) body(tag, width - lanes);
}

/// Rounds to the nearest integer, ties to even, as std::nearbyint does. REQUIRES 0 <= value <= 2^23.
template <class Tag>
HWY_INLINE auto round_to_even(Tag tag, hn::Vec<Tag> value) {
  // Floats in [2^23, 2^24) have no fraction, and consecutive ones have consecutive bit patterns.
  const hn::RebindToSigned<Tag> integers;
  const auto no_fraction = hn::Set(tag, 8388608.0F);
  return hn::Sub(hn::BitCast(integers, hn::Add(value, no_fraction)), hn::BitCast(integers, no_fraction));
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
