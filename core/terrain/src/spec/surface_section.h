// [surface] of a world.toml. Private to core/terrain.
#pragma once

#include <vector>

#include <talus/terrain/world.h>
#include <talus/terrain/world_files.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// Reads and checks spec.surface; spec.resolution has been read. `fields`: those that regions may name. A key
/// that its kind of surface has no use for is unknown, as any other.
void read_surface(TableReader root, TableReader surface, const std::vector<FieldSpec>& fields,
                  WorldSpec& spec);

/// Fetches the height map of a surface that has one and was read without a fault.
void load_height_map(TableReader surface, WorldSpec& spec, const LoadHeightMap& load);

}  // namespace talus::terrain
