// The shapes of objects: trees, boulders and the like by formulas, in integers. Private to core/terrain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace talus::terrain {

/// A voxel of a model, from the object's foot: y = 0 is the first voxel above the ground.
struct ModelVoxel {
  std::int8_t x = 0;
  std::int8_t y = 0;
  std::int8_t z = 0;
  std::uint8_t part = 0;  // of the kind's materials; 0 is in front where objects meet
  bool operator==(const ModelVoxel&) const = default;
};

/// By part, then y, then z, then x; each place once, of the lowest part that has it.
using ObjectModel = std::vector<ModelVoxel>;

/// No voxel is farther from the foot along x or z, or higher; nor deeper, where ground falls away.
inline constexpr int kObjectReach = 10;
inline constexpr int kObjectTop = 32;
inline constexpr int kObjectRoot = 4;

enum class ModelKind : std::uint8_t {
  conifer,
  broadleaf,
  acacia,
  jungle_tree,
  dead_tree,
  cactus,
  boulder,
  bush,
};
inline constexpr std::size_t kModelKinds = 8;
struct ModelForm {
  std::string_view name;
  std::array<std::string_view, 2> parts;  // by part; the second may be empty
};
inline constexpr std::array<ModelForm, kModelKinds> kModelForms{{{"conifer", {"wood", "leaves"}},
                                                                 {"broadleaf", {"wood", "leaves"}},
                                                                 {"acacia", {"wood", "leaves"}},
                                                                 {"jungle_tree", {"wood", "leaves"}},
                                                                 {"dead_tree", {"wood", ""}},
                                                                 {"cactus", {"flesh", ""}},
                                                                 {"boulder", {"stone", ""}},
                                                                 {"bush", {"leaves", ""}}}};

/// One of the many of a kind: `seed` decides its size and every voxel.
[[nodiscard]] ObjectModel make_model(ModelKind kind, std::uint64_t seed);

/// Sorts, and drops what is said twice or out of bounds.
void tidy(ObjectModel& model);

}  // namespace talus::terrain
