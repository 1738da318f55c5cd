// The composition of a column's height: ridges and hills, terraced mesas, valleys cut by rivers, beaches
// (docs/DESIGN.md, "Regions"). Included once per instruction set, hence this include guard:
#if defined(TALUS_REGION_HEIGHTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_REGION_HEIGHTS_INL
#undef TALUS_REGION_HEIGHTS_INL
#else
#define TALUS_REGION_HEIGHTS_INL
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "kernels/region_numbers-inl.h"
#include "kernels/regions.h"
#include "surface/regions/regions.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

/// Reads a row's values at some columns.
struct PlainAt {
  using Number = RegionVector;
  const RegionRow& row;
  std::size_t i;

  [[nodiscard]] HWY_INLINE PlainAt next() const { return {row, i + hn::Lanes(RegionTag{})}; }
  [[nodiscard]] HWY_INLINE RegionVector load(const float* RegionRow::*values) const {
    return hn::LoadU(RegionTag{}, row.*values + i);
  }
  template <std::size_t k>
  [[nodiscard]] HWY_INLINE RegionVector octave() const {
    return hn::LoadU(RegionTag{}, row.shape[k] + i);
  }
  [[nodiscard]] static HWY_INLINE RegionVector number(float value) { return constant(value); }
};
struct SlopedAt {
  using Number = SlopedNumber;
  const SlopedRegionRow& row;
  std::size_t i;

  [[nodiscard]] HWY_INLINE SlopedNumber load(const float* RegionRow::*values) const {
    const RegionTag f;
    return {hn::LoadU(f, row.value.*values + i), hn::LoadU(f, row.east.*values + i),
            hn::LoadU(f, row.south.*values + i)};
  }
  template <std::size_t k>
  [[nodiscard]] HWY_INLINE SlopedNumber octave() const {
    const RegionTag f;
    return {hn::LoadU(f, row.value.shape[k] + i), hn::LoadU(f, row.east.shape[k] + i),
            hn::LoadU(f, row.south.shape[k] + i)};
  }
  [[nodiscard]] static HWY_INLINE SlopedNumber number(float value) { return level(value); }
};

/// Reads slow rows between their samples, to the bit as spread() writes them.
struct CellsAt {
  using Number = RegionVector;
  static constexpr auto kColumns = static_cast<std::size_t>(kSampleStep);  // of a cell
  const RegionCells& row;
  std::size_t i;  // first column of a vector
  std::size_t cell = i / kColumns;

  /// REQUIRES that this vector is the first of its cell.
  [[nodiscard]] HWY_INLINE CellsAt next() const {
    constexpr std::size_t kLanes = hn::MaxLanes(RegionTag{});
    return {row, i + kLanes, cell + kLanes / kColumns};
  }
  [[nodiscard]] HWY_INLINE RegionVector load(const float* RegionRow::*values) const {
    return cubic(row.rows.*values);
  }
  template <std::size_t k>
  [[nodiscard]] HWY_INLINE RegionVector octave() const {
    if constexpr (k < static_cast<std::size_t>(kSlowOctaves)) return cubic(row.rows.shape[k]);
    return hn::LoadU(RegionTag{}, row.rows.shape[k] + i);
  }
  [[nodiscard]] static HWY_INLINE RegionVector number(float value) { return constant(value); }

 private:
  [[nodiscard]] HWY_INLINE RegionVector cubic(const float* of) const {
    static_assert(hn::MaxLanes(RegionTag{}) <= kSampleStep);
    const float* const c = of + cell;
    const auto t = hn::LoadU(RegionTag{}, row.fractions + i % kColumns);
    const auto inner = hn::Add(constant(c[2 * row.plane]), hn::Mul(t, constant(c[3 * row.plane])));
    return hn::Add(constant(c[0]), hn::Mul(t, hn::Add(constant(c[row.plane]), hn::Mul(t, inner))));
  }
};

/// Two adjacent vectors of columns.
template <class At>
struct TwoAt {
  using Number = Two;
  At a;
  At b;

