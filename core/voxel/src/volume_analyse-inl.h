// Computes what an encoder writes of a chunk's voxels: FORMAT.md, "Volume".
// Included once per instruction set, hence this guard:
#if defined(TALUS_VOLUME_ANALYSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_ANALYSE_INL
#undef TALUS_VOLUME_ANALYSE_INL
#else
#define TALUS_VOLUME_ANALYSE_INL
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "volume_batch-inl.h"
#include "volume_bits-inl.h"
#include "volume_candidates-inl.h"
#include "volume_kernels.h"
#include "volume_numbers-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// Finds contexts, symbols and exceptions of a chunk, wave by wave. All voxels are known, so even and odd
/// columns are processed together and without unpredictable branches; work that few voxels need comes
/// afterwards.
class VolumeAnalyser {
 public:
  VolumeAnalyser(const DenseVoxels& voxels, VolumeEvents& events) : voxels_{voxels.data()}, events_{events} {
    events_.coded = events_.surprises = events_.changes = events_.exceptions = events_.escapes = 0;
  }

  /// Replaces materials by one-byte numbers; returns false if there are too many.
  bool number(const DenseVoxels& voxels) {
    if (!number_voxels(voxels, vbmi_, rows_)) return false;
    // North of the first row counts as the first material.
    std::memset(rows_.of(-1), *rows_.of(0), kRowBytes);
    return true;
  }

  bool analyse() {
    for (int wave = 0; wave < kWaves; ++wave) {
      const WaveSpan span{wave};
      add_missing_rows(wave);
      // If nothing differs in this wave and the previous two, every voxel is steady and as predicted.
      const bool was_quiet = quiet_ && quiet_before_;
      quiet_before_ = quiet_;
      quiet_ = compare_near(span, wave);
      if (was_quiet && quiet_) {
        add_steady_wave(span, static_cast<std::size_t>(wave));
      } else {
        compare_around(span, wave);
        find_symbols(span, wave);
        over_bits(high_pairs_, [&](std::size_t pair) HWY_ATTR { find_escapes(span, pair, wave); });
        add_wave(span, static_cast<std::size_t>(wave));
      }
      if (is_noise(2 * static_cast<std::size_t>(wave) + 2, events_)) return false;
    }
    return true;
  }

 private:
  /// Fills in missing neighbours of a wave's rows, as rows_around() defines.
  HWY_INLINE void add_missing_rows(int wave) {
    const auto copy = [](const std::uint8_t* from, std::uint8_t* to)
                          HWY_ATTR { std::memcpy(to, from, kRowBytes); };
    if (const int last = wave - 1; last >= 0) {
      // For the voxels around, missing voxels count as equal.
      if (last < kChunkSize) *near_.below.of(last) = ~std::uint32_t{0};
      if (last % 2 == 0 && last / 2 < kChunkSize) near_.north.of(last)[last / 2] = ~std::uint32_t{0};
    }
    if (wave < kChunkSize) {
      // Row y = 0: all other rows are north.
      const std::uint8_t* const north = rows_.of(wave - 1);
      copy(north, rows_.of(wave - 2) - kRowBytes);
      copy(north, rows_.of(wave - 3) - kRowBytes);
      copy(north, rows_.of(wave - 1) - kRowBytes);
      *(near_.west.of(wave - 2) - 1) = *near_.west.of(wave - 1);
    } else if (wave % 2 != 0) {
      // z = 31: below south is below.
      const auto y = static_cast<std::size_t>(first_row_of(wave)) - 1;
      copy(rows_.of(wave - 2) + y * kRowBytes, rows_.of(wave - 1) + y * kRowBytes);
      near_.north.of(wave - 1)[y] = ~std::uint32_t{0};
    }
    if (wave != 0 && wave % 2 == 0 && wave / 2 < kChunkSize) {
      // z = 0: north and below north are below.
      const auto y = static_cast<std::size_t>(wave / 2);
      const std::uint8_t* const below = rows_.of(wave - 2) + (y - 1) * kRowBytes;
      copy(below, rows_.of(wave - 1) + y * kRowBytes);
      copy(below, rows_.of(wave - 3) + (y - 1) * kRowBytes);
      near_.west.of(wave - 1)[y] = near_.west.of(wave - 2)[y - 1];
      near_.below.of(wave - 1)[y] = ~std::uint32_t{0};
    }
  }

