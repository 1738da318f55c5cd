// Numbers for computing the heights of regions: one vector, two adjacent vectors, or a vector with its
// derivatives, all with the same functions. Included once per instruction set, hence this include guard:
#if defined(TALUS_REGION_NUMBERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_REGION_NUMBERS_INL
#undef TALUS_REGION_NUMBERS_INL
#else
#define TALUS_REGION_NUMBERS_INL
#endif

#include <hwy/highway.h>

#include "surface/regions/regions.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using RegionTag = hn::ScalableTag<float>;
using RegionVector = hn::Vec<RegionTag>;

/// The value in all lanes.
HWY_INLINE RegionVector constant(float value) {
  return hn::Set(RegionTag{}, value);
}
HWY_INLINE RegionVector add(RegionVector a, RegionVector b) {
  return hn::Add(a, b);
}
HWY_INLINE RegionVector sub(RegionVector a, RegionVector b) {
  return hn::Sub(a, b);
}
HWY_INLINE RegionVector mul(RegionVector a, RegionVector b) {
  return hn::Mul(a, b);
}
HWY_INLINE RegionVector quotient(RegionVector a, RegionVector b) {
  return hn::Div(a, b);
}
HWY_INLINE RegionVector root(RegionVector v) {
  return hn::Sqrt(v);
}
HWY_INLINE RegionVector size_of(RegionVector v) {
  return hn::Abs(v);
}
HWY_INLINE RegionVector larger(RegionVector a, RegionVector b) {
  return hn::Max(a, b);
}
HWY_INLINE RegionVector times(RegionVector v, float factor) {
  return hn::Mul(v, constant(factor));
}
HWY_INLINE RegionVector plus(RegionVector v, float more) {
  return hn::Add(v, constant(more));
}
/// whole - v
HWY_INLINE RegionVector less(float whole, RegionVector v) {
  return hn::Sub(constant(whole), v);
}
HWY_INLINE RegionVector unit(RegionVector v) {
  return hn::Min(hn::Max(v, constant(0)), constant(1));
}
/// Selects `yes` if a > b, else `no`.
HWY_INLINE RegionVector where_above(RegionVector a, RegionVector b, RegionVector yes, RegionVector no) {
  return hn::IfThenElse(hn::Gt(a, b), yes, no);
}
HWY_INLINE RegionVector at_least(RegionVector v, float least) {
  return hn::Max(v, constant(least));
}
HWY_INLINE RegionVector at_most(RegionVector v, float most) {
  return hn::Min(v, constant(most));
}
HWY_INLINE RegionVector value_of(RegionVector v) {
  return v;
}

/// A number with its rise per column eastward and southward. Results computed from it have their derivatives.
struct SlopedNumber {
  RegionVector v;
  RegionVector x;
  RegionVector z;
};

