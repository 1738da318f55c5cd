// [[placeable]] of a world.toml. Private to core/terrain.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// Reads the tables in order, one material for each state, and adds each material's name to `names`.
[[nodiscard]] std::vector<Placeable> read_placeables(std::vector<TableReader>& tables,
                                                     std::set<std::string>& names);

}  // namespace talus::terrain