  /// Compares the voxels of a wave with the voxels below, to the north and to the west. Returns true if all
  /// are equal to all three.
  HWY_INLINE bool compare_near(const WaveSpan& span, int wave) {
    const std::uint8_t* const bytes = rows_.of(wave) + span.first * kRowBytes;
    const std::uint8_t* const north = rows_.of(wave - 1) + span.first * kRowBytes;
    const std::uint8_t* const below = rows_.of(wave - 2) + span.first * kRowBytes - kRowBytes;
    std::uint32_t* const of_below = near_.below.of(wave) + span.first;
    std::uint32_t* const of_north = near_.north.of(wave) + span.first;
    std::uint32_t* const of_west = near_.west.of(wave) + span.first;
    std::uint64_t all = ~std::uint64_t{0};
    for (std::size_t pair = 0; pair < span.pairs(); ++pair) {
      const std::size_t at = pair * kPairBytes;
      const RowPair now = load_pair(bytes + at);
      const std::uint64_t is_below = equal_bits(now, load_pair(below + at));
      const std::uint64_t is_north = equal_bits(now, load_pair(north + at));
      // The voxel outside the first column counts as equal.
      const std::uint64_t is_west = equal_bits(now, load_pair(bytes + at - 1)) | 0x100000001U;
      store_bits(is_below, of_below + 2 * pair);
      store_bits(is_north, of_north + 2 * pair);
      store_bits(is_west, of_west + 2 * pair);
      events_.changes += static_cast<std::size_t>(std::popcount(~is_west & span.inside(pair)));
      all &= (is_below & is_north & is_west) | ~span.inside(pair);
    }
    return all == ~std::uint64_t{0};
  }

  HWY_INLINE void compare_around(const WaveSpan& span, int wave) {
    const std::size_t first = span.first * kRowBytes;
    const std::uint8_t* const now_row = rows_.of(wave) + first;
    const std::uint8_t* const north_row = rows_.of(wave - 1) + first;
    const std::uint8_t* const below_row = rows_.of(wave - 2) + first - kRowBytes;
    const std::uint8_t* const below_north_row = rows_.of(wave - 3) + first - kRowBytes;
    const std::uint8_t* const below_south_row = north_row - kRowBytes;
    for (std::size_t pair = 0; pair < span.pairs(); ++pair) {
      const std::size_t at = pair * kPairBytes;
      const auto put = [pair](RowWords& words, const RowPair& a, const RowPair& b)
                           HWY_ATTR { store_bits(equal_bits(a, b), words.data() + 2 * pair); };
      const RowPair now = load_pair(now_row + at);
      const RowPair north = load_pair(north_row + at);
      const RowPair below = load_pair(below_row + at);
      const RowPair south = load_pair(below_south_row + at);
      put(equals_.north_below, north, below);
      put(equals_.north_south_below, north, south);
      put(equals_.now_south_below, now, south);
      put(equals_.now_below_north, now, load_pair(below_north_row + at));
      const RowPair west = load_pair(now_row + at - 1);
      put(equals_.north_west, north, west);
      put(equals_.below_west, below, west);
      const RowPair east = load_pair(now_row + at + 1);
      put(equals_.north_east, north, east);
      put(equals_.below_east, below, east);
      put(equals_.west_east, west, east);
    }
  }

