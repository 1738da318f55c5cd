#include "regions.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/rotated_fbm.h"
#include "surface/regions/regions.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/regions.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using RegionTag = hn::ScalableTag<float>;
using RegionVector = hn::Vec<RegionTag>;

/// A number of each lane.
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
/// `yes` where a > b.
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

/// A number, and how it rises a column eastward and southward: what is computed with it has its derivatives.
struct Sloped {
  RegionVector v;
  RegionVector x;
  RegionVector z;
};

HWY_INLINE Sloped add(Sloped a, Sloped b) {
  return {hn::Add(a.v, b.v), hn::Add(a.x, b.x), hn::Add(a.z, b.z)};
}
HWY_INLINE Sloped sub(Sloped a, Sloped b) {
  return {hn::Sub(a.v, b.v), hn::Sub(a.x, b.x), hn::Sub(a.z, b.z)};
}
HWY_INLINE Sloped mul(Sloped a, Sloped b) {
  return {hn::Mul(a.v, b.v), hn::Add(hn::Mul(a.x, b.v), hn::Mul(a.v, b.x)),
          hn::Add(hn::Mul(a.z, b.v), hn::Mul(a.v, b.z))};
}
HWY_INLINE Sloped quotient(Sloped a, Sloped b) {
  const auto q = hn::Div(a.v, b.v);
  return {q, hn::Div(hn::Sub(a.x, hn::Mul(q, b.x)), b.v), hn::Div(hn::Sub(a.z, hn::Mul(q, b.z)), b.v)};
}
/// Level where it is 0.
HWY_INLINE Sloped root(Sloped a) {
  const auto r = hn::Sqrt(a.v);
  const auto by = hn::IfThenElseZero(hn::Gt(r, constant(1e-6F)), hn::Div(constant(0.5F), r));
  return {r, hn::Mul(a.x, by), hn::Mul(a.z, by)};
}
HWY_INLINE Sloped size_of(Sloped a) {
  const auto negative = hn::Lt(a.v, constant(0));
  return {hn::Abs(a.v), hn::IfThenElse(negative, hn::Neg(a.x), a.x),
          hn::IfThenElse(negative, hn::Neg(a.z), a.z)};
}
HWY_INLINE Sloped where_above(Sloped a, Sloped b, Sloped yes, Sloped no) {
  const auto above = hn::Gt(a.v, b.v);
  return {hn::IfThenElse(above, yes.v, no.v), hn::IfThenElse(above, yes.x, no.x),
          hn::IfThenElse(above, yes.z, no.z)};
}
HWY_INLINE Sloped larger(Sloped a, Sloped b) {
  return where_above(a, b, a, b);
}
HWY_INLINE Sloped smaller(Sloped a, Sloped b) {
  return where_above(a, b, b, a);
}
HWY_INLINE Sloped times(Sloped a, float factor) {
  return {times(a.v, factor), times(a.x, factor), times(a.z, factor)};
}
HWY_INLINE Sloped plus(Sloped a, float more) {
  return {plus(a.v, more), a.x, a.z};
}
HWY_INLINE Sloped less(float whole, Sloped a) {
  return {less(whole, a.v), hn::Neg(a.x), hn::Neg(a.z)};
}
HWY_INLINE Sloped level(float value) {
  return {constant(value), constant(0), constant(0)};
}
HWY_INLINE Sloped at_least(Sloped a, float least) {
  return larger(a, level(least));
}
HWY_INLINE Sloped at_most(Sloped a, float most) {
  return smaller(a, level(most));
}
HWY_INLINE Sloped unit(Sloped a) {
  const auto inside = hn::And(hn::Gt(a.v, constant(0)), hn::Lt(a.v, constant(1)));
  return {unit(a.v), hn::IfThenElseZero(inside, a.x), hn::IfThenElseZero(inside, a.z)};
}
HWY_INLINE RegionVector value_of(Sloped a) {
  return a.v;
}

/// Two vectors' numbers. A height is one long chain of operations, and the other vector's runs beside it.
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

