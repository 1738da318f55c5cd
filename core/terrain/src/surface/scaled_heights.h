// The samples of a height map as heights. Private to core/terrain.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/field.h>
#include <talus/terrain/height_map.h>

namespace talus::terrain {

/// Why samples are no heights.
struct HeightsFault {
  std::string key;   // the spec's that is to blame: "file", "low" or "high"
  std::string what;  // one line
};

/// The samples as subvoxels: `low` becomes 0, `high` becomes highest_fx, what lies outside is clamped, halves
/// are rounded up. `low` and `high` that are not set become 0 and 65535 for uint16, else the least and the
/// greatest sample. `high` lies at least 1e-290 above `low`.
[[nodiscard]] tl::expected<std::shared_ptr<const Field>, HeightsFault> scaled_heights(
    const HeightMap& map, std::int32_t highest_fx, std::optional<double>& low, std::optional<double>& high);

}  // namespace talus::terrain
