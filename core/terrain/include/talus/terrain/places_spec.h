// What an author says of places: [[look]], [[province]] and `where` in a world.toml. docs/WORLDS.md explains
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

/// What a condition or a ramp may ask of a column. All but height, slope and cliff are of regions alone; they
/// carry one small noise, so that every border has the same ragged edge.
enum class Quantity : std::uint8_t {
  height,       // of the ground over the sea, or over y = 0 where there is none; terrain units
  temperature,  // -1 to 1.2, colder with height
  moisture,     // -1 to 1
  mesas,        // 0 to 1: how much mesa country
  ranges,       // 0 to 1: how much of a mountain range
  base,         // height of the plain without hills, terrain units
  terraces,     // 0 to 1: how high on a mesa
  slope,        // eq. 1, subvoxels a column
  cliff,        // 0 to 1: 1 at a wall
};
inline constexpr std::size_t kQuantities = 9;
inline constexpr std::array<std::string_view, kQuantities> kQuantityNames{
    "height", "temperature", "moisture", "mesas", "ranges", "base", "terraces", "slope", "cliff"};

/// A Quantity's number, or kQuantities and more: PlacesSpec::fields[number - kQuantities].
using QuantityNumber = std::size_t;
[[nodiscard]] constexpr QuantityNumber number_of(Quantity quantity) {
  return static_cast<QuantityNumber>(quantity);
}

/// quantity < limit, or quantity >= limit where it is `above`.
struct PlaceCondition {
  QuantityNumber quantity = 0;
  bool above = false;
  double limit = 0;
};

/// 0 at `none`, 1 at `all`, straight between and level beyond; none > all falls.
struct PlaceRamp {
  QuantityNumber quantity = 0;
  double none = 0;
  double all = 1;
};

/// All must hold. Of slope and cliff there are none.
struct LookCase {
  std::vector<PlaceCondition> conditions;
  std::uint8_t look = 0;  // 1 to kMaxLooks
};
inline constexpr std::size_t kMaxLooks = 63;

/// Which look a column has: that of the first case that holds, or 0.
struct LookRules {
  std::vector<LookCase> cases;
};

/// How much of something there is at a column: the product of the ramps, and nothing where the column's look
/// is none of `looks`.
inline constexpr std::int32_t kWholeShare = 4096;  // a share of everything
struct ShareRule {
  std::vector<PlaceRamp> ramps;
  std::uint64_t looks = ~std::uint64_t{0};  // bit k: look k, of the first rules
};

struct PlacesSpec {
  std::vector<FieldSpec> fields;  // those that quantities beyond the named ones are
  std::vector<LookRules> looks;   // of the cover, of other materials, of all strata, of water
  std::vector<ShareRule> shares;  // of loose materials and objects
  double lapse = 230;             // terrain units of height that are colder by 1

  [[nodiscard]] bool any() const { return !looks.empty() || !shares.empty(); }
};

}  // namespace talus::terrain