HWY_INLINE SlopedNumber add(SlopedNumber a, SlopedNumber b) {
  return {hn::Add(a.v, b.v), hn::Add(a.x, b.x), hn::Add(a.z, b.z)};
}
HWY_INLINE SlopedNumber sub(SlopedNumber a, SlopedNumber b) {
  return {hn::Sub(a.v, b.v), hn::Sub(a.x, b.x), hn::Sub(a.z, b.z)};
}
HWY_INLINE SlopedNumber mul(SlopedNumber a, SlopedNumber b) {
  return {hn::Mul(a.v, b.v), hn::Add(hn::Mul(a.x, b.v), hn::Mul(a.v, b.x)),
          hn::Add(hn::Mul(a.z, b.v), hn::Mul(a.v, b.z))};
}
HWY_INLINE SlopedNumber quotient(SlopedNumber a, SlopedNumber b) {
  const auto q = hn::Div(a.v, b.v);
  return {q, hn::Div(hn::Sub(a.x, hn::Mul(q, b.x)), b.v), hn::Div(hn::Sub(a.z, hn::Mul(q, b.z)), b.v)};
}
/// The derivative is 0 where the number is 0.
HWY_INLINE SlopedNumber root(SlopedNumber a) {
  const auto r = hn::Sqrt(a.v);
  const auto by = hn::IfThenElseZero(hn::Gt(r, constant(1e-6F)), hn::Div(constant(0.5F), r));
  return {r, hn::Mul(a.x, by), hn::Mul(a.z, by)};
}
HWY_INLINE SlopedNumber size_of(SlopedNumber a) {
  const auto negative = hn::Lt(a.v, constant(0));
  return {hn::Abs(a.v), hn::IfThenElse(negative, hn::Neg(a.x), a.x),
          hn::IfThenElse(negative, hn::Neg(a.z), a.z)};
}
HWY_INLINE SlopedNumber where_above(SlopedNumber a, SlopedNumber b, SlopedNumber yes, SlopedNumber no) {
  const auto above = hn::Gt(a.v, b.v);
  return {hn::IfThenElse(above, yes.v, no.v), hn::IfThenElse(above, yes.x, no.x),
          hn::IfThenElse(above, yes.z, no.z)};
}
HWY_INLINE SlopedNumber larger(SlopedNumber a, SlopedNumber b) {
  return where_above(a, b, a, b);
}
HWY_INLINE SlopedNumber smaller(SlopedNumber a, SlopedNumber b) {
  return where_above(a, b, b, a);
}
HWY_INLINE SlopedNumber times(SlopedNumber a, float factor) {
  return {times(a.v, factor), times(a.x, factor), times(a.z, factor)};
}
HWY_INLINE SlopedNumber plus(SlopedNumber a, float more) {
  return {plus(a.v, more), a.x, a.z};
}
HWY_INLINE SlopedNumber less(float whole, SlopedNumber a) {
  return {less(whole, a.v), hn::Neg(a.x), hn::Neg(a.z)};
}
HWY_INLINE SlopedNumber level(float value) {
  return {constant(value), constant(0), constant(0)};
}
HWY_INLINE SlopedNumber at_least(SlopedNumber a, float least) {
  return larger(a, level(least));
}
HWY_INLINE SlopedNumber at_most(SlopedNumber a, float most) {
  return smaller(a, level(most));
}
HWY_INLINE SlopedNumber unit(SlopedNumber a) {
  const auto inside = hn::And(hn::Gt(a.v, constant(0)), hn::Lt(a.v, constant(1)));
  return {unit(a.v), hn::IfThenElseZero(inside, a.x), hn::IfThenElseZero(inside, a.z)};
}
HWY_INLINE RegionVector value_of(SlopedNumber a) {
  return a.v;
}

/// Two vectors' numbers. A height is a long chain of dependent operations; two chains run in parallel.
struct Two {
  RegionVector a;
  RegionVector b;
};

HWY_INLINE Two add(Two m, Two n) {
  return {hn::Add(m.a, n.a), hn::Add(m.b, n.b)};
}
HWY_INLINE Two sub(Two m, Two n) {
  return {hn::Sub(m.a, n.a), hn::Sub(m.b, n.b)};
}
HWY_INLINE Two mul(Two m, Two n) {
  return {hn::Mul(m.a, n.a), hn::Mul(m.b, n.b)};
}
HWY_INLINE Two quotient(Two m, Two n) {
  return {hn::Div(m.a, n.a), hn::Div(m.b, n.b)};
}
HWY_INLINE Two root(Two m) {
  return {hn::Sqrt(m.a), hn::Sqrt(m.b)};
}
HWY_INLINE Two size_of(Two m) {
  return {hn::Abs(m.a), hn::Abs(m.b)};
}
HWY_INLINE Two larger(Two m, Two n) {
  return {hn::Max(m.a, n.a), hn::Max(m.b, n.b)};
}
HWY_INLINE Two times(Two m, float factor) {
  return {times(m.a, factor), times(m.b, factor)};
}
HWY_INLINE Two plus(Two m, float more) {
  return {plus(m.a, more), plus(m.b, more)};
}
HWY_INLINE Two less(float whole, Two m) {
  return {less(whole, m.a), less(whole, m.b)};
}
HWY_INLINE Two unit(Two m) {
  return {unit(m.a), unit(m.b)};
}
HWY_INLINE Two where_above(Two m, Two n, Two yes, Two no) {
  return {where_above(m.a, n.a, yes.a, no.a), where_above(m.b, n.b, yes.b, no.b)};
}
HWY_INLINE Two at_least(Two m, float least) {
  return {at_least(m.a, least), at_least(m.b, least)};
}
HWY_INLINE Two at_most(Two m, float most) {
  return {at_most(m.a, most), at_most(m.b, most)};
}

