// Material of a voxel. A world assigns the ids: air 0, water 1, then its stratified and its eroded materials
// in the order of its spec.
#pragma once

#include <cstdint>

namespace talus {

enum class MaterialId : std::uint16_t {};

inline constexpr MaterialId kAir{0};
inline constexpr MaterialId kWater{1};

[[nodiscard]] constexpr std::uint16_t to_integer(MaterialId id) {
  return static_cast<std::uint16_t>(id);
}

}  // namespace talus
