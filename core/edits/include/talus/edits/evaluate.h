// What an edit does to a state: every node must come to the same. Nothing here generates, reads a file or
// changes state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <talus/edits/chunk_overrides.h>
#include <talus/edits/edit.h>
#include <talus/edits/levels.h>
#include <talus/edits/settle.h>

namespace talus::edits {

/// Base materials of voxels of level 0, by chunk, by rising index: what an entry of the log carries as runs.
/// It holds at least the voxels of touched_voxels(), with those that settle; more do no harm.
using BaseVoxels = std::map<ChunkCoord, std::vector<Override>>;

/// Where overrides are looked up. What is returned lives until the state changes.
class OverrideSource {
 public:
  virtual ~OverrideSource() = default;
  /// The overrides of a chunk of any level, or null where it has none, before what staged() writes.
  [[nodiscard]] virtual const ChunkOverrides* find(ChunkKey chunk) const = 0;
  /// What is written over those that find() returns, by rising index.
  [[nodiscard]] virtual std::span<const OverrideWrite> staged(ChunkKey /*chunk*/) const { return {}; }
};

/// A voxel that an edit changed; `before` and `after` differ.
struct VoxelChange {
  std::uint16_t index = 0;
  MaterialId before{};
  MaterialId after{};
  MaterialId base{};
  bool operator==(const VoxelChange&) const = default;
};

/// All that changed in a chunk of level 0, by rising index; not empty.
struct ChunkChanges {
  ChunkCoord chunk;
  std::vector<VoxelChange> voxels;
  bool operator==(const ChunkChanges&) const = default;
};

/// The same as absolute writes, which may be made any number of times.
[[nodiscard]] std::vector<OverrideWrite> writes_of(const ChunkChanges& changes);

struct Outcome {
  /// The first guard that does not hold. Then nothing changed: an edit is atomic, across chunks.
  std::optional<std::size_t> conflict;
  std::size_t changed = 0;           // voxels of level 0, slid ones too; 0 takes no revision
  std::vector<ChunkChanges> chunks;  // by rising chunk coordinate
  bool operator==(const Outcome&) const = default;
};

/// `edit` on the state `overrides`, and what it sets loose by `settles`; null: nothing. An error where
/// touched_voxels() has one, or where `base` lacks a voxel that the edit touches, or, where
/// what `base` has may settle, one of settle_box(), which is then named; the
/// same error at every node, as both came from the log. `touched`: touched_voxels() of `edit` without those
/// that settle, where somebody has them already; empty: they are found.
[[nodiscard]] tl::expected<Outcome, EditError> evaluate(const Edit& edit, const BaseVoxels& base,
                                                        const OverrideSource& overrides,
                                                        const SettleRules* settles = nullptr,
                                                        std::span<const TouchedChunk> touched = {});

}  // namespace talus::edits
