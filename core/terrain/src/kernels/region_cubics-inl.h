// Values between samples: cubics along a row, and straight lines between rows of samples. Included once per
// instruction set, hence this include guard:
#if defined(TALUS_REGION_CUBICS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_REGION_CUBICS_INL
#undef TALUS_REGION_CUBICS_INL
#else
#define TALUS_REGION_CUBICS_INL
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "kernels/region_numbers-inl.h"
#include "kernels/regions.h"

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

/// The polynomials between samples, by cell: c[0] + t (c[1] + t (c[2] + t c[3])), with t from 0 at the cell's
/// west to 1 at its east. At each sample the slope is the slope of the line through the sample's neighbours.
struct Cubics {
  const float* c[4];
};

struct Cubic {
  RegionVector c[4];
};

/// The cubics of cells; the sample before the first cell is at `samples`.
HWY_INLINE Cubic cubic_of(const float* samples) {
  const RegionTag f;
  const auto before = hn::LoadU(f, samples);
  const auto west = hn::LoadU(f, samples + 1);
  const auto east = hn::LoadU(f, samples + 2);
  const auto after = hn::LoadU(f, samples + 3);
  const auto first = times(hn::Sub(east, before), 0.5F);
  const auto third = hn::Add(times(hn::Sub(after, before), 0.5F), times(hn::Sub(west, east), 1.5F));
  return {{west, first, hn::Sub(hn::Sub(hn::Sub(east, west), first), third), third}};
}

HWY_INLINE void store(const Cubic& cubic, float* out, std::size_t plane) {
  const RegionTag f;
  for (std::size_t k = 0; k < 4; ++k) hn::StoreU(cubic.c[k], f, out + k * plane);
}

/// `scratch`: 4 rows as wide as the samples, padded.
Cubics cubics_of(const float* samples, std::size_t count, float* scratch) {
  const std::size_t row = padded(count);
  for (std::size_t i = 0; i + 3 < count; i += hn::Lanes(RegionTag{})) {
    store(cubic_of(samples + i), scratch + i, row);
  }
  return {{scratch, scratch + row, scratch + 2 * row, scratch + 3 * row}};
}

// Sums all rows into the last plane before any is read; otherwise loads would wait for the stores.
void cubics_between(const SampleRows& rows, std::size_t plane, float* planes) {
  const RegionTag f;
  float* const blended = planes + 4 * plane;
  for (std::size_t k = 0; k < rows.count; ++k) {
    for (std::size_t i = 0; i < rows.samples; i += hn::Lanes(f)) {
      auto sum = times(hn::LoadU(f, rows.line[0][k] + i), rows.share[0]);
      for (std::size_t n = 1; n < rows.line.size(); ++n) {
        sum = hn::Add(sum, times(hn::LoadU(f, rows.line[n][k] + i), rows.share[n]));
      }
      hn::StoreU(sum, f, blended + k * rows.stride + i);
    }
  }
  for (std::size_t i = 0; i < rows.count * rows.stride; i += hn::Lanes(f)) {
    store(cubic_of(blended + i), planes + i, plane);
  }
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

/// `kRises`: also stores the rise of the row per column.
template <bool kRises, class Tag, class V = hn::Vec<Tag>>
HWY_INLINE void store_cubic(Tag f, const V (&c)[4], V t, float* out, float* rise) {
  hn::StoreU(hn::Add(c[0], hn::Mul(t, hn::Add(c[1], hn::Mul(t, hn::Add(c[2], hn::Mul(t, c[3])))))), f, out);
  if constexpr (kRises) {
    const auto twice = hn::Add(c[2], c[2]);
    const auto thrice = hn::Mul(hn::Set(f, 3.0F), c[3]);
    const auto a_cell = hn::Add(c[1], hn::Mul(t, hn::Add(twice, hn::Mul(t, thrice))));
    hn::StoreU(hn::Mul(a_cell, hn::Set(f, 1.0F / static_cast<float>(kSampleStep))), f, rise);
  }
}

// The loop is bound by loads. It writes one vector-wide part of all cells at a time, with the part's
// fractions in a register; otherwise they might alias the stores and would be reloaded for each product.
template <bool kRises, std::size_t kColumns>
void spread_over(const Cubics& cubics, std::size_t cells, const float* fractions, float* out, float* rise) {
  const hn::CappedTag<float, kColumns> f;
  const float* const c_0 = cubics.c[0];
  const float* const c_1 = cubics.c[1];
  const float* const c_2 = cubics.c[2];
  const float* const c_3 = cubics.c[3];
  for (std::size_t k = 0; k < kColumns; k += hn::Lanes(f)) {
    const auto t = hn::LoadU(f, fractions + k);
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const hn::Vec<decltype(f)> c[4] = {hn::Set(f, c_0[cell]), hn::Set(f, c_1[cell]), hn::Set(f, c_2[cell]),
                                         hn::Set(f, c_3[cell])};
      const std::size_t at = cell * kColumns + k;
      store_cubic<kRises>(f, c, t, out + at, kRises ? rise + at : nullptr);
    }
  }
}

/// spread_over() also for vectors that are wider than a cell.
template <bool kRises, std::size_t kColumns>
void spread_cells(const Cubics& cubics, std::size_t cells, const float* fractions, float* out, float* rise) {
#if HWY_TARGET == HWY_SCALAR
  spread_over<kRises, kColumns>(cubics, cells, fractions, out, rise);
#else
  const RegionTag f;
  const hn::RebindToSigned<RegionTag> ints;
  constexpr std::size_t kLanes = hn::MaxLanes(RegionTag{});
  if constexpr (kLanes <= kColumns) {
    spread_over<kRises, kColumns>(cubics, cells, fractions, out, rise);
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
      store_cubic<kRises>(f, c, fraction, out + at, kRises ? rise + at : nullptr);
    }
  }
#endif
}

template <bool kRises>
void spread_by(const float* samples, const Cells& cells, float* out, float* rise) {
  const Cubics cubics = cubics_of(samples, cells.count + 3, cells.scratch);
  switch (cells.columns) {
    case 16:
      return spread_cells<kRises, 16>(cubics, cells.count, cells.fractions, out, rise);
    case 8:
      return spread_cells<kRises, 8>(cubics, cells.count, cells.fractions, out, rise);
    case 4:
      return spread_cells<kRises, 4>(cubics, cells.count, cells.fractions, out, rise);
    case 2:
      return spread_cells<kRises, 2>(cubics, cells.count, cells.fractions, out, rise);
    default:
      return spread_over<kRises, 1>(cubics, cells.count, cells.fractions, out, rise);
  }
}

void spread(const float* samples, const Cells& cells, float* out, float* rise) {
  if (rise == nullptr) {
    spread_by<false>(samples, cells, out, rise);
  } else {
    spread_by<true>(samples, cells, out, rise);
  }
}

}  // namespace
}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