/// From 0 at `none` to 1 at `all`.
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
/// Its curve is odd, so that its derivative is even.
HWY_INLINE Sloped equalized(const Equalizer& equalizer, Sloped noise) {
  const Sloped half = on_spline(equalizer.half(), size_of(times(noise, equalizer.reciprocal_deviation())));
  const auto negative = hn::Lt(noise.v, constant(0));
  return {hn::CopySign(half.v, noise.v), hn::IfThenElse(negative, hn::Neg(half.x), half.x),
          hn::IfThenElse(negative, hn::Neg(half.z), half.z)};
}

void displace(const SlopedRow& wide, const SlopedRow& narrow, const std::array<float, 2>& reach,
              std::size_t width, std::int32_t* out, const Stretch& stretch) {
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  const auto most = constant(4194304);             // 2^22
  const auto no_fraction = constant(12582912.0F);  // 1.5 * 2^23: a float of this size has none
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto sum = [&](const float* w, const float* n) HWY_ATTR {
      return hn::Add(times(hn::LoadU(f, w + i), reach[0]), times(hn::LoadU(f, n + i), reach[1]));
    };
    const auto bounded = hn::Max(hn::Min(sum(wide.value, narrow.value), most), hn::Neg(most));
    const auto whole = hn::Sub(hn::Add(bounded, no_fraction), no_fraction);
    hn::StoreU(hn::ConvertTo(ints, whole), ints, out + i);
    hn::StoreU(times(sum(wide.east, narrow.east), 1.0F / 256), f, stretch.by_x + i);
    hn::StoreU(times(sum(wide.south, narrow.south), 1.0F / 256), f, stretch.by_z + i);
  }
}

void distances(const SlopedRow& noise, const Stretch& east, const Stretch& south, float saddle,
               float units_a_column, std::size_t width, const SlopedOut& out) {
  const RegionTag f;
  const auto most = constant(1000);  // rivers are felt no further
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto load = [&](const float* values) HWY_ATTR { return hn::LoadU(f, values + i); };
    const auto n = load(noise.value);
    const auto rise_east = load(noise.east);
    const auto rise_south = load(noise.south);
    const auto gx =
        hn::Add(hn::Mul(rise_east, plus(load(east.by_x), 1)), hn::Mul(rise_south, load(south.by_x)));
    const auto gz =
        hn::Add(hn::Mul(rise_east, load(east.by_z)), hn::Mul(rise_south, plus(load(south.by_z), 1)));
    const auto squares = hn::Add(hn::Mul(gx, gx), hn::Mul(gz, gz));
    const auto rounded_off = plus(hn::Add(squares, times(hn::Abs(n), saddle)), 1e-14F);
    const auto units = times(hn::Div(n, hn::Sqrt(rounded_off)), units_a_column);
    hn::StoreU(hn::Max(hn::Min(units, most), hn::Neg(most)), f, out.value + i);
    if (out.east == nullptr) continue;
    // Beside a river the distance rises by about a column a column across it.
    const auto rise = hn::Div(constant(units_a_column), hn::Sqrt(rounded_off));
    const auto near = hn::Lt(hn::Abs(units), most);
    hn::StoreU(hn::IfThenElseZero(near, hn::Mul(gx, rise)), f, out.east + i);
    hn::StoreU(hn::IfThenElseZero(near, hn::Mul(gz, rise)), f, out.south + i);
  }
}

template <class N>
struct Land {
  N base, belt, hills, mesa, temperature, moisture;
};

/// `field(of)` is what a field says, made uniform.
template <class N, class Field>
HWY_INLINE Land<N> laid(const SlowFields& fields, const Field& field) {
  const N continent = field(fields.continents, &SlowNoises::continents);
  const N range = size_of(field(fields.ranges, &SlowNoises::ranges));
  const N hilly = field(fields.hilliness, &SlowNoises::hilliness);
  const N warmth = plus(times(field(fields.temperature, &SlowNoises::temperature), 0.75F), 0.3F);
  const N temperature = at_most(at_least(plus(warmth, fields.warmer), -1), 1.2F);
  const N moisture =
      at_most(at_least(plus(field(fields.moisture, &SlowNoises::moisture), fields.wetter), -1), 1);
  const N inland = on_spline(fields.inland, continent);
  const N belt = mul(mul(on_spline(fields.belt, range), inland), on_spline(fields.passes, hilly));
  const N warm_and_dry = mul(ramp(0.05F, -0.3F, moisture), ramp(-0.1F, 0.15F, temperature));
  const N off_ranges = less(1, times(smooth(unit(times(belt, 2))), 0.85F));
  const N mesa = mul(mul(at_least(warm_and_dry, fields.mesas_anywhere), off_ranges),
                     ramp(fields.mesa_coast[0], fields.mesa_coast[1], continent));
  const N hills = mul(on_spline(fields.hills, hilly), plus(times(inland, 0.88F), 0.12F));
  return {on_spline(fields.base, continent),
          belt,
          mul(mul(hills, less(1, times(mesa, 0.55F))), less(1, times(belt, 0.5F))),
          mesa,
          temperature,
          moisture};
}

