// What loose material does where an edit took its support, or put it steeper than it lies: it falls, and it
// slides until it lies at its angle of repose (thesis 3.6, which so far made land, come alive). Integers
// alone; every node that settles the same voxels gets the same.
//
// Land stays as it was generated until something under it goes, however steep it lies: a voxel moves only
// into room that was ground, or from where none was. So a hole is filled from above, and the hollow wanders
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

/// A material that slides. All others, but for air and water, do not, and hold what leans on them.
struct SettleRule {
  /// Of rises: parts of a voxel.
  static constexpr std::int32_t kUnit = 256;

  MaterialId material{};
  std::int32_t rise = 0;  // over a run of one column, at rest: the tangent of the angle of repose
  bool operator==(const SettleRule&) const = default;
};
/// By rising material, each once.
using SettleRules = std::vector<SettleRule>;
using SettleRulesPtr = std::shared_ptr<const SettleRules>;

/// Bounds of what one edit sets loose.
inline constexpr std::int64_t kSettleColumns = 256;
inline constexpr std::int64_t kSettleRows = 64;
inline constexpr std::size_t kSettleVoxels = static_cast<std::size_t>(kSettleColumns * kSettleRows);
inline constexpr std::int64_t kSettleMargin = 7;  // columns around the edit, where there are few
inline constexpr int kSettleMoves = 4'096;        // of single voxels
/// At columns, and at voxels that may move. So what one edit costs is bounded, however little moves each
/// time.
inline constexpr int kSettleLooks = 32'768;
/// How many columns apart slopes are measured, so that angles of less than 45 degrees differ.
inline constexpr std::int64_t kSettleReach = 4;

/// Both corners included.
struct VoxelBox {
  VoxelPos first;
  VoxelPos last;
  bool operator==(const VoxelBox&) const = default;
};

/// Where the edit sets material loose: around all that it writes, 64 rows and at most 256 columns; or nothing
/// where it writes too much, or near the end of the world. REQUIRES: touched_voxels() accepts the edit.
[[nodiscard]] std::optional<VoxelBox> settle_box(const Edit& edit);

/// A voxel that settles.
struct SettlingVoxel {
  MaterialId now{};
  MaterialId base{};
  bool edited = false;  // just now: what leans on it may move
};

/// What settling took.
struct Settled {
  int moves = 0;
  int looks = 0;
};

/// Lets all that is loose come to rest. `voxels` are those of the box, x fastest, then z, then y; it has
/// kSettleRows rows at most. What lies beyond it stays and holds; nothing leaves it. Ends after kSettleMoves
/// or kSettleLooks, even where more would move. Of each material of the rules there is as much afterwards as
/// before.
Settled settle(const VoxelBox& box, const SettleRules& rules, std::span<SettlingVoxel> voxels);

}  // namespace talus::edits
