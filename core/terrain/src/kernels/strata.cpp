#include "strata.h"

#include <algorithm>
#include <limits>

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
using talus::HWY_NAMESPACE::over_row;
using talus::HWY_NAMESPACE::round_to_even;

using Floats = hn::ScalableTag<float>;

constexpr std::size_t kMaxVectors = std::min<std::size_t>(4, kSegment / hn::MaxLanes(Floats{}));

/// kVectors vectors of columns on which layers are stacked.
template <class Tag, std::size_t kVectors>
struct StackedVectors {
  using Ints = hn::RebindToSigned<Tag>;
  hn::Vec<Ints> most[kVectors];
  hn::Vec<Ints> reached[kVectors];

  HWY_INLINE StackedVectors(const std::int32_t* limit, const std::int32_t* below) {
    const Ints d;
    for (std::size_t v = 0; v < kVectors; ++v) {
      most[v] = hn::LoadU(d, limit + v * hn::Lanes(d));
      reached[v] = hn::LoadU(d, below + v * hn::Lanes(d));
    }
  }

  /// Adds a layer to vector v.
  template <bool kBounded>
  HWY_INLINE void add_uncut(std::size_t v, const LayerShape& shape, hn::Vec<Tag> noise) {
    const Tag f;
    auto swell = hn::Add(hn::Set(f, 1.0F), hn::Mul(hn::Set(f, shape.swing), noise));
    if constexpr (!kBounded) swell = hn::Max(hn::Zero(f), swell);
    auto thickness = hn::Mul(hn::Set(f, shape.mean_fx), swell);
    if constexpr (!kBounded) thickness = hn::Min(thickness, hn::Set(f, shape.max_fx));
    reached[v] = hn::Add(reached[v], round_to_even(f, thickness));
  }
  /// Adds a layer to vector v, cut at the limit.
  template <bool kBounded>
  HWY_INLINE void add(std::size_t v, const LayerShape& shape, hn::Vec<Tag> noise) {
    add_uncut<kBounded>(v, shape, noise);
    reached[v] = hn::Min(reached[v], most[v]);
  }

  HWY_INLINE void store(std::int32_t* top) const {
    const Ints d;
    for (std::size_t v = 0; v < kVectors; ++v) hn::StoreU(reached[v], d, top + v * hn::Lanes(d));
  }

  /// Minimum distance from the top to the limit.
  [[nodiscard]] HWY_INLINE std::int32_t room() const {
    const Ints d;
    auto least = hn::Sub(most[0], reached[0]);
    for (std::size_t v = 1; v < kVectors; ++v) least = hn::Min(least, hn::Sub(most[v], reached[v]));
    return hn::GetLane(hn::MinOfLanes(d, least));
  }

  /// Returns true if a row of tops is at the limit.
  HWY_INLINE bool is_full(const std::int32_t* top) const {
    const Ints d;
    auto differs = hn::Zero(d);
    for (std::size_t v = 0; v < kVectors; ++v) {
      differs = hn::Or(differs, hn::Xor(hn::LoadU(d, top + v * hn::Lanes(d)), most[v]));
    }
    return hn::AllTrue(d, hn::Eq(differs, hn::Zero(d)));
  }
};

/// Columns [x, end) of a row: `stack_at<kVectors>(f, x)` processes kVectors vectors of them with tag `f`.
template <class StackAt>
HWY_INLINE void over_columns(std::size_t x, std::size_t end, std::size_t width, const StackAt& stack_at) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  for (; x + kMaxVectors * lanes <= end; x += kMaxVectors * lanes) {
    stack_at.template operator()<kMaxVectors>(f, x);
  }
  for (; x + lanes <= end; x += lanes) stack_at.template operator()<1>(f, x);
  if (x < end && width >= lanes) {
    // The last vector overlaps processed columns and gives the same results.
    stack_at.template operator()<1>(f, width - lanes);
  } else {
    for (; x < end; ++x) stack_at.template operator()<1>(hn::CappedTag<float, 1>{}, x);
  }
}

/// Runs over the open segments of a row: `stack_at<kVectors>(f, x)` returns the number of layers that its
/// columns take, and `fill(first, last)` fills the columns of closed segments. Returns the maximum number of
/// layers; 0 if no segment is open.
template <class StackAt, class Fill>
HWY_INLINE std::size_t over_open(std::size_t width, std::size_t count, std::uint8_t* open,
                                 const StackAt& stack_at, const Fill& fill) {
  std::size_t most = 0;
  for (std::size_t x = 0; x < width; x += kSegment, ++open) {
    const std::size_t end = std::min(x + kSegment, width);
    if (*open == 0) {
      fill(x, end);
      continue;
    }
    std::size_t taken = 0;
    over_columns(x, end, width, [&]<std::size_t kVectors, class Tag>(Tag f, std::size_t at) HWY_ATTR {
      taken = std::max(taken, stack_at.template operator()<kVectors>(f, at));
    });
    *open = taken > count ? 1 : 0;
    most = std::max(most, taken);
  }
  return most;
}