using LandRow = float* SlowLand::*;
constexpr std::array<LandRow, 4> kShapingRows{&SlowLand::base, &SlowLand::belt, &SlowLand::hills,
                                              &SlowLand::mesa};

template <class N>
HWY_INLINE std::array<N, 4> shaping(const Land<N>& land) {
  return {land.base, land.belt, land.hills, land.mesa};
}

void lay(const SlowNoises& noises, const SlowFields& fields, std::size_t width, const SlowLand& out) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto field = [&](const SlowFields::Field& of, const float* SlowNoises::*noise)
                           HWY_ATTR { return equalized(of.equalized, hn::LoadU(f, noises.*noise + i)); };
    const Land<RegionVector> land = laid<RegionVector>(fields, field);
    const auto rows = shaping(land);
    for (std::size_t k = 0; k < rows.size(); ++k) hn::StoreU(rows[k], f, out.*kShapingRows[k] + i);
    hn::StoreU(land.temperature, f, out.temperature + i);
    hn::StoreU(land.moisture, f, out.moisture + i);
  }
}

void lay_sloped(const SlowNoises& noises, const SlowNoises& east, const SlowNoises& south,
                const SlowFields& fields, std::size_t width, const SlowLand& out, const SlowLand& out_east,
                const SlowLand& out_south) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto field = [&](const SlowFields::Field& of, const float* SlowNoises::*noise) HWY_ATTR {
      return equalized(of.equalized, Sloped{hn::LoadU(f, noises.*noise + i), hn::LoadU(f, east.*noise + i),
                                            hn::LoadU(f, south.*noise + i)});
    };
    const Land<Sloped> land = laid<Sloped>(fields, field);
    const auto rows = shaping(land);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      hn::StoreU(rows[k].v, f, out.*kShapingRows[k] + i);
      hn::StoreU(rows[k].x, f, out_east.*kShapingRows[k] + i);
      hn::StoreU(rows[k].z, f, out_south.*kShapingRows[k] + i);
    }
    hn::StoreU(land.temperature.v, f, out.temperature + i);
    hn::StoreU(land.moisture.v, f, out.moisture + i);
  }
}

void bend(const SlopedRow& noise, const Stretch& east, const Stretch& south, float share, std::size_t width,
          float* out_east, float* out_south) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto load = [&](const float* values) HWY_ATTR { return hn::LoadU(f, values + i); };
    const auto stretched = [&](const float* by) HWY_ATTR { return times(load(by), share); };
    const auto e = load(noise.east);
    const auto s = load(noise.south);
    hn::StoreU(hn::Add(hn::Mul(e, plus(stretched(east.by_x), 1)), hn::Mul(s, stretched(south.by_x))), f,
               out_east + i);
    hn::StoreU(hn::Add(hn::Mul(e, stretched(east.by_z)), hn::Mul(s, plus(stretched(south.by_z), 1))), f,
               out_south + i);
  }
}

/// The polynomials between samples, cell by cell: c[0] + t (c[1] + t (c[2] + t c[3])), t from 0 at the cell's
/// west to 1 at its east. Each has the samples' own slopes, those of the lines through their neighbours.
struct Cubics {
  const float* c[4];
};

