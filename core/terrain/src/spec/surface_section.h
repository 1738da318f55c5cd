// [surface] of a world.toml. Private to core/terrain.
#pragma once

#include <vector>

#include <talus/terrain/world.h>
#include <talus/terrain/world_files.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// Reads and checks spec.surface. REQUIRES that spec.resolution is read. `fields`: fields that regions may
/// name. A key that does not apply to the kind of surface is reported as unknown.
void read_surface(TableReader root, TableReader surface, const std::vector<FieldSpec>& fields,
                  WorldSpec& spec);

/// Loads the height map of a surface that has one and was read without an error.
void load_height_map(TableReader surface, WorldSpec& spec, const LoadHeightMap& load);

}  // namespace talus::terrain
