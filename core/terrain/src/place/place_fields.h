// Looks and shares of the columns of a region, row after row.
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

/// Keeps its memory from region to region. For one thread at a time.
class PlaceFields {
 public:
  /// `at_points`: by share, whether share_at() alone asks for it; none where that is empty. It has no field
  /// where tiles are taken.
  PlaceFields(std::shared_ptr<const Places> places, std::int32_t sea_fx, float subvoxels_a_unit,
              InstructionSet set, std::vector<bool> at_points = {});

  /// `from_tiles`: whether take() sets all of it, and not set_row().
  void start(int width, int depth, bool from_tiles = false);
  /// Row z of the region: a row of each quantity, of which columns first, first + step, ... are the region's.
  /// A surface that knows no quantities leaves them null; of `heights_fx`, rows of the region's columns
  /// alone, height is made then.
  void set_row(int z, std::span<const float* const> quantities, std::size_t first, std::size_t step,
               std::span<const std::int32_t> heights_fx);
  /// Into a tile of ground whose corner is column (x, z) of the region; all of it lies in the region.
  void fill(int x, int z, GroundTile& tile) const;
  /// From one that may reach out of the region. Instead of rows, for all columns of the region.
  void take(int x, int z, const GroundTilePtr& tile);
  /// Once all rows or tiles are set: ramps of slope, and of cliff, 0 to kWholeShare, where there is any. Both
  /// must live as long as share_at() is asked.
  void thin_late(const Field& slope, const Field* cliff);

  [[nodiscard]] const std::vector<LookField>& looks() const { return looks_; }
  /// 0 to kWholeShare. Empty where it is 0 all over the region. REQUIRES that share_at() is not the only one
  /// that asks for it.
  [[nodiscard]] const std::vector<Field>& shares() const { return shares_; }
  /// Whether share i is known to be kWholeShare all along row z. As of shares(), after thin_late().
  [[nodiscard]] bool is_whole(std::size_t i, int z) const {
    return any_[i][static_cast<std::size_t>(z)] == Any::whole;
  }
  /// Whether share i may be more than 0 somewhere.
  [[nodiscard]] bool has_share(std::size_t i) const;
  /// Share i at column (x, z) of the region. REQUIRES has_share(i), after thin_late().
  [[nodiscard]] std::int32_t share_at(std::size_t i, int x, int z) const {
    return is_at_points(i) ? share_at_point(i, x, z) : shares_[i].at(x, z);
  }

 private:
  /// What a row has of a share: 0 all along, kWholeShare all along, or anything.
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
  std::vector<QuantityNumber> asked_;    // that looks and early ramps ask for
  std::vector<ValueRange> ranges_;       // of a row
  bool late_ = false;                    // whether any share has ramps of slope or cliff
  std::vector<NarrowedCases> narrowed_;  // by looks
  std::vector<LookField> looks_;
  std::vector<Field> shares_;
  std::vector<Field> spare_;  // the memory of those that are empty
  std::vector<std::vector<Any>> any_;
  std::vector<std::vector<int>> whole_;          // columns of a row in tiles of which all is kWholeShare
  std::vector<std::vector<std::int16_t>> only_;  // of rows: the look that all of it has, or kSeveral
  std::vector<bool> at_points_;
  bool from_tiles_ = false;
  int tile_x_ = 0;  // columns and rows from a tile's border to the region's corner
  int tile_z_ = 0;
  int tiles_a_row_ = 0;               // 0: none is taken yet
  std::vector<GroundTilePtr> tiles_;  // those taken, row after row of them, where shares at points are
  std::vector<std::uint8_t> some_;    // of a share at points: whether a tile has any
  const Field* slope_ = nullptr;
  const Field* cliff_ = nullptr;
  std::vector<AlignedVector<float>> gathered_;
  std::vector<const float*> rows_;
  AlignedVector<std::int32_t> whole_share_;  // a row of it
  std::array<AlignedVector<std::int32_t>, 2> thinned_;
  std::vector<const Places::Ramp*> thinning_;  // those of a share that leave less than all of a row
};

}  // namespace talus::terrain
