// Looks and shares of the columns of a region, row after row.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/vectors/aligned.h>

#include "kernels/places.h"
#include "place/narrowed_cases.h"
#include "place/places.h"

namespace talus::terrain {

struct GroundTile;

/// Keeps its memory from region to region. For one thread at a time.
class PlaceFields {
 public:
  PlaceFields(std::shared_ptr<const Places> places, std::int32_t sea_fx, float subvoxels_a_unit,
              InstructionSet set);

  void start(int width, int depth);
  /// Row z of the region: a row of each quantity, of which columns first, first + step, ... are the region's.
  /// A surface that knows no quantities leaves them null; of `heights_fx`, rows of the region's columns
  /// alone, height is made then.
  void set_row(int z, std::span<const float* const> quantities, std::size_t first, std::size_t step,
               std::span<const std::int32_t> heights_fx);
  /// Into a tile of ground whose corner is column (x, z) of the region; all of it lies in the region.
  void fill(int x, int z, GroundTile& tile) const;
  /// From one that may reach out of the region. Instead of rows, for all columns of the region.
  void take(int x, int z, const GroundTile& tile);
  /// Once all rows or tiles are set: ramps of slope, and of cliff, 0 to kWholeShare, where there is any.
  void thin_late(const Field& slope, const Field* cliff);

  [[nodiscard]] const std::vector<LookField>& looks() const { return looks_; }
  /// 0 to kWholeShare. Empty where it is 0 all over the region.
  [[nodiscard]] const std::vector<Field>& shares() const { return shares_; }

 private:
  [[nodiscard]] Field& share_to_set(std::size_t i);
  void set_looks(int z, std::size_t width);
  void set_share(std::size_t i, int z, std::size_t width, std::uint64_t present);

  std::shared_ptr<const Places> places_;
  const PlaceKernels& kernels_;
  std::int32_t sea_fx_;
  float units_a_subvoxel_;
  int width_ = 0;
  int depth_ = 0;
  std::vector<QuantityNumber> asked_;  // that looks and early ramps ask for
  std::vector<ValueRange> ranges_;     // of a row
  bool late_ = false;                  // whether any share has ramps of slope or cliff
  NarrowedCases narrowed_;
  std::vector<LookField> looks_;
  std::vector<Field> shares_;
  std::vector<Field> spare_;                    // the memory of those that are empty
  std::vector<std::vector<std::uint8_t>> any_;  // of a share: 0 where a row is 0 all along
  std::vector<AlignedVector<float>> gathered_;
  std::vector<const float*> rows_;
  AlignedVector<std::int32_t> share_;
  AlignedVector<std::int32_t> thinned_;
};

}  // namespace talus::terrain
