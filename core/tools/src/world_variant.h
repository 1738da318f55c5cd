// The same world with a number changed, for pictures that compare.
#pragma once

#include <cstdint>
#include <optional>

#include <talus/terrain/world.h>

#include "failure.h"
#include "world_file.h"

namespace talus::tools {

/// What to change. The rest of the spec stays as it is written.
struct WorldChanges {
  std::optional<std::int64_t> seed{};
  std::optional<int> resolution{};
  std::optional<int> exponent{};       // of the surface
  std::optional<double> roughness{};   // of all stratified materials
  std::optional<int> erosion_steps{};  // by the erosion method
};

/// Fails as World::parse does, where the text is wrong or the change leads out of its bounds.
[[nodiscard]] Expected<terrain::World> world_variant(const WorldText& text, const WorldChanges& changes);

}  // namespace talus::tools
