// Where the nearest column with a look is.
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

/// The nearest base column with that look, of World::look_names(), at most `within` columns along x and z
/// from (x, z). It looks at every column up to 256 away, at every second up to 512, and so on; then at every
/// column around what it found. So a patch may be overlooked that is narrower than 1/128 of its distance.
/// Depends on the world and these numbers alone.
[[nodiscard]] std::optional<FoundColumn> find_look(const terrain::World& world, std::uint8_t look,
                                                   std::int64_t x, std::int64_t z, std::int64_t within,
                                                   ProgressBar& progress);

/// What part of the columns within `within` columns of (x, z) has which look, by number; of 512 x 512 of
/// them.
[[nodiscard]] std::vector<double> look_shares(const terrain::World& world, std::int64_t x, std::int64_t z,
                                              std::int64_t within);

}  // namespace talus::tools
