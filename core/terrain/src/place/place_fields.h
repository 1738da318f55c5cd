// Looks and shares of the columns of a region, row by row.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/vectors/aligned.h>

#include "kernels/places.h"
#include "place/narrowed_cases.h"
#include "place/places.h"
#include "surface/ground_tiles.h"

namespace talus::terrain {

/// Reuses its memory from region to region; not thread-safe.
class PlaceFields {
 public:
  /// `at_points`: by share, true if only share_at() reads it; empty means false for all. Such a share has no
  /// field when tiles are taken.
  PlaceFields(std::shared_ptr<const Places> places, std::int32_t sea_fx, float subvoxels_a_unit,
              InstructionSet set, std::vector<bool> at_points = {});

  /// `from_tiles`: true if the region is filled by take(), not by set_row().
  void start(int width, int depth, bool from_tiles = false);
  /// Sets row z of the region from a row of each quantity, in which columns first, first + step, ... are the
  /// region's. If a surface has no quantities they are null, and height is computed from `heights_fx`, a row
  /// of only the region's columns.
  void set_row(int z, std::span<const float* const> quantities, std::size_t first, std::size_t step,
               std::span<const std::int32_t> heights_fx);
  /// Fills a tile of ground whose corner is column (x, z). All of it must lie inside the region.
  void fill(int x, int z, GroundTile& tile) const;
  /// Takes the columns of a tile, which may extend past the region. Tiles replace set_row() for all columns.
  void take(int x, int z, const GroundTilePtr& tile);
  /// Applies the ramps of slope, and of cliff (0 to kWholeShare) unless null, after all rows or tiles are
  /// set. Both must live as long as share_at() is called.
  void thin_late(const Field& slope, const Field* cliff);

  [[nodiscard]] const std::vector<LookField>& looks() const { return looks_; }
  /// 0 to kWholeShare. Empty if 0 in the whole region. REQUIRES !at_points[i] for share i.
  [[nodiscard]] const std::vector<Field>& shares() const { return shares_; }
  /// Returns true if share i is known to be kWholeShare along row z. Valid for shares() after thin_late().
  [[nodiscard]] bool is_whole(std::size_t i, int z) const {
    return any_[i][static_cast<std::size_t>(z)] == Any::whole;
  }
  /// Returns true if share i is known to be 0 along row z. Valid after thin_late().
  [[nodiscard]] bool is_none(std::size_t i, int z) const {
    return !is_at_points(i) && any_[i][static_cast<std::size_t>(z)] == Any::none;
  }
  /// Returns true if share i may be more than 0 somewhere.
  [[nodiscard]] bool has_share(std::size_t i) const;
  /// Share i at column (x, z) of the region. REQUIRES has_share(i), after thin_late().
  [[nodiscard]] std::int32_t share_at(std::size_t i, int x, int z) const {
    return is_at_points(i) ? share_at_point(i, x, z) : shares_[i].at(x, z);
  }

 private:
  /// A row's values of a share: all 0, all kWholeShare, or any.
  enum class Any : std::uint8_t { none, whole, some };
  static constexpr std::int16_t kSeveral = -1;

  [[nodiscard]] Field& share_to_set(std::size_t i);
  [[nodiscard]] bool is_at_points(std::size_t i) const {
    return from_tiles_ && !at_points_.empty() && at_points_[i];
  }
  void take_at_points(int x, int z, const GroundTilePtr& tile);
  [[nodiscard]] std::int32_t share_at_point(std::size_t i, int x, int z) const;
  [[nodiscard]] std::int32_t early_share_at(std::size_t i, int x, int z) const;
  void set_looks(int z, std::size_t width);
  void set_share(std::size_t i, int z, std::size_t width, std::uint64_t present);

  std::shared_ptr<const Places> places_;
  const PlaceKernels& kernels_;
  std::int32_t sea_fx_;
  float units_a_subvoxel_;
  int width_ = 0;
  int depth_ = 0;
  std::vector<QuantityNumber> asked_;    // quantities used by looks and early ramps
  std::vector<ValueRange> ranges_;       // in the current row, by quantity
  bool late_ = false;                    // true if any share has ramps of slope or cliff
  std::vector<NarrowedCases> narrowed_;  // by looks
  std::vector<LookField> looks_;
  std::vector<Field> shares_;
  std::vector<Field> spare_;  // memory of empty shares
  std::vector<std::vector<Any>> any_;
  std::vector<std::vector<int>> whole_;          // columns of a row in tiles that are kWholeShare throughout
  std::vector<std::vector<std::int16_t>> only_;  // by row: the look of all its columns, or kSeveral
  std::vector<bool> at_points_;
  bool from_tiles_ = false;
  int tile_x_ = 0;  // columns and rows from a tile's border to the region's corner
  int tile_z_ = 0;
  int tiles_a_row_ = 0;               // 0: no tile is taken yet
  std::vector<GroundTilePtr> tiles_;  // taken tiles, row by row, if shares are read at points
  std::vector<std::uint8_t> some_;    // by share read at points: 1 if a tile has some of it
  const Field* slope_ = nullptr;
  const Field* cliff_ = nullptr;
  std::vector<AlignedVector<float>> gathered_;
  std::vector<const float*> rows_;
  AlignedVector<std::int32_t> whole_share_;  // a row of kWholeShare
  std::array<AlignedVector<std::int32_t>, 2> thinned_;
  std::vector<const Places::Ramp*> thinning_;  // ramps of a share that are below 1 somewhere in a row
};

}  // namespace talus::terrain
