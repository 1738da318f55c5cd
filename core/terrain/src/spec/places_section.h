// [[look]], [[province]] and `where` of a world.toml. Private to core/terrain.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/table_reader.h"

namespace talus::terrain {

/// Reads looks, provinces and shares into a PlacesSpec. REQUIRES that the surface is read.
class PlacesReader {
 public:
  /// `fields`: the file's fields, which conditions and ramps may name; only for a surface of regions.
  PlacesReader(const WorldSpec& world, std::vector<FieldSpec> fields, PlacesSpec& places);

  /// Reads `where` of a table as a share; nullopt if it is omitted.
  [[nodiscard]] std::optional<std::size_t> share(TableReader& table);
  /// Also reads `looks`, names of looks of the first rules, as in World::look_names().
  [[nodiscard]] std::optional<std::size_t> share(TableReader& table, std::span<const std::string> look_names);

  /// Reads `below` and `above` of a table; at least one must exist.
  [[nodiscard]] std::vector<PlaceCondition> conditions(TableReader& table);

 private:
  [[nodiscard]] std::optional<QuantityNumber> quantity(TableReader& table, const std::string& name,
                                                       bool of_looks);
  void add_ramps(TableReader& table, std::vector<PlaceRamp>& ramps);
  void add_conditions(TableReader& table, bool above, std::vector<PlaceCondition>& conditions);

  const WorldSpec& world_;
  std::vector<FieldSpec> fields_;
  PlacesSpec& places_;
};

}  // namespace talus::terrain
