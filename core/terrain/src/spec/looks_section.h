// [[look]] and [[province]] of a world.toml. Private to core/terrain.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "spec/places_section.h"
#include "spec/table_reader.h"

namespace talus::terrain {

struct LookTables {
  std::vector<std::optional<World::ShownBy>> shown_by;  // by material
  std::vector<std::string> names;                       // World::look_names()
};

/// Ids of strata are 2 to before `end`; `lowest` extends downward without end.
struct RockIds {
  MaterialId lowest{};
  MaterialId end{};
};

/// Reads both kinds of sections in the order of the file, looks first. Adds their materials to `materials`
/// and `names`, and their rules to `rules`. `materials` must contain air, water, strata and loose materials.
[[nodiscard]] LookTables read_looks(TableReader& root, PlacesReader& places, std::vector<LookRules>& rules,
                                    const RockIds& rock, std::set<std::string>& names,
                                    std::vector<Material>& materials);

}  // namespace talus::terrain
