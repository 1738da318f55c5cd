#include "regions.h"

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

HWY_INLINE RegionVector constant(float value) {
  return hn::Set(RegionTag{}, value);
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
/// From 0 at `none` to 1 at `all`.
HWY_INLINE RegionVector ramp(float none, float all, RegionVector v) {
  return unit(times(plus(v, -none), 1 / (all - none)));
}
HWY_INLINE RegionVector smooth(RegionVector t) {
  return hn::Mul(hn::Mul(t, t), less(3, times(t, 2)));
}

HWY_INLINE RegionVector on_spline(const Spline& spline, RegionVector v) {
  auto y = constant(spline.first_y());
  for (const Spline::Segment& s : spline.segments()) {
    const auto t = unit(times(plus(v, -s.x), s.reciprocal));
    const auto inner = plus(hn::Mul(t, plus(times(t, s.c), s.b)), s.a);
    y = hn::Add(y, hn::Mul(t, inner));
  }
  return y;
}

HWY_INLINE RegionVector equalized(const Equalizer& equalizer, RegionVector noise) {
  const auto half = on_spline(equalizer.half(), hn::Abs(times(noise, equalizer.reciprocal_deviation())));
  return hn::CopySign(half, noise);
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
               float units_a_column, std::size_t width, float* out) {
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
    hn::StoreU(hn::Max(hn::Min(units, most), hn::Neg(most)), f, out + i);
  }
}

void lay(const SlowNoises& noises, const SlowFields& fields, std::size_t width, const SlowLand& land) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto field = [&](const SlowFields::Field& of, const float* noise)
                           HWY_ATTR { return equalized(of.equalized, hn::LoadU(f, noise + i)); };
    const auto bounded = [](RegionVector v, float least, float most)
                             HWY_ATTR { return hn::Min(hn::Max(v, constant(least)), constant(most)); };
    const auto continent = field(fields.continents, noises.continents);
    const auto range = hn::Abs(field(fields.ranges, noises.ranges));
    const auto hilly = field(fields.hilliness, noises.hilliness);
    const auto warmth = plus(times(field(fields.temperature, noises.temperature), 0.75F), 0.3F);
    const auto temperature = bounded(plus(warmth, fields.warmer), -1, 1.2F);
    const auto moisture = bounded(plus(field(fields.moisture, noises.moisture), fields.wetter), -1, 1);
    const auto inland = on_spline(fields.inland, continent);
    const auto belt =
        hn::Mul(hn::Mul(on_spline(fields.belt, range), inland), on_spline(fields.passes, hilly));
    const auto warm_and_dry = hn::Mul(ramp(0.05F, -0.3F, moisture), ramp(-0.1F, 0.15F, temperature));
    const auto off_ranges = less(1, times(smooth(unit(times(belt, 2))), 0.85F));
    const auto mesa = hn::Mul(hn::Mul(hn::Max(constant(fields.mesas_anywhere), warm_and_dry), off_ranges),
                              ramp(fields.mesa_coast[0], fields.mesa_coast[1], continent));
    const auto hills = hn::Mul(on_spline(fields.hills, hilly), plus(times(inland, 0.88F), 0.12F));
    hn::StoreU(on_spline(fields.base, continent), f, land.base + i);
    hn::StoreU(belt, f, land.belt + i);
    hn::StoreU(hn::Mul(hn::Mul(hills, less(1, times(mesa, 0.55F))), less(1, times(belt, 0.5F))), f,
               land.hills + i);
    hn::StoreU(mesa, f, land.mesa + i);
    hn::StoreU(field(fields.mesas, noises.mesas), f, land.terrace + i);
    hn::StoreU(temperature, f, land.temperature + i);
    hn::StoreU(moisture, f, land.moisture + i);
  }
}