/// `scratch`: 4 rows as wide as the samples, padded.
Cubics cubics_of(const float* samples, std::size_t count, float* scratch) {
  const RegionTag f;
  const std::size_t row = padded(count);
  for (std::size_t i = 0; i + 3 < count; i += hn::Lanes(f)) {
    const auto sample = [&](std::size_t k) HWY_ATTR { return hn::LoadU(f, samples + i + k); };
    const auto before = sample(0);
    const auto west = sample(1);
    const auto east = sample(2);
    const auto after = sample(3);
    const auto first = times(hn::Sub(east, before), 0.5F);
    const auto third = hn::Add(times(hn::Sub(after, before), 0.5F), times(hn::Sub(west, east), 1.5F));
    hn::StoreU(west, f, scratch + i);
    hn::StoreU(first, f, scratch + row + i);
    hn::StoreU(hn::Sub(hn::Sub(hn::Sub(east, west), first), third), f, scratch + 2 * row + i);
    hn::StoreU(third, f, scratch + 3 * row + i);
  }
  return {{scratch, scratch + row, scratch + 2 * row, scratch + 3 * row}};
}

void blend_lines(const SampleLines& lines, std::size_t width, float* out) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    auto sum = times(hn::LoadU(f, lines.line[0] + i), lines.share[0]);
    for (std::size_t k = 1; k < lines.line.size(); ++k) {
      sum = hn::Add(sum, times(hn::LoadU(f, lines.line[k] + i), lines.share[k]));
    }
    hn::StoreU(sum, f, out + i);
  }
}

template <class Tag, class V = hn::Vec<Tag>>
HWY_INLINE void store_cubic(Tag f, const V (&c)[4], V t, float* out, float* rise) {
  hn::StoreU(hn::Add(c[0], hn::Mul(t, hn::Add(c[1], hn::Mul(t, hn::Add(c[2], hn::Mul(t, c[3])))))), f, out);
  if (rise == nullptr) return;
  const auto twice = hn::Add(c[2], c[2]);
  const auto thrice = hn::Mul(hn::Set(f, 3.0F), c[3]);
  const auto a_cell = hn::Add(c[1], hn::Mul(t, hn::Add(twice, hn::Mul(t, thrice))));
  hn::StoreU(hn::Mul(a_cell, hn::Set(f, 1.0F / static_cast<float>(kSampleStep))), f, rise);
}

template <std::size_t kColumns>
void spread_over(const Cubics& cubics, std::size_t cells, const float* fractions, float* out, float* rise) {
  const hn::CappedTag<float, kColumns> f;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const hn::Vec<decltype(f)> c[4] = {hn::Set(f, cubics.c[0][cell]), hn::Set(f, cubics.c[1][cell]),
                                       hn::Set(f, cubics.c[2][cell]), hn::Set(f, cubics.c[3][cell])};
    for (std::size_t k = 0; k < kColumns; k += hn::Lanes(f)) {
      const std::size_t at = cell * kColumns + k;
      store_cubic(f, c, hn::LoadU(f, fractions + k), out + at, rise == nullptr ? nullptr : rise + at);
    }
  }
}

/// The same where a vector has more columns than a cell.
template <std::size_t kColumns>
void spread_cells(const Cubics& cubics, std::size_t cells, const float* fractions, float* out, float* rise) {
#if HWY_TARGET == HWY_SCALAR
  spread_over<kColumns>(cubics, cells, fractions, out, rise);
#else
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  constexpr std::size_t kLanes = hn::MaxLanes(RegionTag{});
  if constexpr (kLanes <= kColumns) {
    spread_over<kColumns>(cubics, cells, fractions, out, rise);
  } else {
    HWY_ALIGN std::int32_t cell_of[kLanes];
    HWY_ALIGN float fraction_of[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i) {
      cell_of[i] = static_cast<std::int32_t>(i / kColumns);
      fraction_of[i] = fractions[i % kColumns];
    }
    const auto lanes = hn::IndicesFromVec(f, hn::Load(ints, cell_of));
    const auto fraction = hn::Load(f, fraction_of);
    for (std::size_t first = 0; first < cells; first += kLanes / kColumns) {
      const auto of_cells = [&](const float* values) HWY_ATTR {
        return hn::TableLookupLanes(hn::LoadU(f, values + first), lanes);
      };
      const RegionVector c[4] = {of_cells(cubics.c[0]), of_cells(cubics.c[1]), of_cells(cubics.c[2]),
                                 of_cells(cubics.c[3])};
      const std::size_t at = first * kColumns;
      store_cubic(f, c, fraction, out + at, rise == nullptr ? nullptr : rise + at);
    }
  }
#endif
}

