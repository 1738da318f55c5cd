// An author's rules for places: [[look]], [[province]] and `where` in a world.toml. docs/WORLDS.md explains
// each key.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <talus/terrain/regions_spec.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// Quantities that a condition or a ramp may use. All except height, slope and cliff exist only with regions;
/// they include one small noise, so that every border has the same ragged edge.
enum class Quantity : std::uint8_t {
  height,       // of the ground above the sea, or above y = 0 without a sea; terrain units
  temperature,  // -1 to 1.2, colder with height
  moisture,     // -1 to 1
  mesas,        // 0 to 1: strength of mesa country
  ranges,       // 0 to 1: strength of a mountain range
  base,         // height of the plain without hills, terrain units
  terraces,     // 0 to 1: relative height on a mesa
  slope,        // eq. 1, subvoxels per column
  cliff,        // 0 to 1: 1 at a wall
};
inline constexpr std::size_t kQuantities = 9;
inline constexpr std::array<std::string_view, kQuantities> kQuantityNames{
    "height", "temperature", "moisture", "mesas", "ranges", "base", "terraces", "slope", "cliff"};

/// A Quantity's number; kQuantities and above mean PlacesSpec::fields[number - kQuantities].
using QuantityNumber = std::size_t;
[[nodiscard]] constexpr QuantityNumber number_of(Quantity quantity) {
  return static_cast<QuantityNumber>(quantity);
}

/// quantity < limit, or quantity >= limit if `above`.
struct PlaceCondition {
  QuantityNumber quantity = 0;
  bool above = false;
  double limit = 0;
};

/// 0 at `none`, 1 at `all`, linear between them and constant beyond. Falls if none > all.
struct PlaceRamp {
  QuantityNumber quantity = 0;
  double none = 0;
  double all = 1;
};

/// All conditions must hold. Slope and cliff are not allowed.
struct LookCase {
  std::vector<PlaceCondition> conditions;
  std::uint8_t look = 0;  // 1 to kMaxLooks
};
inline constexpr std::size_t kMaxLooks = 63;

/// A column's look is that of the first case that holds, or 0.
struct LookRules {
  std::vector<LookCase> cases;
};

inline constexpr std::int32_t kWholeShare = 4096;  // a share of everything
/// A column's share of something: the product of the ramps, or 0 if the column's look is not in `looks`.
struct ShareRule {
  std::vector<PlaceRamp> ramps;
  std::uint64_t looks = ~std::uint64_t{0};  // bit k: look k of the first rules
};

struct PlacesSpec {
  std::vector<FieldSpec> fields;  // fields[i] is quantity kQuantities + i
  std::vector<LookRules> looks;   // rules for the cover, other materials, all strata, and water
  std::vector<ShareRule> shares;  // rules for loose materials and objects
  double lapse = 230;             // rise in terrain units that lowers the temperature by 1

  [[nodiscard]] bool any() const { return !looks.empty() || !shares.empty(); }
};

}  // namespace talus::terrain