  /// Finds contexts, symbols and exceptions of a wave. Symbol 3 is still reported as 2.
  HWY_INLINE void find_symbols(const WaveSpan& span, int wave) {
    const RowBits d;
    for (std::size_t row = 0; row < span.rows; row += kRowLanes) {
      const NearVec near{near_, span.first + row, wave};
      const auto words = [row](const RowWords& of) HWY_ATTR { return load_rows(of.data() + row); };
      const auto put = [row, d](RowVec bits, RowWords& to) HWY_ATTR { hn::StoreU(bits, d, to.data() + row); };
      // The voxel east of the last column is the one to its west.
      const RowVec last = row_bits(0x80000000U);
      const RowVec same = words(equals_.north_below);
      const RowVec equal = hn::Or(words(equals_.west_east), last);
      const RowVec north_west = words(equals_.north_west);
      const RowVec north_east = pick_bits(last, north_west, words(equals_.north_east));
      const RowVec below_west = words(equals_.below_west);
      const RowVec below_east = pick_bits(last, below_west, words(equals_.below_east));
      const RowVec equals_east =
          hn::BitCast(d, hn::ShiftRight<1>(hn::BitCast(hn::RebindToSigned<RowBits>{}, near.equals_west)));

      const RowVec base_west = pick_bits(near.level, north_west, below_west);
      const RowVec other_west = pick_bits(near.level, below_west, north_west);
      const RowVec base_east = pick_bits(near.level, north_east, below_east);
      const RowVec other_east = pick_bits(near.level, below_east, north_east);
      const RowVec is_east = hn::Or(base_east, hn::AndNot(base_west, other_east));
      const RowVec base_first = hn::Or(base_west, base_east);
      const RowVec other_first = pick_bits(is_east, other_east, other_west);
      const RowVec other_second = pick_bits(is_east, other_west, other_east);
      const RowVec alike = pick_odd(hn::And(equal, hn::And(base_first, other_first)), same);
      const RowVec steady = hn::And(alike, near.around());

      const RowVec is_base = pick_bits(near.level, near.equals_north, near.equals_below);
      const RowVec is_other = pick_bits(near.level, near.equals_below, near.equals_north);
      const RowVec first = pick_odd(pick_bits(is_east, equals_east, near.equals_west), is_base);
      RowVec different = words(equals_.now_below_north);
      different = pick_bits(near.level_south, different, words(equals_.now_south_below));
      // If a voxel equals the one west of north, that one equals the one to its east, and so on.
      different = pick_bits(near.below_west, different, hn::ShiftLeft<1>(words(equals_.below_east)));
      different = pick_bits(near.below_east, different, hn::ShiftRight<1>(words(equals_.below_west)));
      different = pick_bits(near.north_west, different, hn::ShiftLeft<1>(words(equals_.north_east)));
      different = pick_bits(near.north_east, different, hn::ShiftRight<1>(words(equals_.north_west)));
      const RowVec second = pick_bits(alike, different,
                                      pick_odd(pick_bits(equal, pick_bits(base_west, is_other, is_base),
                                                         pick_bits(is_east, near.equals_west, equals_east)),
                                               is_other));

      const RowVec inside = hn::VecFromMask(d, hn::FirstN(d, span.rows - row));
      const RowVec differs = hn::AndNot(first, inside);
      const RowVec exceptional = hn::And(differs, steady);
      const RowVec surprising = hn::AndNot(steady, differs);
      const RowVec high = hn::AndNot(second, surprising);
      put(hn::AndNot(steady, inside), bits_.coded);
      put(exceptional, exceptional_);
      put(hn::Xor(surprising, high), bits_.symbol[0]);
      put(high, bits_.symbol[1]);

      put(pick_bits(alike, near.upright, pick_odd(base_first, near.level)), bits_.context[0]);
      put(pick_bits(alike, near.level_south, pick_odd(other_first, near.upright)), bits_.context[1]);
      put(pick_bits(alike, near.north_west, pick_odd(hn::And(equal, same), near.level_south)),
          bits_.context[2]);
      put(pick_bits(alike, near.north_east,
                    pick_odd(pick_bits(equal, near.upright, other_second), words(equals_.north_south_below))),
          bits_.context[3]);
      put(pick_bits(alike, near.below_west,
                    pick_odd(pick_bits(equal, near.level, near.upright),
                             hn::And(near.north_west, near.north_east))),
          bits_.context[4]);
      put(pick_bits(alike, near.below_east,
                    pick_odd(pick_bits(equal, near.level_south, near.level),
                             hn::And(near.below_west, near.below_east))),
          bits_.context[5]);
      put(hn::AndNot(alike, hn::Or(row_bits(0x55555555U), hn::Or(equal, near.level_south))),
          bits_.context[6]);
      put(hn::AndNot(equal, row_bits(0xAAAAAAAAU)), bits_.context[7]);

      put(near.level, choice_.level);
      put(is_east, choice_.is_east);
      put(equal, choice_.equal);
      put(base_west, choice_.base_west);
      put(alike, choice_.alike);
    }
    if (wave < static_cast<int>(kProbeWaves)) {
      for (std::size_t pair = 0; pair < span.pairs(); ++pair) {
        events_.surprises += static_cast<std::size_t>(std::popcount(
            load_bits(bits_.symbol[0].data() + 2 * pair) | load_bits(bits_.symbol[1].data() + 2 * pair)));
      }
    }
    any_exceptional_ = any_escapes_ = 0;
    high_pairs_ = 0;
    for (std::size_t pair = 0; pair < span.pairs(); ++pair) {
      high_pairs_ |= std::uint32_t{load_bits(bits_.symbol[1].data() + 2 * pair) != 0 ? 1U : 0U} << pair;
      any_exceptional_ |= load_bits(exceptional_.data() + 2 * pair);
    }
  }