void spread(const float* samples, const Cells& cells, float* out, float* rise) {
  const Cubics cubics = cubics_of(samples, cells.count + 3, cells.scratch);
  switch (cells.columns) {
    case 16:
      return spread_cells<16>(cubics, cells.count, cells.fractions, out, rise);
    case 8:
      return spread_cells<8>(cubics, cells.count, cells.fractions, out, rise);
    case 4:
      return spread_cells<4>(cubics, cells.count, cells.fractions, out, rise);
    case 2:
      return spread_cells<2>(cubics, cells.count, cells.fractions, out, rise);
    default:
      return spread_over<1>(cubics, cells.count, cells.fractions, out, rise);
  }
}

/// Whether all lanes are 0, derivatives too.
HWY_INLINE bool none(RegionVector v) {
  return hn::AllTrue(RegionTag{}, hn::Eq(v, constant(0)));
}
HWY_INLINE bool none(Two m) {
  return none(hn::Or(hn::Abs(m.a), hn::Abs(m.b)));
}
HWY_INLINE bool none(Sloped a) {
  return none(hn::Or(hn::Or(hn::Abs(a.v), hn::Abs(a.x)), hn::Abs(a.z)));
}

/// What is read of a row at some columns.
struct PlainAt {
  using Number = RegionVector;
  const RegionRow& row;
  std::size_t i;

  [[nodiscard]] HWY_INLINE RegionVector load(const float* RegionRow::*values) const {
    return hn::LoadU(RegionTag{}, row.*values + i);
  }
  [[nodiscard]] HWY_INLINE RegionVector octave(std::size_t k) const {
    return hn::LoadU(RegionTag{}, row.shape[k] + i);
  }
  [[nodiscard]] static HWY_INLINE RegionVector number(float value) { return constant(value); }
};
struct TwoAt {
  using Number = Two;
  const RegionRow& row;
  std::size_t i;

  [[nodiscard]] HWY_INLINE Two load(const float* RegionRow::*values) const { return both(row.*values + i); }
  [[nodiscard]] HWY_INLINE Two octave(std::size_t k) const { return both(row.shape[k] + i); }
  [[nodiscard]] static HWY_INLINE Two number(float value) { return {constant(value), constant(value)}; }

 private:
  [[nodiscard]] static HWY_INLINE Two both(const float* values) {
    const RegionTag f;
    return {hn::LoadU(f, values), hn::LoadU(f, values + hn::Lanes(f))};
  }
};
struct SlopedAt {
  using Number = Sloped;
  const SlopedRegionRow& row;
  std::size_t i;

  [[nodiscard]] HWY_INLINE Sloped load(const float* RegionRow::*values) const {
    const RegionTag f;
    return {hn::LoadU(f, row.value.*values + i), hn::LoadU(f, row.east.*values + i),
            hn::LoadU(f, row.south.*values + i)};
  }
  [[nodiscard]] HWY_INLINE Sloped octave(std::size_t k) const {
    const RegionTag f;
    return {hn::LoadU(f, row.value.shape[k] + i), hn::LoadU(f, row.east.shape[k] + i),
            hn::LoadU(f, row.south.shape[k] + i)};
  }
  [[nodiscard]] static HWY_INLINE Sloped number(float value) { return level(value); }
};

template <class N>
struct ShapeSums {
  N ridge;
  N hill;
  N small;
};

// Ridges where an octave is near 0, rounded off there; each shows the more of the next the higher it is.
template <class At, class N = typename At::Number>
HWY_INLINE N ridges(const At& at, const RegionShape& shape) {
  constexpr float kRound = 0.045F;
  N sum = at.number(0);
  N shown = at.number(1);
  for (std::size_t k = 0; k < static_cast<std::size_t>(kShapeOctaves); ++k) {
    const N size = size_of(at.octave(k));
    const N inside = at_least(less(kRound, size), 0);
    const N distance = add(size, times(mul(inside, inside), 0.5F / kRound));
    const N crest = at_least(less(1, times(distance, 1.8F)), 0);
    const N signal = mul(mul(crest, crest), shown);
    sum = add(sum, times(signal, shape.ridge_weights[k]));
    shown = at_most(plus(times(signal, 1.1F), 0.3F), 1);
  }
  return sum;
}