template <std::size_t kColumns>
void spread_over(const float* samples, std::size_t cells, const float* fractions, float* out) {
  const hn::CappedTag<float, kColumns> f;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto west = hn::Set(f, samples[cell]);
    const auto rise = hn::Set(f, samples[cell + 1] - samples[cell]);
    for (std::size_t k = 0; k < kColumns; k += hn::Lanes(f)) {
      hn::StoreU(hn::Add(west, hn::Mul(rise, hn::LoadU(f, fractions + k))), f, out + cell * kColumns + k);
    }
  }
}

void spread(const float* samples, std::size_t cells, std::size_t columns, const float* fractions,
            float* out) {
  switch (columns) {
    case 8:
      return spread_over<8>(samples, cells, fractions, out);
    case 4:
      return spread_over<4>(samples, cells, fractions, out);
    case 2:
      return spread_over<2>(samples, cells, fractions, out);
    default:
      return spread_over<1>(samples, cells, fractions, out);
  }
}

struct ShapeSums {
  RegionVector ridge;
  RegionVector hill;
  RegionVector small;
};

// Ridges where an octave is near 0; each shows the more of the next the higher it is.
HWY_INLINE ShapeSums summed(const RegionRow& row, const RegionShape& shape, std::size_t i) {
  const RegionTag f;
  ShapeSums sums{constant(0), constant(0), constant(0)};
  auto shown = constant(1);
  for (std::size_t k = 0; k < row.shape.size(); ++k) {
    const auto n = hn::LoadU(f, row.shape[k] + i);
    const auto distance = hn::Sqrt(plus(hn::Mul(n, n), 0.0005F));
    const auto crest = hn::Max(less(1, times(distance, 1.8F)), constant(0));
    const auto signal = hn::Mul(hn::Mul(crest, crest), shown);
    sums.ridge = hn::Add(sums.ridge, times(signal, shape.ridge_weights[k]));
    shown = hn::Min(plus(times(signal, 1.1F), 0.3F), constant(1));
    if (k > 0) sums.hill = hn::Add(sums.hill, times(n, shape.hill_weights[k]));
    if (k >= static_cast<std::size_t>(kSlowOctaves)) {
      sums.small = hn::Add(sums.small, times(n, shape.small_weights[k]));
    }
  }
  return sums;
}

/// How a river or its tributaries cut the land at a column.
struct Cut {
  RegionVector left;  // of what stands over the flood plain: 0 in the bed, 1 outside the valley
  RegionVector bed;   // how deep under the flood plain
};

/// `share`: 0 to 1, how much of a river there is; `depth`: of its bed, where the river is wide enough.
HWY_INLINE Cut cut_by(RegionVector distance, RegionVector half_width, RegionVector valley, RegionVector share,
                      RegionVector shallow, float depth) {
  const auto t = unit(hn::Div(hn::Sub(distance, half_width), hn::Sub(valley, half_width)));
  const auto flank = hn::Add(times(smooth(t), 0.72F), times(hn::Mul(t, t), 0.28F));
  const auto deepest = hn::Mul(hn::Min(constant(depth), times(half_width, 0.5F)), shallow);
  const auto across = smooth(unit(less(1, hn::Div(distance, half_width))));
  return {less(1, hn::Mul(share, less(1, flank))), hn::Mul(hn::Mul(share, deepest), across)};
}

