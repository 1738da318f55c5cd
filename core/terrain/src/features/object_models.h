// Shapes of objects: trees, boulders and so on by integer formulas, and authors' models. Private to
// core/terrain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

#include <talus/terrain/voxel_model.h>

namespace talus::terrain {

/// A voxel of a model, relative to the object's foot: y = 0 is the first voxel above the ground.
struct ModelVoxel {
  std::int8_t x = 0;
  std::int8_t y = 0;
  std::int8_t z = 0;
  std::uint8_t part = 0;  // index of the kind's material; part 0 is in front where objects intersect
  bool operator==(const ModelVoxel&) const = default;
};

/// Sorted by part, then y, z and x; each position once, with the lowest part that has it.
using ObjectModel = std::vector<ModelVoxel>;

/// Maximum distance of a voxel from the foot along x or z; maximum height; maximum depth, for ground that
/// falls away.
inline constexpr int kObjectReach = 64;
inline constexpr int kObjectTop = 128;
inline constexpr int kObjectRoot = 4;
/// The same bounds of shapes by formulas, part of what the formulas mean.
inline constexpr int kFormulaReach = 10;
inline constexpr int kFormulaTop = 32;
static_assert(kMaxModelWidth == 2 * kObjectReach && kMaxModelHeight == kObjectTop);

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
  std::array<std::string_view, 2> parts;  // the second may be empty
};
inline constexpr std::array<ModelForm, kModelKinds> kModelForms{{{"conifer", {"wood", "leaves"}},
                                                                 {"broadleaf", {"wood", "leaves"}},
                                                                 {"acacia", {"wood", "leaves"}},
                                                                 {"jungle_tree", {"wood", "leaves"}},
                                                                 {"dead_tree", {"wood", ""}},
                                                                 {"cactus", {"flesh", ""}},
                                                                 {"boulder", {"stone", ""}},
                                                                 {"bush", {"leaves", ""}}}};

/// Makes one variant of a kind: `seed` decides its size and every voxel.
[[nodiscard]] ObjectModel make_model(ModelKind kind, std::uint64_t seed);

/// Converts an author's model. Its foot is in the middle of its lowest layer, which is extended into the
/// ground. `parts` is indexed by colour.
[[nodiscard]] ObjectModel model_of(const VoxelModel& model, const std::array<std::uint8_t, 256>& parts);

/// Number of levels, from 0 on, that show these models: levels at which two thirds of the voxels touch
/// another shown voxel, or the ground. At other levels models would be cubes in the air.
[[nodiscard]] int levels_shown(std::span<const ObjectModel> models);

/// A model's voxels by column, for readers of a single column.
class ModelColumns {
 public:
  explicit ModelColumns(const ObjectModel& model);
  [[nodiscard]] std::span<const ModelVoxel> at(int x, int z) const {
    if (std::max(std::abs(x), std::abs(z)) > reach_) return {};
    const std::size_t column = column_of(x, z);
    return std::span{voxels_}.subspan(starts_[column], starts_[column + 1] - starts_[column]);
  }

 private:
  [[nodiscard]] std::size_t column_of(int x, int z) const {
    return static_cast<std::size_t>((z + reach_) * (2 * reach_ + 1) + x + reach_);
  }
  std::vector<ModelVoxel> voxels_;
  int reach_ = 0;
  std::vector<std::uint32_t> starts_;
};

/// A model's voxels in front (part 0) and behind, row by row.
class ModelRows {
 public:
  explicit ModelRows(const ObjectModel& model);
  /// The voxels in rows [from, to), which may extend past the model.
  [[nodiscard]] std::span<const ModelVoxel> at(bool front, std::int64_t from, std::int64_t to) const;

 private:
  static constexpr std::size_t kRows = kObjectRoot + kObjectTop;
  std::vector<ModelVoxel> voxels_;
  std::array<std::uint32_t, 2 * kRows + 1> starts_{};
};

/// A model's voxels for levels 1 and 2, grouped by the voxels that a level shows.
class ModelLevels {
 public:
  static constexpr int kCoarsest = 2;

  explicit ModelLevels(const ObjectModel& model);
  /// The voxels with the given x, y and z modulo 1 << level. REQUIRES 1 <= level <= kCoarsest.
  [[nodiscard]] std::span<const ModelVoxel> at(bool front, int level, std::int64_t x, std::int64_t y,
                                               std::int64_t z) const;

 private:
  static constexpr std::size_t kGroups = 64;  // by x, y and z modulo 4, ordered by their lowest bits first
  std::vector<ModelVoxel> voxels_;
  std::array<std::uint32_t, 2 * kGroups + 1> starts_{};
};

}  // namespace talus::terrain
