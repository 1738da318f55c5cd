// Ore in the voxels of chunks. Private to the room.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/coords.h>

#include "inserts.h"

namespace talus::terrain {

/// The ore of a chunk of a level, to be inserted in this order: in rock alone, which ends below row `rock` of
/// each column; where bodies overlap, the ore that comes first in the spec is what stays. Bodies of one ore
/// that leave each other's columns free share an insert.
[[nodiscard]] std::vector<Insert> ore_inserts(const World& world, ChunkKey key, const ChunkPlane& rock);

/// No ore of a level lies below this row of its voxels; past all rows where there is none.
[[nodiscard]] std::int32_t lowest_ore_row(const World& world, Lod lod);

}  // namespace talus::terrain