HWY_INLINE RegionVector height_at(const RegionRow& row, const RegionShape& shape, std::size_t i,
                                  const RegionDetails& details) {
  const RegionTag f;
  const auto load = [&](const float* values) HWY_ATTR { return hn::LoadU(f, values + i); };
  const auto base = load(row.base);
  const auto belt = load(row.belt);
  const auto hills = load(row.hills);
  const auto river = load(row.river);
  const ShapeSums sums = summed(row, shape, i);

  const auto filled = unit(plus(times(sums.hill, 0.45F), 0.5F));
  const auto hill = hn::Mul(filled, hn::Sqrt(filled));
  const auto ridge = hn::Max(plus(times(sums.ridge, shape.ridge_scale), -0.1F), constant(0));
  const auto over = hn::Max(plus(ridge, -0.9F), constant(0));
  const auto relief = hn::Add(hn::Min(ridge, constant(0.9F)), hn::Div(over, plus(times(over, 3), 1)));

  const auto plain = hn::Add(base, times(smooth(unit(belt)), shape.range_base));
  const auto above = hn::Max(plus(plain, -shape.carve[0]), constant(0));
  const auto lifted = hn::Div(hn::Mul(above, above), plus(above, 20));
  const auto flood_plain = plus(lifted, 1.2F);
  const auto wide = plus(times(ramp(24, 3, base), 0.8F), 0.8F);
  const auto shallow = less(1, times(ramp(0.5F, 6, lifted), 0.7F));
  const float low = shape.carve[1];
  const auto main_share = plus(times(ramp(low + 90, low + 30, plain), 0.55F), 0.45F);
  const auto side_share = ramp(low + 28, low, hn::Add(plain, times(hills, 0.3F)));
  const auto tributary =
      hn::IfThenElse(hn::Gt(river, constant(0)), load(row.tributary_a), load(row.tributary_b));
  const Cut main = cut_by(hn::Abs(river), times(wide, shape.half_width[0]),
                          plus(times(belt, 150), shape.valley[0]), main_share, shallow, shape.bed + 1.2F);
  const Cut side =
      cut_by(hn::Abs(tributary), times(wide, shape.half_width[1]), plus(times(belt, 120), shape.valley[1]),
             side_share, shallow, 0.8F * shape.bed + 1.2F);
  const auto left = hn::Mul(main.left, side.left);

  // A valley lowers the field of the terraces, not the land: so canyons are stepped.
  const auto rough = hn::Add(load(row.terrace), times(sums.small, shape.mesa_roughness));
  const auto cut_field = plus(hn::Sub(rough, times(less(1, unit(times(left, 1.15F))), 0.6F)), 0.1F);
  const auto terraces = on_spline(shape.terraces, cut_field);
  const auto mesa =
      hn::Mul(hn::Mul(times(load(row.mesa), shape.mesa_height), terraces), smooth(unit(times(left, 4))));

  const auto land =
      hn::Add(hn::Add(plain, hn::Mul(hills, hill)), hn::Mul(times(belt, shape.range_relief), relief));
  const auto carved = hn::Add(flood_plain, hn::Mul(hn::Sub(land, flood_plain), left));
  auto height = hn::IfThenElse(hn::Gt(land, flood_plain), carved, land);
  height = hn::Sub(hn::Add(height, mesa), hn::Mul(hn::Max(main.bed, side.bed), ramp(-9, -1, base)));
  // Beaches: at the shore the land is flatter.
  const auto from_shore = unit(times(hn::Abs(height), 1.0F / 7));
  height = hn::Mul(height, plus(times(smooth(from_shore), 0.7F), 0.3F));
  if (details.height != nullptr) {
    hn::StoreU(height, f, details.height + i);
    hn::StoreU(terraces, f, details.terraces + i);
    hn::StoreU(sums.small, f, details.small + i);
  }
  return hn::Max(plus(height, shape.sea_level), constant(1));
}

void compose(const RegionRow& row, const RegionShape& shape, std::size_t width, float highest_fx,
             std::int32_t* heights_fx, const RegionDetails& details) {
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto height_fx =
        hn::Min(times(height_at(row, shape, i, details), shape.subvoxels_a_unit), constant(highest_fx));
    hn::StoreU(talus::HWY_NAMESPACE::round_to_even(f, height_fx), ints, heights_fx + i);
  }
}

void equalize(const Equalizer& equalizer, const float* noise, std::size_t width, float* out) {
  const RegionTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    hn::StoreU(equalized(equalizer, hn::LoadU(f, noise + i)), f, out + i);
  }
}

}  // namespace

constexpr RegionKernels kRegions{displace, distances, lay, spread, compose, equalize};

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
