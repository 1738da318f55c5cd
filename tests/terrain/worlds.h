// Worlds that tests use: the sample worlds from their files, and a small one with everything in it.
#pragma once

#include <string>
#include <vector>

#include <talus/terrain/world.h>

namespace talus::test {

/// core/worlds/NAME.toml.
[[nodiscard]] std::string sample_world_text(const std::string& name);
[[nodiscard]] const terrain::World& sample_world(const std::string& name);
/// Its text without all tables that begin so, each up to the next blank line.
[[nodiscard]] std::string sample_world_without(const std::string& name,
                                               const std::vector<std::string>& tables);

/// The whole file of a world of regions that docs/WORLDS.md shows.
[[nodiscard]] std::string regions_world_text();

/// A busy spec of low resolution: four strata, three loose materials (two of one weight), sea.
[[nodiscard]] std::string small_world_text(std::uint64_t seed);
[[nodiscard]] terrain::World small_world(std::uint64_t seed);

/// The small world with tunnels, chambers and entrances, by the slope method or after some steps of erosion.
[[nodiscard]] std::string small_caves_text(std::uint64_t seed, int erosion_steps = 0);
[[nodiscard]] terrain::World small_caves(std::uint64_t seed, int erosion_steps = 0);

/// The same spec with another surface: "ridged", "warped", or a height map (made_height_map.h) with
/// "mirror", "sea" or "blend" outside of it.
[[nodiscard]] std::string small_world_text(std::uint64_t seed, const std::string& surface);
[[nodiscard]] terrain::World small_world(std::uint64_t seed, const std::string& surface);

/// Folds, two sets of faults, a vein and two pockets, to be added to the small world's text.
[[nodiscard]] std::string underground_text();

}  // namespace talus::test