/// 0 at `none` to 1 at `all`.
template <class N>
HWY_INLINE N ramp(float none, float all, N v) {
  return unit(times(plus(v, -none), 1 / (all - none)));
}
template <class N>
HWY_INLINE N smooth(N t) {
  return mul(mul(t, t), less(3, times(t, 2)));
}

template <class N>
HWY_INLINE N on_spline(const Spline& spline, N v) {
  N y = plus(times(v, 0), spline.first_y());
  for (const Spline::Segment& s : spline.segments()) {
    const N t = unit(times(plus(v, -s.x), s.reciprocal));
    const N inner = plus(mul(t, plus(times(t, s.c), s.b)), s.a);
    y = add(y, mul(t, inner));
  }
  return y;
}

HWY_INLINE RegionVector equalized(const Equalizer& equalizer, RegionVector noise) {
  const auto half = on_spline(equalizer.half(), hn::Abs(times(noise, equalizer.reciprocal_deviation())));
  return hn::CopySign(half, noise);
}
/// The curve is odd, so its derivative is even.
HWY_INLINE SlopedNumber equalized(const Equalizer& equalizer, SlopedNumber noise) {
  const SlopedNumber half =
      on_spline(equalizer.half(), size_of(times(noise, equalizer.reciprocal_deviation())));
  const auto negative = hn::Lt(noise.v, constant(0));
  return {hn::CopySign(half.v, noise.v), hn::IfThenElse(negative, hn::Neg(half.x), half.x),
          hn::IfThenElse(negative, hn::Neg(half.z), half.z)};
}

/// Returns true if all lanes are 0, including derivatives.
HWY_INLINE bool none(RegionVector v) {
  return hn::AllTrue(RegionTag{}, hn::Eq(v, constant(0)));
}
HWY_INLINE bool none(Two m) {
  return none(hn::Or(hn::Abs(m.a), hn::Abs(m.b)));
}
HWY_INLINE bool none(SlopedNumber a) {
  return none(hn::Or(hn::Or(hn::Abs(a.v), hn::Abs(a.x)), hn::Abs(a.z)));
}

template <class N>
HWY_INLINE bool all_above(N a, N b) {
  return hn::AllTrue(RegionTag{}, hn::Gt(value_of(a), value_of(b)));
}
HWY_INLINE bool all_above(Two m, Two n) {
  return hn::AllTrue(RegionTag{}, hn::And(hn::Gt(m.a, n.a), hn::Gt(m.b, n.b)));
}
template <class N>
HWY_INLINE bool none_above(N a, N b) {
  return hn::AllFalse(RegionTag{}, hn::Gt(value_of(a), value_of(b)));
}
HWY_INLINE bool none_above(Two m, Two n) {
  return hn::AllFalse(RegionTag{}, hn::Or(hn::Gt(m.a, n.a), hn::Gt(m.b, n.b)));
}
template <class N>
HWY_INLINE bool all_at_least(N a, float least) {
  return hn::AllTrue(RegionTag{}, hn::Ge(value_of(a), constant(least)));
}
HWY_INLINE bool all_at_least(Two m, float least) {
  return all_at_least(hn::Min(m.a, m.b), least);
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
