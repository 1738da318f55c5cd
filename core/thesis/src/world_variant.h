// Variants of a world, for pictures that compare.
#pragma once

#include <cstdint>
#include <optional>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <talus/tools/world_file.h>

namespace talus::tools {

/// Values to change. The rest of the spec is unchanged.
struct WorldChanges {
  std::optional<std::int64_t> seed{};
  std::optional<int> resolution{};
  std::optional<int> exponent{};       // the surface's
  std::optional<double> roughness{};   // for all stratified materials
  std::optional<int> erosion_steps{};  // for the erosion method
};

/// Fails like World::parse() if the text is invalid or the change exceeds its bounds.
[[nodiscard]] Expected<terrain::World> world_variant(const WorldText& text, const WorldChanges& changes);

}  // namespace talus::tools
