// Candidates of a part's voxels after the first: FORMAT.md, "Volume: prediction".
// Included once per instruction set, hence this guard:
#if defined(TALUS_VOLUME_CANDIDATES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_CANDIDATES_INL
#undef TALUS_VOLUME_CANDIDATES_INL
#else
#define TALUS_VOLUME_CANDIDATES_INL
#endif

#include <hwy/highway.h>

#include "volume_near-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// If north and below agree: the first voxel around that differs from them.
HWY_INLINE PartVec first_different(const NearRows& rows, const NearPart& near) {
  const auto unless = [&](std::uint8_t bit, PartVec yes, PartVec no) HWY_ATTR {
    return hn::IfThenElse(hn::TestBit(near.around, bytes_of(bit)), yes, no);
  };
  PartVec found = load(rows.below_north + near.at);
  found = unless(2, found, load(rows.below_south + near.at));
  found = unless(16, found, load(rows.below + near.at - 1));
  found = unless(32, found, load(rows.below + near.at + 1));
  found = unless(4, found, load(rows.north + near.at - 1));
  return unless(8, found, load(rows.north + near.at + 1));
}

/// The parts of NearRows and NearPart that third_candidate() needs.
struct RowsNear {
  const std::uint8_t* north;
  const std::uint8_t* below;
  const std::uint8_t* below_north;
  const std::uint8_t* below_south;
};
struct CandidatesNear {
  std::size_t at;
  PartVec base;
  PartVec other;
};

/// The first voxel around that is neither of two candidates; `exists` is set if there is one.
template <class Rows, class Near>
HWY_INLINE PartVec third_candidate(const Rows& rows, const Near& near, PartVec first, PartVec second,
                                   std::size_t part, PartMask& exists) {
  const auto is_new = [&](PartVec candidate) HWY_ATTR {
#if HWY_TARGET == HWY_AVX3
    // Combining two comparisons into one is faster.
    const PartVec differs = hn::Min(hn::Xor(candidate, first), hn::Xor(candidate, second));
    return PartMask{_mm512_test_epi8_mask(differs.raw, differs.raw)};
#else
    return hn::Not(hn::Or(hn::Eq(candidate, first), hn::Eq(candidate, second)));
#endif
  };
  PartVec found = load(rows.below_north + near.at);
  exists = is_new(found);
  const auto prefer = [&](PartVec candidate, PartMask where) HWY_ATTR {
    found = hn::IfThenElse(where, candidate, found);
    exists = hn::Or(exists, where);
  };
  const PartMask no_west = columns<IsFirstColumn>(part);
  const PartMask no_east = columns<IsLastColumn>(part);
  const auto prefer_beside = [&](const std::uint8_t* row) HWY_ATTR {
    const PartVec west = load(row + near.at - 1);
    prefer(west, hn::AndNot(no_west, is_new(west)));
    const PartVec east = load(row + near.at + 1);
    prefer(east, hn::AndNot(no_east, is_new(east)));
  };
  const PartVec south = load(rows.below_south + near.at);
  prefer(south, is_new(south));
  prefer_beside(rows.below);
  prefer_beside(rows.north);
  prefer(near.other, is_new(near.other));
  prefer(near.base, is_new(near.base));
  return found;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
