// Conversion of a height map's samples to heights. Private to core/terrain.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/field.h>
#include <talus/terrain/height_map.h>

namespace talus::terrain {

/// The reason why samples are not valid heights.
struct HeightsFault {
  std::string key;   // the spec's key at fault: "file", "low" or "high"
  std::string what;  // one line
};

/// Converts samples to subvoxels: `low` becomes 0, `high` becomes highest_fx, values outside are clamped,
/// halves are rounded up. If not set, `low` and `high` become the type's limits for uint8 and uint16, else
/// the minimum and the maximum sample, unless that marks missing data. `high` must be at least 1e-290 above
/// `low`.
[[nodiscard]] tl::expected<std::shared_ptr<const Field>, HeightsFault> scaled_heights(
    const HeightMap& map, std::int32_t highest_fx, std::optional<double>& low, std::optional<double>& high);

}  // namespace talus::terrain
