// [[stratified]], [[eroded]], [talus] and [[placeable]] of a world.toml. Private to core/terrain.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/places_section.h"
#include "spec/table_reader.h"

namespace talus::terrain {

/// Both read their tables in order and add each material's name to `names`. Strata with `repeat` lie in their
/// order, have no depths, and at least one is a band.
[[nodiscard]] std::vector<StratifiedSpec> read_stratified(std::vector<TableReader>& tables, bool repeat,
                                                          std::set<std::string>& names);
/// REQUIRES that spec.resolution and spec.method are read: the slope method bounds halos.
[[nodiscard]] std::vector<ErodedSpec> read_eroded(std::vector<TableReader>& tables, const WorldSpec& spec,
                                                  PlacesReader& places, std::set<std::string>& names);

/// Reads [talus]. REQUIRES that spec.eroded is read.
[[nodiscard]] TalusSpec read_talus(TableReader& table, const WorldSpec& spec);

/// Reads [[placeable]] in order, one material for each state, and adds each material's name to `names`.
[[nodiscard]] std::vector<Placeable> read_placeables(std::vector<TableReader>& tables,
                                                     std::set<std::string>& names);

/// Converts an eroded material to integers. `material` stays 0.
[[nodiscard]] LooseSpec loose_of(const ErodedSpec& eroded, int resolution);

}  // namespace talus::terrain
