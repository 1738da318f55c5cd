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

/// Reads what is asked of places into a PlacesSpec. The surface has been read.
class PlacesReader {
 public:
  /// `fields`: those of the file, that conditions and ramps may name; with a surface of regions alone.
  PlacesReader(const WorldSpec& world, std::vector<FieldSpec> fields, PlacesSpec& places);

  /// `where` of a table, as a share; none where it is left out.
  [[nodiscard]] std::optional<std::size_t> share(TableReader& table);
  /// The same, or where it names looks by `looks`: names of the first rules, as World::look_names() has them.
  [[nodiscard]] std::optional<std::size_t> share(TableReader& table, std::span<const std::string> look_names);

  /// `below` and `above` of a table; at least one of them.
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