/// `ridged`: whether any ridge stands here; where none does they cost nothing.
template <class At, class N = typename At::Number>
HWY_INLINE ShapeSums<N> summed(const At& at, const RegionShape& shape, bool ridged) {
  ShapeSums<N> sums{at.number(0), at.number(0), at.number(0)};
  if (ridged) sums.ridge = ridges(at, shape);
  for (std::size_t k = 1; k < static_cast<std::size_t>(kShapeOctaves); ++k) {
    const N n = at.octave(k);
    sums.hill = add(sums.hill, times(n, shape.hill_weights[k]));
    if (k >= static_cast<std::size_t>(kSmallFrom)) {
      sums.small = add(sums.small, times(n, shape.small_weights[k]));
    }
  }
  return sums;
}

/// The land before rivers cut it, and what decides how they would.
template <class N>
struct Uncut {
  N base, belt, plain, toward_hills, land, lifted, mesa, terrace_field, small;
  N river, tributary;
};

// What adds or takes away nothing at all of a vector's columns is not computed: each `if` here leaves the
// numbers that the formula under it would give, to the bit.
template <class At, class N = typename At::Number>
HWY_INLINE Uncut<N> uncut_at(const At& at, const RegionShape& shape) {
  const N base = at.load(&RegionRow::base);
  // Between samples a curve may pass a little beyond them.
  const N belt = unit(at.load(&RegionRow::belt));
  const N hills = at.load(&RegionRow::hills);
  const N mesa = at_least(at.load(&RegionRow::mesa), 0);
  const N river = at.load(&RegionRow::river);
  const bool ridged = !none(belt);
  const ShapeSums<N> sums = summed(at, shape, ridged);

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
  const N tributary =
      where_above(river, at.number(0), at.load(&RegionRow::tributary_a), at.load(&RegionRow::tributary_b));
  return {base,
          belt,
          plain,
          add(plain, times(hills, 0.3F)),
          add(add(plain, mul(hills, hill)), relief),
          lifted,
          mesa,
          add(at.load(&RegionRow::terrace), times(sums.small, shape.mesa_roughness)),
          sums.small,
          size_of(river),
          size_of(tributary)};
}

HWY_INLINE Uncut<RegionVector> value_of(const Uncut<Sloped>& u) {
  return {u.base.v, u.belt.v,          u.plain.v, u.toward_hills.v, u.land.v,     u.lifted.v,
          u.mesa.v, u.terrace_field.v, u.small.v, u.river.v,        u.tributary.v};
}

/// A river, or its tributaries, at a column.
template <class N>
struct Stream {
  N share;  // 0 to 1, how much of it there is
  N width;  // half of it
};
constexpr float kWidest = 0.8F + 0.8F;  // of its half width in the spec

// Toward its spring a river narrows, and is dry where it is no wider than a brook.
template <class N>
HWY_INLINE N wide_at(const Uncut<N>& u) {
  return plus(times(ramp(24, 3, u.base), 0.8F), 0.8F);
}
template <class N>
HWY_INLINE Stream<N> main_stream(const Uncut<N>& u, const RegionShape& shape) {
  const float high = shape.carve[0];
  const float low = shape.carve[1];
  const N wide = mul(wide_at(u), plus(times(ramp(high + 12, high - 28, u.plain), 0.75F), 0.25F));
  return {plus(times(ramp(low + 90, low + 30, u.plain), 0.55F), 0.45F), times(wide, shape.half_width[0])};
}
template <class N>
HWY_INLINE Stream<N> side_stream(const Uncut<N>& u, const RegionShape& shape) {
  const float low = shape.carve[1];
  const N wide = mul(wide_at(u), plus(times(ramp(low + 12, low - 16, u.toward_hills), 0.75F), 0.25F));
  return {ramp(low + 28, low, u.toward_hills), times(wide, shape.half_width[1])};
}

/// How a river or its tributaries cut the land at a column.
template <class N>
struct Cut {
  N left;               // of what stands over the flood plain: 0 in the bed, 1 outside the valley
  N bed;                // how deep under the flood plain
  N share;              // of Stream; 0 where it is not near
  bool near = false;    // of all columns of a vector: else `left` is 1
  bool in_bed = false;  // else `bed` is 0
};

