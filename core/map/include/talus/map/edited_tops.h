// Columns that look otherwise from above than they were generated. Pure.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

namespace talus::map {

/// A column as it is seen. Rows are those of the level.
struct EditedTop {
  std::int64_t x = 0;  // of the level
  std::int64_t z = 0;
  MaterialId material{};       // of the topmost voxel that is neither air nor water
  std::int32_t row = 0;        // the row over it
  MaterialId water = kAir;     // over it; kAir: none
  std::int32_t water_row = 0;  // the row over that
};

/// Any number of threads may ask.
class EditedTops {
 public:
  virtual ~EditedTops() = default;
  /// What they are of, beyond the world's materials.
  [[nodiscard]] virtual const std::vector<terrain::Material>& materials() const = 0;
  /// Columns of the region that edits changed, as seen from above.
  [[nodiscard]] virtual std::vector<EditedTop> find(const terrain::Region& region) const = 0;
};

}  // namespace talus::map
