// What the voxels of a row may be, most likely first: FORMAT.md, "Volume: prediction".
// Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_CANDIDATES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_CANDIDATES_INL
#undef TALUS_VOLUME_CANDIDATES_INL
#else
#define TALUS_VOLUME_CANDIDATES_INL
#endif

#include <hwy/highway.h>

#include "volume_waves-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// A row of the wave that is being read or written.
template <class Voxel>
struct WaveRow {
  Voxel* voxels;
  RowsAround around;
};

/// What the second and third candidates of a row's voxels follow from. `now` is the row itself: its even
/// columns, where odd ones are looked at.
struct RowNeighbours {
  AroundMasks<RowMask> masks;
  RowVec north;
  RowVec below;
  RowVec now;
};
template <class Voxel>
HWY_INLINE RowNeighbours neighbours_of(const WaveRow<Voxel>& row, const AroundMasks<RowMask>& masks) {
  return {masks, load_voxels(row.around.north), load_voxels(row.around.below), load_voxels(row.voxels)};
}

/// Where north and below agree: the first of the voxels around that differs from them.
HWY_INLINE RowVec first_different(const AroundMasks<RowMask>& masks, const RowsAround& around) {
  RowVec found = load_voxels(around.below_north);
  found = select(masks.level_south, found, load_voxels(around.below_south));
  found = select(masks.west_b, found, load_voxels(around.below - 1));
  found = select(masks.east_b, found, load_voxels(around.below + 1));
  found = select(masks.west_n, found, load_voxels(around.north - 1));
  return select(masks.east_n, found, load_voxels(around.north + 1));
}

/// Of even columns; `same` says where north and below are equal.
HWY_INLINE RowVec second_of_even(const RowNeighbours& row, const RowsAround& around, RowMask same) {
  return select(same, first_different(row.masks, around), select(row.masks.level, row.below, row.north));
}

/// Of odd columns of row `i`, whose west and east are given.
HWY_INLINE RowVec second_of_odd(const RowNeighbours& row, const RowsAround& around,
                                const BesideArrays& beside, std::size_t i, const RowVec& west,
                                const RowVec& east) {
  // Where west and east are equal: base, unless that is the west; then the other.
  const RowVec of_equal = select(row.masks.level ^ beside.base_west[i], row.north, row.below);
  return select(beside.agrees[i], first_different(row.masks, around),
                select(beside.equal[i], of_equal, select(beside.is_east[i], west, east)));
}

/// The first of the voxels around that is neither of two candidates; `exists` says where there is one.
HWY_INLINE RowVec third_candidate(const RowVec& first, const RowVec& second, RowMask level,
                                  const RowsAround& around, RowMask& exists) {
  const RowVec north = load_voxels(around.north);
  const RowVec below = load_voxels(around.below);
  RowVec found = load_voxels(around.below_north);
  exists = ~(equal(found, first) | equal(found, second));
  const auto prefer = [&](const RowVec& candidate, RowMask where) HWY_ATTR {
    const RowMask differs = where & ~(equal(candidate, first) | equal(candidate, second));
    found = select(differs, candidate, found);
    exists |= differs;
  };
  constexpr RowMask kHasWest = ~RowMask{1};
  constexpr RowMask kHasEast = kAllColumns >> 1U;
  prefer(load_voxels(around.below_south), kAllColumns);
  prefer(load_voxels(around.below - 1), kHasWest);
  prefer(load_voxels(around.below + 1), kHasEast);
  prefer(load_voxels(around.north - 1), kHasWest);
  prefer(load_voxels(around.north + 1), kHasEast);
  prefer(select(level, below, north), kAllColumns);
  prefer(select(level, north, below), kAllColumns);
  return found;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
