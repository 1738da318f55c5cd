// Settles loose material after an edit removed its support or left it too steep: it falls and slides until it
// lies at its angle of repose (thesis 3.6, applied there to generated land). Integer arithmetic only; every
// node that settles the same voxels gets the same result.
//
// Land stays as generated, however steep, until ground is removed: a voxel moves only into space that was
// generated as ground, or from a place that was not. So a hole is filled from above, and the hollow travels
// up the slope.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <talus/edits/edit.h>

namespace talus::edits {

/// A material that slides. All others except air and water stay, and support what leans on them.
struct SettleRule {
  /// Units of `rise` per voxel.
  static constexpr std::int32_t kUnit = 256;

  MaterialId material{};
  std::int32_t rise = 0;  // per column of run, at rest: the tangent of the angle of repose
  bool operator==(const SettleRule&) const = default;
};
/// By ascending material, without duplicates.
using SettleRules = std::vector<SettleRule>;
using SettleRulesPtr = std::shared_ptr<const SettleRules>;

/// Limits per edit.
inline constexpr std::int64_t kSettleColumns = 256;
inline constexpr std::int64_t kSettleRows = 64;
inline constexpr std::size_t kSettleVoxels = static_cast<std::size_t>(kSettleColumns * kSettleRows);
inline constexpr std::int64_t kSettleMargin = 7;  // columns around the edit, if it is small
inline constexpr int kSettleMoves = 4'096;        // moves of single voxels
/// Inspections of columns and of voxels that may move. Bounds the cost of an edit even if little moves each
/// time.
inline constexpr int kSettleProbes = 32'768;
/// Maximum distance in columns over which slopes are measured; distinguishes angles below 45 degrees.
inline constexpr std::int64_t kSettleReach = 4;

/// Region that an edit may set loose: around all its writes, 64 rows and at most 256 columns. nullopt if the
/// edit writes too much, or is near the edge of the world. REQUIRES: touched_voxels() accepts the edit.
[[nodiscard]] std::optional<VoxelBox> settle_box(const Edit& edit);

/// A voxel of the region.
struct SettlingVoxel {
  MaterialId now{};
  MaterialId base{};
  bool edited = false;  // by this edit: material that leans on it may move
};

/// Work done by settle().
struct SettleWork {
  int moves = 0;
  int probes = 0;
};

/// Moves all loose material to rest. `voxels` are the box's, x fastest, then z, then y; the box has at most
/// kSettleRows rows. Voxels outside are fixed and hold; nothing leaves the box. Stops after kSettleMoves or
/// kSettleProbes, even if more would move. Preserves the amount of each material of the rules.
SettleWork settle(const VoxelBox& box, const SettleRules& rules, std::span<SettlingVoxel> voxels);

}  // namespace talus::edits
