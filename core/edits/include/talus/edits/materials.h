// Ids of placeable materials by name. The log assigns them, so that all nodes agree; an assignment is
// permanent.
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

/// First id assigned to a name. Assignments are permanent: if a store renames its material and reuses the old
/// name, that name gets another id. Lower ids belong to generated materials and follow from the world alone.
inline constexpr std::uint16_t kFirstBound = 256;
using talus::kMaxMaterialNameBytes;

using MaterialIds = std::map<std::string, MaterialId>;
/// Names in the order of the request, each with its id.
using NamedIds = std::vector<std::pair<std::string, MaterialId>>;

/// Returns an id for each name: its own if bound, otherwise the next after the greatest bound id. Names of
/// generated materials in `known` are ignored. nullopt if a name is empty, too long or duplicated, or ids are
/// exhausted.
[[nodiscard]] std::optional<NamedIds> ids_for(std::span<const std::string> names, const MaterialIds& known);

}  // namespace talus::edits
