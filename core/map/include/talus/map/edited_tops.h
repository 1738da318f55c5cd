// Columns that edits have changed as seen from above.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

namespace talus::map {

/// An edited column as seen from above. Coordinates and rows are in the level's voxels.
struct EditedTop {
  std::int64_t x = 0;
  std::int64_t z = 0;
  MaterialId material{};       // the topmost voxel that is neither air nor water
  std::int32_t row = 0;        // the row above it
  MaterialId water = kAir;     // the water above it; kAir: no water
  std::int32_t water_row = 0;  // the row above the water
};

/// Thread-safe.
class EditedTops {
 public:
  virtual ~EditedTops() = default;
  /// Materials that tops may have in addition to the world's.
  [[nodiscard]] virtual const std::vector<terrain::Material>& materials() const = 0;
  /// Columns of the region that edits changed, as seen from above.
  [[nodiscard]] virtual std::vector<EditedTop> find(const terrain::Region& region) const = 0;
};

}  // namespace talus::map