template <class N>
HWY_INLINE bool all_above(N a, N b) {
  return hn::AllTrue(RegionTag{}, hn::Gt(value_of(a), value_of(b)));
}
HWY_INLINE bool all_above(Two m, Two n) {
  return hn::AllTrue(RegionTag{}, hn::And(hn::Gt(m.a, n.a), hn::Gt(m.b, n.b)));
}
template <class N>
HWY_INLINE bool all_at_least(N a, float least) {
  return hn::AllTrue(RegionTag{}, hn::Ge(value_of(a), constant(least)));
}
HWY_INLINE bool all_at_least(Two m, float least) {
  return all_at_least(hn::Min(m.a, m.b), least);
}

/// How far from their middles rivers and tributaries are felt, or further: no column beyond is cut.
template <class N>
struct Valleys {
  N main, side;  // as they are
  N main_reach, side_reach;
};
template <class N>
HWY_INLINE Valleys<N> valleys_of(const Uncut<N>& u, const RegionShape& shape, float widened) {
  const N main = plus(times(u.belt, 150), shape.valley[0]);
  const N side = plus(times(u.belt, 120), shape.valley[1]);
  if (widened == 0) return {main, side, main, side};
  const auto at_most = [&](std::size_t i) { return std::max(kWidest * shape.half_width[i], widened); };
  return {main, side, at_least(main, at_most(0) + 2 * widened), at_least(side, at_most(1) + 2 * widened)};
}

/// `valley`, `reach`: of Valleys; `depth`: of its bed, where the river is wide enough; `widened`: how wide it
/// is at least. At the rim of a valley and beyond the flank is 1 without rounding.
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
  N height;  // over the sea
  N terraces;
  N small;
  N stepped;      // by how much terraces raise the land
  N bed;          // by how much a river lowers it
  N river;        // of what share of one that is
  N flood_plain;  // the height of one
};

HWY_INLINE Height<RegionVector> half_of(const Height<Two>& two, RegionVector Two::*half) {
  return {two.height.*half, two.terraces.*half, two.small.*half,      two.stepped.*half,
          two.bed.*half,    two.river.*half,    two.flood_plain.*half};
}

template <class N>
HWY_INLINE Height<N> cut(const Uncut<N>& u, const RegionShape& shape, float widened) {
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
    // A valley lowers the field of the terraces, not the land: so canyons are stepped.
    N field = plus(u.terrace_field, 0.1F);
    if (near) field = plus(sub(u.terrace_field, times(less(1, unit(times(left, 1.15F))), 0.6F)), 0.1F);
    terraces = on_spline(shape.terraces, field);
    stepped = mul(times(u.mesa, shape.mesa_height), terraces);
    if (near) stepped = mul(stepped, smooth(unit(times(left, 4))));
    height = add(height, stepped);
  }
  // The floor of the sea has none.
  if (main.in_bed || side.in_bed) {
    bed = mul(larger(main.bed, side.bed), ramp(-9, -1, u.land));
    river = where_above(side.bed, main.bed, side.share, main.share);
    height = sub(height, bed);
  }
  // Beaches: at the shore the land is flatter.
  const N from_shore = times(size_of(height), 1.0F / 7);
  if (!all_at_least(from_shore, 1)) {
    height = mul(height, plus(times(smooth(unit(from_shore)), 0.7F), 0.3F));
  }
  return {height, terraces, u.small, stepped, bed, river, flood_plain};
}

/// Without `mesa` country there are no terraces.
template <class N>
HWY_INLINE void store_details(const Height<N>& at, RegionVector mesa, const RegionDetails& details,
                              std::size_t i) {
  if (details.height == nullptr) return;
  const RegionTag f;
  hn::StoreU(value_of(at.height), f, details.height + i);
  hn::StoreU(hn::IfThenElseZero(hn::Gt(mesa, constant(0)), value_of(at.terraces)), f, details.terraces + i);
  hn::StoreU(value_of(at.small), f, details.small + i);
}

HWY_INLINE void store_height(RegionVector over_sea, const RegionShape& shape, float highest_fx,
                             std::int32_t* heights_fx) {
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  const auto height = hn::Max(plus(over_sea, shape.sea_level), constant(1));
  const auto height_fx = hn::Min(times(height, shape.subvoxels_a_unit), constant(highest_fx));
  hn::StoreU(talus::HWY_NAMESPACE::round_to_even(f, height_fx), ints, heights_fx);
}