void find_rises(const float* noise, std::size_t row, std::size_t count, float* rise) {
  const std::size_t last = (count - 1) * row;
  over_row(Floats{}, last, [=](auto f, std::size_t i) HWY_ATTR {
    hn::StoreU(hn::Sub(hn::LoadU(f, noise + row + i), hn::LoadU(f, noise + i)), f, rise + i);
  });
  std::fill_n(rise + last, row, 0.0F);
}

bool stack(const OctaveRow* octaves, std::size_t count, const LayerShape& shape, std::size_t width,
           const std::int32_t* limit, const std::int32_t* below, std::uint8_t* open, std::int32_t* top) {
  // Copied, because stores might alias the shape.
  const auto stack_at = [=, own = shape]<std::size_t kVectors, class Tag>(Tag f, std::size_t at) HWY_ATTR {
    StackedVectors<Tag, kVectors> columns{limit + at, below + at};
    with_noise<kVectors>(f, octaves, count, at, [&](std::size_t v, auto noise) HWY_ATTR {
      columns.template add<false>(v, own, noise);
    });
    columns.store(top + at);
    return columns.is_full(top + at) ? std::size_t{1} : std::size_t{2};
  };
  const auto fill = [=](std::size_t first, std::size_t last) {
    std::copy(limit + first, limit + last, top + first);
  };
  return over_open(width, 1, open, stack_at, fill) > 1;
}

/// Calls `use` with the noise of kVectors vectors of a row from column `at` on.
template <std::size_t kVectors, class Tag, class Use>
HWY_INLINE void with_lined_noise(Tag f, const LinedLayer& layer, const RowBetween& row, std::size_t at,
                                 const Use& use) {
  const auto share = hn::Set(f, row.share);
  const float* const line = layer.noise + row.line + at;
  const float* const rise = layer.rise + row.line + at;
  for (std::size_t v = 0; v < kVectors; ++v) {
    const std::size_t x = v * hn::Lanes(f);
    use(v, hn::Add(hn::LoadU(f, line + x), hn::Mul(share, hn::LoadU(f, rise + x))));
  }
}

template <bool kBounded>
HWY_INLINE std::size_t stack_lined(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                                   std::size_t width, const std::int32_t* limit, const std::int32_t* below,
                                   std::uint8_t* open) {
  const LinedLayer* const end = layers + count;
  const auto stack_at = [=, own = row]<std::size_t kVectors, class Tag>(Tag f, std::size_t at) HWY_ATTR {
    StackedVectors<Tag, kVectors> columns{limit + at, below + at};
    for (const LinedLayer* layer = layers; layer != end; ++layer) {
      const LayerShape shape = layer->shape;
      with_lined_noise<kVectors>(f, *layer, own, at, [&](std::size_t v, auto noise) HWY_ATTR {
        columns.template add<kBounded>(v, shape, noise);
      });
      columns.store(layer->top + own.top + at);
    }
    // Full columns stay full with further layers. They are few.
    if (!columns.is_full(layers[count - 1].top + own.top + at)) return count + 1;
    std::size_t taken = 1;
    while (!columns.is_full(layers[taken - 1].top + own.top + at)) ++taken;
    return taken;
  };
  const auto fill = [=, first_top = row.top](std::size_t first, std::size_t last) {
    for (const LinedLayer* layer = layers; layer != end; ++layer) {
      std::copy(limit + first, limit + last, layer->top + first_top + first);
    }
  };
  return over_open(width, count, open, stack_at, fill);
}

std::size_t stack_between(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                          std::size_t width, const std::int32_t* limit, const std::int32_t* below,
                          std::uint8_t* open) {
  const bool bounded =
      std::all_of(layers, layers + count, [](const LinedLayer& layer) { return layer.shape.is_bounded(); });
  return bounded ? stack_lined<true>(layers, count, row, width, limit, below, open)
                 : stack_lined<false>(layers, count, row, width, limit, below, open);
}

std::int32_t stack_inside(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                          std::size_t width, const std::int32_t* limit, const std::int32_t* below) {
  const LinedLayer* const end = layers + count;
  std::int32_t room = std::numeric_limits<std::int32_t>::max();
  const auto stack_at = [=, &room, own = row]<std::size_t kVectors, class Tag>(Tag f,
                                                                               std::size_t at) HWY_ATTR {
    StackedVectors<Tag, kVectors> columns{limit + at, below + at};
    for (const LinedLayer* layer = layers; layer != end; ++layer) {
      const LayerShape shape = layer->shape;
      with_lined_noise<kVectors>(f, *layer, own, at, [&](std::size_t v, auto noise) HWY_ATTR {
        columns.template add_uncut<true>(v, shape, noise);
      });
      columns.store(layer->top + own.top + at);
    }
    room = std::min(room, columns.room());
  };
  over_columns(0, width, width, stack_at);
  return room;
}

}  // namespace

constexpr StrataKernels kStrata{find_rises, stack, stack_between, stack_inside};

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
