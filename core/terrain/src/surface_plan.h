// What a spec's surface needs beyond its keys: bounds that span several of them, and its height map. Private
// to the room.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/height_map.h>
#include <talus/terrain/world.h>

#include "spec_fault.h"
#include "spec_reader.h"

namespace talus::terrain {

/// Fetches the height map, where there is one, and puts it into the spec. What is wrong with the surface
/// otherwise; its amplitude has been checked.
[[nodiscard]] std::optional<SpecFault> complete_surface(WorldSpec& spec, const SpecLines& lines,
                                                        const LoadHeightMap& load);

/// The samples as subvoxels: `low` is 0, `high` highest_fx, what lies outside of them is cut off. Where they
/// are not set they become 0 and 65535 for uint16, else the least and the greatest sample.
[[nodiscard]] tl::expected<std::shared_ptr<const Field>, std::string> scaled_heights(
    const HeightMap& map, std::int32_t highest_fx, std::optional<double>& low, std::optional<double>& high);

}  // namespace talus::terrain