  [[nodiscard]] HWY_INLINE Two load(const float* RegionRow::*values) const {
    return {a.load(values), b.load(values)};
  }
  template <std::size_t k>
  [[nodiscard]] HWY_INLINE Two octave() const {
    return {a.template octave<k>(), b.template octave<k>()};
  }
  [[nodiscard]] static HWY_INLINE Two number(float value) { return {constant(value), constant(value)}; }
};

template <class N>
struct ShapeSums {
  N ridge;
  N hill;
  N small;
};

// An octave has ridges, rounded off, where it is near 0; the higher a ridge, the more it shows of the next
// octave. `kRidged`: false if no ridges stand here, which saves their cost. A recursion over k, because
// compilers do not unroll the loop.
template <bool kRidged, std::size_t k, class At, class N>
HWY_INLINE void add_octaves_from(const At& at, const RegionShape& shape, N shown, ShapeSums<N>& sums) {
  constexpr float kRound = 0.045F;
  if constexpr (k < static_cast<std::size_t>(kShapeOctaves)) {
    const N n = at.template octave<k>();
    if constexpr (kRidged) {
      const N size = size_of(n);
      const N inside = at_least(less(kRound, size), 0);
      const N distance = add(size, times(mul(inside, inside), 0.5F / kRound));
      const N crest = at_least(less(1, times(distance, 1.8F)), 0);
      const N signal = mul(mul(crest, crest), shown);
      sums.ridge = add(sums.ridge, times(signal, shape.ridge_weights[k]));
      shown = at_most(plus(times(signal, 1.1F), 0.3F), 1);
    }
    if constexpr (k > 0) sums.hill = add(sums.hill, times(n, shape.hill_weights[k]));
    if constexpr (k >= static_cast<std::size_t>(kSmallFrom)) {
      sums.small = add(sums.small, times(n, shape.small_weights[k]));
    }
    add_octaves_from<kRidged, k + 1>(at, shape, shown, sums);
  }
}

template <bool kRidged, class At, class N = typename At::Number>
HWY_INLINE ShapeSums<N> summed(const At& at, const RegionShape& shape) {
  ShapeSums<N> sums{at.number(0), at.number(0), at.number(0)};
  add_octaves_from<kRidged, kRidged ? 0 : 1>(at, shape, at.number(1), sums);
  return sums;
}

/// The land before rivers cut it, and the inputs of the cut.
template <class N>
struct UncutLand {
  N base, belt, plain, toward_hills, land, lifted, mesa, terrace_field, small;
  N river, tributary;
};

/// Values of a row that places may also need.
template <class N>
struct Country {
  N base, belt, mesa;
};
template <class At, class N = typename At::Number>
HWY_INLINE Country<N> country_at(const At& at) {
  return {at.load(&RegionRow::base), at.load(&RegionRow::belt), at.load(&RegionRow::mesa)};
}

/// Distance to the tributary on the column's side of the river.
template <class At, class N = typename At::Number>
HWY_INLINE N tributary_at(const At& at, N river) {
  if (all_above(river, at.number(0))) return at.load(&RegionRow::tributary_a);
  N other = at.load(&RegionRow::tributary_b);
  if (none_above(river, at.number(0))) return other;
  return where_above(river, at.number(0), at.load(&RegionRow::tributary_a), other);
}

