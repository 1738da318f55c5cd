// Finds the nearest column with a look.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct FoundColumn {
  std::int64_t x = 0;
  std::int64_t z = 0;
  bool operator==(const FoundColumn&) const = default;
};

/// Returns the nearest base column with a look of World::look_names(), at most `within` columns along x and z
/// from (x, z). Checks every column up to 256 away, every second up to 512, and so on; then every column
/// around the result. A patch narrower than 1/128 of its distance may therefore be missed. Depends only on
/// the world and the arguments.
[[nodiscard]] std::optional<FoundColumn> find_look(const terrain::World& world, std::uint8_t look,
                                                   std::int64_t x, std::int64_t z, std::int64_t within,
                                                   ProgressBar& progress);

/// Shares of the looks, by number, among the columns within `within` of (x, z), from 512 x 512 samples.
[[nodiscard]] std::vector<double> look_shares(const terrain::World& world, std::int64_t x, std::int64_t z,
                                              std::int64_t within);

}  // namespace talus::tools