  /// Finds the voxels of a pair of rows that equal no candidate, among voxels marked as neither the first nor
  /// the second.
  HWY_INLINE void find_escapes(const WaveSpan& span, std::size_t pair, int wave) {
    const std::uint64_t high = load_bits(bits_.symbol[1].data() + 2 * pair);
    std::uint64_t escapes = 0;
    for (std::size_t p = 0; p < kPairParts; ++p) {
      const auto where = [&](const RowWords& words)
                             HWY_ATTR { return part_mask(words, pair * kPairParts + p); };
      const std::size_t at = (span.first + 2 * pair) * kRowBytes + p * kPartBytes;
      const std::uint8_t* const bytes = rows_.of(wave) + at;
      const RowsNear rows{rows_.of(wave - 1), rows_.of(wave - 2) - kRowBytes, rows_.of(wave - 3) - kRowBytes,
                          rows_.of(wave - 1) - kRowBytes};
      const PartVec now = load(bytes);
      const PartVec north = load(rows.north + at);
      const PartVec below = load(rows.below + at);
      const PartVec west = load(bytes - 1);
      const PartVec east = hn::IfThenElse(columns<IsLastColumn>(p), west, load(bytes + 1));
      const PartMask level = where(choice_.level);
      const PartMask is_east = where(choice_.is_east);
      CandidatesNear near;
      near.at = at;
      near.base = hn::IfThenElse(level, north, below);
      near.other = hn::IfThenElse(level, below, north);
      // As for contexts, if the surroundings are these.
      const auto unless = [&](const RowWords& alike, PartVec yes, PartVec no)
                              HWY_ATTR { return hn::IfThenElse(where(alike), yes, no); };
      PartVec different = load(rows.below_north + at);
      different = unless(bits_.context[1], different, load(rows.below_south + at));
      different = unless(bits_.context[4], different, load(rows.below + at - 1));
      different = unless(bits_.context[5], different, load(rows.below + at + 1));
      different = unless(bits_.context[2], different, load(rows.north + at - 1));
      different = unless(bits_.context[3], different, load(rows.north + at + 1));
      const PartMask odd = columns<IsOddColumn>(p);
      const PartVec first = hn::IfThenElse(odd, hn::IfThenElse(is_east, east, west), near.base);
      const PartVec second_odd = hn::IfThenElse(
          where(choice_.equal), hn::IfThenElse(where(choice_.base_west), near.other, near.base),
          hn::IfThenElse(is_east, west, east));
      const PartVec second =
          hn::IfThenElse(where(choice_.alike), different, hn::IfThenElse(odd, second_odd, near.other));
      PartMask exists;
      const PartVec candidate = third_candidate(rows, near, first, second, p, exists);
      const PartBits found = bits_of(hn::And(exists, hn::Eq(now, candidate)));
      escapes |= std::uint64_t{static_cast<PartBits>(~found & kAllBits)} << (p * kPartBytes);
    }
    escapes &= high;
    any_escapes_ |= escapes;
    std::uint32_t* const low = bits_.symbol[0].data() + 2 * pair;
    store_bits(load_bits(low) | escapes, low);
  }

