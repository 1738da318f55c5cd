// [[field]] and the tables of [surface] of a world of regions. Private to core/terrain.
#pragma once

#include <string_view>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// Keys and tables of [surface] in a world of regions, in addition to `kind`. All are optional.
[[nodiscard]] const std::vector<std::string_view>& region_tables();

/// Reads all [[field]] of the file.
[[nodiscard]] std::vector<FieldSpec> read_fields(TableReader& root, int resolution);
/// Adds the shipped fields that `fields` does not redefine.
[[nodiscard]] std::vector<FieldSpec> known_fields(std::vector<FieldSpec> fields);

/// Reads everything except the sea's level. REQUIRES that `resolution` is read.
[[nodiscard]] RegionsSpec read_regions(const std::vector<FieldSpec>& fields, TableReader& surface,
                                       int resolution, PlacesSpec& places);

/// Rejects land that is too high, and a sea level that coarse chunks cannot represent. REQUIRES that the
/// sea's level is read.
void check_regions(TableReader& root, TableReader& surface, WorldSpec& world);

}  // namespace talus::terrain