// Work that changes no column of a vector is skipped: each `if` here leaves exactly the numbers, to the bit,
// of the formula under it.
template <class At, class N = typename At::Number>
HWY_INLINE UncutLand<N> uncut_at(const At& at, const Country<N>& country, const RegionShape& shape) {
  const N base = country.base;
  // Between samples a curve may overshoot slightly.
  const N belt = unit(country.belt);
  const N hills = at.load(&RegionRow::hills);
  const N mesa = at_least(country.mesa, 0);
  const N river = at.load(&RegionRow::river);
  const bool ridged = !none(belt);
  const ShapeSums<N> sums = ridged ? summed<true>(at, shape) : summed<false>(at, shape);

  const N filled = unit(plus(times(sums.hill, 0.45F), 0.5F));
  const N hill = mul(filled, root(filled));
  N plain = base;
  N relief = at.number(0);
  if (ridged) {
    const N ridge = at_least(plus(times(sums.ridge, shape.ridge_scale), -0.1F), 0);
    const N over = at_least(plus(ridge, -0.9F), 0);
    relief = at_most(ridge, 0.9F);
    if (!none(over)) relief = add(relief, quotient(over, plus(times(over, 3), 1)));
    relief = mul(times(belt, shape.range_relief), relief);
    plain = add(base, times(smooth(belt), shape.range_base));
  }

  const N above = at_least(plus(plain, -shape.carve[0]), 0);
  N lifted = at.number(0);
  if (!none(above)) lifted = quotient(mul(above, above), plus(above, 20));
  N terrace_field = at.number(0);
  if (!none(mesa)) {
    terrace_field = add(at.load(&RegionRow::terrace), times(sums.small, shape.mesa_roughness));
  }
  return {base,
          belt,
          plain,
          add(plain, times(hills, 0.3F)),
          add(add(plain, mul(hills, hill)), relief),
          lifted,
          mesa,
          terrace_field,
          sums.small,
          size_of(river),
          size_of(tributary_at(at, river))};
}

template <class At, class N = typename At::Number>
HWY_INLINE UncutLand<N> uncut_at(const At& at, const RegionShape& shape) {
  return uncut_at(at, country_at(at), shape);
}

HWY_INLINE UncutLand<RegionVector> value_of(const UncutLand<SlopedNumber>& u) {
  return {u.base.v, u.belt.v,          u.plain.v, u.toward_hills.v, u.land.v,     u.lifted.v,
          u.mesa.v, u.terrace_field.v, u.small.v, u.river.v,        u.tributary.v};
}

/// A river or its tributaries at a column.
template <class N>
struct Stream {
  N share;  // 0 to 1: strength of the stream
  N width;  // half its width
};
constexpr float kWidest = 0.8F + 0.8F;  // maximum factor of the spec's half width

// A river narrows toward its spring and is dry where it is only as wide as a brook.
template <class N>
HWY_INLINE N wide_at(const UncutLand<N>& u) {
  return plus(times(ramp(24, 3, u.base), 0.8F), 0.8F);
}
template <class N>
HWY_INLINE Stream<N> main_stream(const UncutLand<N>& u, const RegionShape& shape) {
  const float high = shape.carve[0];
  const float low = shape.carve[1];
  const N wide = mul(wide_at(u), plus(times(ramp(high + 12, high - 28, u.plain), 0.75F), 0.25F));
  return {plus(times(ramp(low + 90, low + 30, u.plain), 0.55F), 0.45F), times(wide, shape.half_width[0])};
}
template <class N>
HWY_INLINE Stream<N> side_stream(const UncutLand<N>& u, const RegionShape& shape) {
  const float low = shape.carve[1];
  const N wide = mul(wide_at(u), plus(times(ramp(low + 12, low - 16, u.toward_hills), 0.75F), 0.25F));
  return {ramp(low + 28, low, u.toward_hills), times(wide, shape.half_width[1])};
}

/// The cut of a river or its tributaries into the land at a column.
template <class N>
struct Cut {
  N left;   // share of the land above the flood plain that is left: 0 in the bed, 1 outside the valley
  N bed;    // depth below the flood plain
  N share;  // Stream::share; 0 if the river is not near
  bool near = false;    // false if no column of the vector is near; `left` is 1 then
  bool in_bed = false;  // if false, `bed` is 0
};

template <class N>
struct Valleys {
  N main, side;  // without widening
  N main_reach, side_reach;
};
template <class N>
HWY_INLINE Valleys<N> valleys_of(const UncutLand<N>& u, const RegionShape& shape, float widened) {
  const N main = plus(times(u.belt, 150), shape.valley[0]);
  const N side = plus(times(u.belt, 120), shape.valley[1]);
  if (widened == 0) return {main, side, main, side};
  const auto at_most = [&](std::size_t i) { return std::max(kWidest * shape.half_width[i], widened); };
  return {main, side, at_least(main, at_most(0) + 2 * widened), at_least(side, at_most(1) + 2 * widened)};
}

