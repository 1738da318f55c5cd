// export.json: what the arrays of an export mean.
#pragma once

#include <span>
#include <string>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

namespace talus::tools {

/// `layers` are the materials of the planes of strata.npy, bottom up.
[[nodiscard]] std::string export_json(const terrain::World& world, const terrain::Region& region,
                                      std::span<const MaterialId> layers);

}  // namespace talus::tools