  HWY_INLINE void add_wave(const WaveSpan& span, std::size_t wave) {
    const CodedHalves sizes = pack_wave(bits_, span.pairs(), vbmi_, events_.context.data() + events_.coded,
                                        events_.symbol.data() + events_.coded);
    add_half(span, 2 * wave, sizes.even, kEvenWords);
    add_half(span, 2 * wave + 1, sizes.odd, kOddWords);
  }

  HWY_INLINE void add_steady_wave(const WaveSpan& span, std::size_t wave) {
    gap_ += static_cast<std::uint32_t>(span.rows * kChunkSize);
    for (const std::size_t batch : {2 * wave, 2 * wave + 1}) {
      events_.batch[batch] = 0;
      events_.batch_escapes[batch] = 0;
    }
  }

  /// Adds exceptions and escapes of a wave's even or odd columns, as a batch of `size` coded voxels.
  HWY_INLINE void add_half(const WaveSpan& span, std::size_t batch, std::size_t size, std::uint64_t columns) {
    if (HWY_LIKELY((any_exceptional_ & columns) == 0)) {
      gap_ += static_cast<std::uint32_t>(span.rows * kChunkSize / 2 - size);
    } else {
      add_exceptions(span, columns, batch);
    }
    const std::size_t escapes = events_.escapes;
    if ((any_escapes_ & columns) != 0) {
      for (std::size_t pair = 0; pair < span.pairs(); ++pair) {
        const std::uint64_t which =
            load_bits(bits_.symbol[0].data() + 2 * pair) & load_bits(bits_.symbol[1].data() + 2 * pair);
        over_bits(which & columns, [&](std::size_t voxel) HWY_ATTR {
          events_.escape[events_.escapes++] = material(span, pair, voxel, batch / 2);
        });
      }
    }
    events_.coded += size;
    events_.batch[batch] = static_cast<std::uint16_t>(size);
    events_.batch_escapes[batch] = static_cast<std::uint16_t>(events_.escapes - escapes);
  }

  /// The material of a voxel of a pair of rows.
  [[nodiscard]] MaterialId material(const WaveSpan& span, std::size_t pair, std::size_t voxel,
                                    std::size_t wave) const {
    const std::size_t y = span.first + 2 * pair + voxel / kRowBytes;
    return voxels_[(y * (kChunkSize - 2) + wave) * kChunkSize + voxel % kRowBytes];
  }

  HWY_INLINE void add_exceptions(const WaveSpan& span, std::uint64_t columns, std::size_t batch) {
    for (std::size_t pair = 0; pair < span.pairs(); ++pair) {
      const std::uint64_t steady = columns & span.inside(pair) & ~load_bits(bits_.coded.data() + 2 * pair);
      std::uint32_t passed = 0;
      over_bits(load_bits(exceptional_.data() + 2 * pair) & columns, [&](std::size_t x) HWY_ATTR {
        const auto before = static_cast<std::uint32_t>(std::popcount(steady & ((std::uint64_t{1} << x) - 1)));
        events_.exception[events_.exceptions++] = {static_cast<std::uint16_t>(gap_ + before - passed),
                                                   static_cast<std::uint16_t>(batch),
                                                   material(span, pair, x, batch / 2)};
        gap_ = 0;
        passed = before + 1;
      });
      gap_ += static_cast<std::uint32_t>(std::popcount(steady)) - passed;
    }
  }

  static constexpr std::uint64_t kEvenWords = 0x5555555555555555U;
  static constexpr std::uint64_t kOddWords = ~kEvenWords;

  const MaterialId* voxels_;
  VolumeEvents& events_;
  const VolumeVbmi* const vbmi_ = volume_vbmi();
  VoxelRows rows_;
  NearEquals near_;
  // State of one wave:
  WaveEquals equals_;
  WaveChoice choice_;
  WaveBits bits_;
  alignas(64) RowWords exceptional_;  // steady voxels that are not the first candidate
  std::uint32_t high_pairs_ = 0;      // pairs with voxels beyond the first two candidates
  // State of all pairs together:
  std::uint64_t any_escapes_ = 0;
  std::uint64_t any_exceptional_ = 0;
  std::uint32_t gap_ = 0;
  bool quiet_ = false;  // true if all voxels of the last wave equal their neighbours
  bool quiet_before_ = false;
};

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
