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

#include "kernels/region_cubics-inl.h"
#include "kernels/region_heights-inl.h"
#include "kernels/region_numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void displace(const SlopedRow& wide, const SlopedRow& narrow, const std::array<float, 2>& reach,
              std::size_t width, std::int32_t* out, const Stretch& stretch) {
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  const auto most = constant(4194304);             // 2^22
  const auto no_fraction = constant(12582912.0F);  // 1.5 * 2^23: floats of this size have no fraction
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
               float units_a_column, std::size_t width, const SlopedOutput& out) {
  const RegionTag f;
  const auto most = constant(1000);  // maximum distance at which rivers matter
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
    // Near a river the distance rises by about one column per column across it.
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

/// `field(of)` returns a field's values, made uniform.
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
      return equalized(of.equalized,
                       SlopedNumber{hn::LoadU(f, noises.*noise + i), hn::LoadU(f, east.*noise + i),
                                    hn::LoadU(f, south.*noise + i)});
    };
    const Land<SlopedNumber> land = laid<SlopedNumber>(fields, field);
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

HWY_INLINE void store_country(const Country<RegionVector>& country, const RegionDetails& details,
                              std::size_t i) {
  if (details.base == nullptr) return;
  const RegionTag f;
  hn::StoreU(country.base, f, details.base + i);
  hn::StoreU(country.belt, f, details.belt + i);
  hn::StoreU(country.mesa, f, details.mesa + i);
}

HWY_INLINE void store_height(RegionVector over_sea, const RegionShape& shape, float highest_fx,
                             std::int32_t* heights_fx) {
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  const auto height = hn::Max(plus(over_sea, shape.sea_level), constant(1));
  const auto height_fx = hn::Min(times(height, shape.subvoxels_a_unit), constant(highest_fx));
  hn::StoreU(talus::HWY_NAMESPACE::round_to_even(f, height_fx), ints, heights_fx);
}

/// `At{row, i}` reads the columns from i on.
template <class At, class Row>
HWY_INLINE void compose_by(const Row& row, const RegionShape& shape, std::size_t width, float highest_fx,
                           std::int32_t* heights_fx, const RegionDetails& details) {
  const std::size_t lanes = hn::Lanes(RegionTag{});
  const auto store = [&](const Height<RegionVector>& at, RegionVector mesa, std::size_t i) HWY_ATTR {
    store_details(at, mesa, details, i);
    store_height(at.height, shape, highest_fx, heights_fx + i);
  };
  // Two vectors of 8 columns read the same cells; processors with wider ones have enough registers for two.
  static_assert(2 * hn::MaxLanes(RegionTag{}) <= kPadding);
  if (lanes >= 8) {
    for (std::size_t i = 0; i < width; i += 2 * lanes) {
      const At first{row, i};
      const TwoAt<At> two{first, first.next()};
      const Country<Two> country = country_at(two);
      store_country({country.base.a, country.belt.a, country.mesa.a}, details, i);
      store_country({country.base.b, country.belt.b, country.mesa.b}, details, i + lanes);
      const auto uncut = uncut_at(two, country, shape);
      const auto at = cut(uncut, shape, 0);
      store(half_of(at, &Two::a), uncut.mesa.a, i);
      store(half_of(at, &Two::b), uncut.mesa.b, i + lanes);
    }
  } else {
    for (std::size_t i = 0; i < width; i += lanes) {
      const At one{row, i};
      const Country<RegionVector> country = country_at(one);
      store_country(country, details, i);
      const auto uncut = uncut_at(one, country, shape);
      store(cut(uncut, shape, 0), uncut.mesa, i);
    }
  }
}

void compose(const RegionRow& row, const RegionShape& shape, std::size_t width, float highest_fx,
             std::int32_t* heights_fx, const RegionDetails& details) {
  compose_by<PlainAt>(row, shape, width, highest_fx, heights_fx, details);
}

void compose_cells(const RegionCells& cells, const RegionShape& shape, std::size_t width, float highest_fx,
                   std::int32_t* heights_fx, const RegionDetails& details) {
  compose_by<CellsAt>(cells, shape, width, highest_fx, heights_fx, details);
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
    // A plane rises most toward a diagonal neighbour, by both of its slopes. Ground is more rounded, and eq.
    // 1 takes the steepest of its eight directions; kRounder is measured.
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
                     const SlopedOutput& out) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const SlopedNumber uniform =
        equalized(equalizer, SlopedNumber{hn::LoadU(f, noise.value + i), hn::LoadU(f, noise.east + i),
                                          hn::LoadU(f, noise.south + i)});
    hn::StoreU(uniform.v, f, out.value + i);
    hn::StoreU(uniform.x, f, out.east + i);
    hn::StoreU(uniform.z, f, out.south + i);
  }
}

}  // namespace

constexpr RegionKernels kRegions{displace,       distances,      lay,      lay_sloped,     bend,
                                 blend_lines,    cubics_between, spread,   compose,        compose_cells,
                                 compose_sloped, part,           equalize, equalize_sloped};

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
