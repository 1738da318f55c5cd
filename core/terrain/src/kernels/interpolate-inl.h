// Interpolation between lattice corners, in vectors; noise/lattice_place.h has the scalar version. Included
// once per instruction set, hence this include guard:
#if defined(TALUS_INTERPOLATE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_INTERPOLATE_INL
#undef TALUS_INTERPOLATE_INL
#else
#define TALUS_INTERPOLATE_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V faded(V t) {
  const hn::DFromV<V> f;
  const auto inner = hn::Sub(hn::Mul(t, hn::Set(f, 6.0F)), hn::Set(f, 15.0F));
  const auto outer = hn::Add(hn::Mul(t, inner), hn::Set(f, 10.0F));
  return hn::Mul(hn::Mul(hn::Mul(t, t), t), outer);
}

template <class V>
HWY_INLINE V faded_slope(V t) {
  const hn::DFromV<V> f;
  const auto both = hn::Mul(t, hn::Sub(t, hn::Set(f, 1.0F)));
  return hn::Mul(hn::Set(f, 30.0F), hn::Mul(both, both));
}

template <class V>
HWY_INLINE V lerp(V a, V b, V t) {
  return hn::Add(a, hn::Mul(t, hn::Sub(b, a)));
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