/// `own_valley`, `reach`: from Valleys. `depth`: the bed's depth if the river is wide enough. `widened`:
/// minimum half width. At the rim of a valley and beyond it the flank is exactly 1.
template <class N, class StreamAt>
HWY_INLINE Cut<N> cut_by(N distance, N own_valley, N reach, const StreamAt& stream_at, N lifted, float depth,
                         float widened) {
  const N none_of_it = times(distance, 0);
  Cut<N> cut{plus(none_of_it, 1), none_of_it, none_of_it};
  if (all_above(distance, reach)) return cut;
  const Stream<N> stream = stream_at();
  const N half_width = at_least(stream.width, widened);
  const N valley = widened == 0 ? own_valley : larger(own_valley, plus(half_width, 2 * widened));
  const N t = unit(quotient(sub(distance, half_width), sub(valley, half_width)));
  const N flank = add(times(smooth(t), 0.72F), times(mul(t, t), 0.28F));
  cut.near = true;
  cut.share = stream.share;
  cut.left = less(1, mul(stream.share, less(1, flank)));
  if (all_above(distance, half_width)) return cut;
  const N shallow = less(1, times(ramp(0.5F, 6, lifted), 0.7F));
  const N deepest = mul(at_most(times(stream.width, 0.5F), depth), shallow);
  const N across = smooth(unit(less(1, quotient(distance, half_width))));
  cut.in_bed = true;
  cut.bed = mul(mul(stream.share, deepest), across);
  return cut;
}

template <class N>
struct Height {
  N height;  // above the sea
  N terraces;
  N small;
  N stepped;      // rise of the land by terraces
  N bed;          // depth by which a river lowers it
  N river;        // Stream::share of that river
  N flood_plain;  // height of the flood plain
};

HWY_INLINE Height<RegionVector> half_of(const Height<Two>& two, RegionVector Two::*half) {
  return {two.height.*half, two.terraces.*half, two.small.*half,      two.stepped.*half,
          two.bed.*half,    two.river.*half,    two.flood_plain.*half};
}

template <class N>
HWY_INLINE Height<N> cut(const UncutLand<N>& u, const RegionShape& shape, float widened) {
  const Valleys<N> valleys = valleys_of(u, shape, widened);
  const Cut<N> main = cut_by(
      u.river, valleys.main, valleys.main_reach, [&]() HWY_ATTR { return main_stream(u, shape); }, u.lifted,
      shape.bed + 1.2F, widened);
  const Cut<N> side = cut_by(
      u.tributary, valleys.side, valleys.side_reach, [&]() HWY_ATTR { return side_stream(u, shape); },
      u.lifted, 0.8F * shape.bed + 1.2F, widened);
  const bool near = main.near || side.near;
  const N flood_plain = plus(u.lifted, 1.2F);
  N over = sub(u.land, flood_plain);
  N left = main.left;
  if (near) {
    left = mul(main.left, side.left);
    over = mul(over, left);
  }
  N height = where_above(u.land, flood_plain, add(flood_plain, over), u.land);
  N terraces = times(u.land, 0);
  N stepped = terraces;
  N bed = terraces;
  N river = terraces;
  if (!none(u.mesa)) {
    // A valley lowers the terraces' field instead of the land, so canyons are stepped.
    N field = plus(u.terrace_field, 0.1F);
    if (near) field = plus(sub(u.terrace_field, times(less(1, unit(times(left, 1.15F))), 0.6F)), 0.1F);
    terraces = on_spline(shape.terraces, field);
    stepped = mul(times(u.mesa, shape.mesa_height), terraces);
    if (near) stepped = mul(stepped, smooth(unit(times(left, 4))));
    height = add(height, stepped);
  }
  // The sea's floor has no beds.
  if (main.in_bed || side.in_bed) {
    bed = mul(larger(main.bed, side.bed), ramp(-9, -1, u.land));
    river = where_above(side.bed, main.bed, side.share, main.share);
    height = sub(height, bed);
  }
  // Beaches: near the shore the land is flatter.
  const N from_shore = times(size_of(height), 1.0F / 7);
  if (!all_at_least(from_shore, 1)) {
    height = mul(height, plus(times(smooth(unit(from_shore)), 0.7F), 0.3F));
  }
  return {height, terraces, u.small, stepped, bed, river, flood_plain};
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
