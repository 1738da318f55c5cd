// [[stratified]] and [[eroded]] of a world.toml. Private to core/terrain.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/places_section.h"
#include "spec/table_reader.h"

namespace talus::terrain {

/// Both read their tables in order and add each material's name to `names`.
/// Strata that `repeat` lie in their order, without depths, and one at least is a band.
[[nodiscard]] std::vector<StratifiedSpec> read_stratified(std::vector<TableReader>& tables, bool repeat,
                                                          std::set<std::string>& names);
/// spec.resolution and spec.method have been read: the slope method bounds the halo that a material needs.
[[nodiscard]] std::vector<ErodedSpec> read_eroded(std::vector<TableReader>& tables, const WorldSpec& spec,
                                                  PlacesReader& places, std::set<std::string>& names);

/// [talus]; `eroded` have been read.
[[nodiscard]] TalusSpec read_talus(TableReader& table, const WorldSpec& spec);

/// An eroded material in integers. `material` stays 0.
[[nodiscard]] LooseSpec loose_of(const ErodedSpec& eroded, int resolution);

}  // namespace talus::terrain
