// [[field]] and the tables of [surface] of a world of regions. Private to core/terrain.
#pragma once

#include <string_view>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// The keys and tables of [surface] that a world of regions may have beside `kind`. Each may be left out.
[[nodiscard]] const std::vector<std::string_view>& region_tables();

/// All [[field]] of the file.
[[nodiscard]] std::vector<FieldSpec> read_fields(TableReader& root, int resolution);
/// Those, and the shipped ones that the file does not give anew.
[[nodiscard]] std::vector<FieldSpec> known_fields(std::vector<FieldSpec> fields);

/// Reads all but the sea's level; `resolution` has been read.
[[nodiscard]] RegionsSpec read_regions(const std::vector<FieldSpec>& fields, TableReader& surface,
                                       int resolution, PlacesSpec& places);

/// Once the sea's level is known: refuses land that is too high, and a level that coarse chunks cannot have.
void check_regions(TableReader& root, TableReader& surface, WorldSpec& world);

}  // namespace talus::terrain
