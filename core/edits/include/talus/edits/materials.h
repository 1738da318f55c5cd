// Which name of a material that people may place has which id. The log gives ids, so that all nodes give the
// same; an id is given once, for ever.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/material_name.h>

namespace talus::edits {

/// Ids from this one on are given to names, each once, for ever: a store may call its material something
/// else, and gives the old name, used again, another id. Those below are of materials that worlds generate,
/// and follow from the world alone.
inline constexpr std::uint16_t kFirstBound = 256;
using talus::kMaxMaterialNameBytes;

using MaterialIds = std::map<std::string, MaterialId>;
/// Names in the order in which they were asked for, each with its id.
using NamedIds = std::vector<std::pair<std::string, MaterialId>>;

/// An id for each name: its own where it is bound, else the next after the greatest that is. Names of
/// generated materials in `known` count for nothing. Nothing where a name is empty, too long or given twice,
/// or where ids end.
[[nodiscard]] std::optional<NamedIds> ids_for(std::span<const std::string> names, const MaterialIds& known);

}  // namespace talus::edits
