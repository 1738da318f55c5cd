// The voxels of a chunk that are exposed: a face neighbour is not ground. Private to core/terrain.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <talus/voxel/coords.h>

#include "feature.h"

namespace talus::terrain {

/// For each column (column_index): bit y is set if voxel y has a face neighbour above the ground or in a
/// cave.
using ExposedRows = std::array<std::uint32_t, kChunkArea>;

/// nullopt if the chunk has no exposed voxel. A pure function of the ground in the chunk and one column
/// around it. REQUIRES that the site's stacks hold these columns (asserted), and level 0.
[[nodiscard]] std::optional<ExposedRows> exposed_rows(const ChunkSite& site);

}  // namespace talus::terrain