void compose(const RegionRow& row, const RegionShape& shape, std::size_t width, float highest_fx,
             std::int32_t* heights_fx, const RegionDetails& details) {
  const std::size_t lanes = hn::Lanes(RegionTag{});
  const auto store = [&](const Height<RegionVector>& at, RegionVector mesa, std::size_t i) HWY_ATTR {
    store_details(at, mesa, details, i);
    store_height(at.height, shape, highest_fx, heights_fx + i);
  };
  // Processors with vectors of 16 columns have the registers for two.
  static_assert(2 * hn::MaxLanes(RegionTag{}) <= kPadding);
  if (lanes == 16) {
    for (std::size_t i = 0; i < width; i += 2 * lanes) {
      const auto uncut = uncut_at(TwoAt{row, i}, shape);
      const auto at = cut(uncut, shape, 0);
      store(half_of(at, &Two::a), uncut.mesa.a, i);
      store(half_of(at, &Two::b), uncut.mesa.b, i + lanes);
    }
  } else {
    for (std::size_t i = 0; i < width; i += lanes) {
      const auto uncut = uncut_at(PlainAt{row, i}, shape);
      store(cut(uncut, shape, 0), uncut.mesa, i);
    }
  }
}

void part(const RegionRow& row, const RegionShape& shape, std::size_t width, const LandParts& parts) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto at = cut(uncut_at(PlainAt{row, i}, shape), shape, 0);
    hn::StoreU(at.height, f, parts.height + i);
    hn::StoreU(at.stepped, f, parts.terraces + i);
    hn::StoreU(at.bed, f, parts.bed + i);
    hn::StoreU(at.river, f, parts.river + i);
    hn::StoreU(at.flood_plain, f, parts.flood_plain + i);
  }
}

constexpr float kRounder = 1.046875F;

void compose_sloped(const SlopedRegionRow& row, const RegionShape& shape, float widened, std::size_t width,
                    float highest_fx, std::int32_t* heights_fx, std::int32_t* slopes_fx,
                    const RegionDetails& details) {
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  const auto steepest = constant(4194304);  // 2^22
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto uncut = uncut_at(SlopedAt{row, i}, shape);
    const auto at = cut(uncut, shape, 0);
    store_details(at, uncut.mesa.v, details, i);
    // A plane rises most toward a diagonal neighbour: by both of its slopes. Ground is rounder than that, and
    // eq. 1 takes the steepest of its eight directions: kRounder was measured.
    const auto slope =
        times(hn::Add(hn::Abs(at.height.x), hn::Abs(at.height.z)), kRounder * shape.subvoxels_a_unit);
    hn::StoreU(talus::HWY_NAMESPACE::round_to_even(f, hn::Min(slope, steepest)), ints, slopes_fx + i);
    const auto plain = value_of(uncut);
    const auto valleys = valleys_of(plain, shape, widened);
    const bool far =
        all_above(plain.river, valleys.main_reach) && all_above(plain.tributary, valleys.side_reach);
    store_height(far ? at.height.v : cut(plain, shape, widened).height, shape, highest_fx, heights_fx + i);
  }
}

void equalize(const Equalizer& equalizer, const float* noise, std::size_t width, float* out) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    hn::StoreU(equalized(equalizer, hn::LoadU(f, noise + i)), f, out + i);
  }
}

void equalize_sloped(const Equalizer& equalizer, const SlopedRow& noise, std::size_t width,
                     const SlopedOut& out) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const Sloped uniform = equalized(
        equalizer,
        Sloped{hn::LoadU(f, noise.value + i), hn::LoadU(f, noise.east + i), hn::LoadU(f, noise.south + i)});
    hn::StoreU(uniform.v, f, out.value + i);
    hn::StoreU(uniform.x, f, out.east + i);
    hn::StoreU(uniform.z, f, out.south + i);
  }
}

}  // namespace

constexpr RegionKernels kRegions{displace,       distances,   lay,      lay_sloped,
                                 bend,           blend_lines, spread,   compose,
                                 compose_sloped, part,        equalize, equalize_sloped};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const RegionKernels& region_kernels(InstructionSet set) {
  static constexpr const RegionKernels* kTables[] = TALUS_TABLES(kRegions);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
