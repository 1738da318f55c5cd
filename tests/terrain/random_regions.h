// Random worlds of regions, with all that a place may decide.
#pragma once

#include <cstdint>
#include <string>

namespace talus::test {

/// A whole world.toml that World::parse takes, mostly: a random one may ask for too many layers.
[[nodiscard]] std::string random_regions_text(std::uint64_t seed);

}  // namespace talus::test
