// [[field]] and the tables of [surface] of a world of regions. Private to core/terrain.
#pragma once

#include <talus/terrain/world.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// The keys and tables of [surface] that a world of regions may have beside `kind`. Each may be left out.
[[nodiscard]] const std::vector<std::string_view>& region_tables();

/// Reads all but the sea's level; `resolution` has been read.
[[nodiscard]] RegionsSpec read_regions(TableReader& root, TableReader& surface, int resolution);

/// Once the sea's level is known: refuses land that is too high, and a level that coarse chunks cannot have.
void check_regions(TableReader& root, TableReader& surface, WorldSpec& world);

}  // namespace talus::terrain
