// Effect of an edit on a state; every node must compute the same. Generates nothing, reads no files and
// changes no state.
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

/// Base materials of level-0 voxels, by chunk and ascending index; log entries store them as runs. Contains
/// at least the voxels of touched_voxels() and of settle_box(); more are harmless.
using BaseVoxels = std::map<ChunkCoord, std::vector<Override>>;

/// Secret materials around an edit, of a base that shows other materials in their place as long as nothing
/// exposes them: of all voxels that the edit touches or may settle, and of those with a face beside them. So
/// nodes without the secret reveal the same.
struct SecretVoxels {
  std::vector<MaterialId> see_through;  // ascending; voxels of other materials hide what is behind them
  BaseVoxels hidden;                    // without empty lists
  BaseVoxels base;                      // what the base shows at the same voxels

  [[nodiscard]] bool empty() const { return hidden.empty(); }
};

/// Source of overrides. Returned pointers are valid until the state changes.
class OverrideSource {
 public:
  virtual ~OverrideSource() = default;
  /// Overrides of a chunk of any level, without the writes of staged(); null if it has none.
  [[nodiscard]] virtual const ChunkOverrides* find(ChunkKey chunk) const = 0;
  /// Writes on top of find()'s overrides, by ascending index.
  [[nodiscard]] virtual std::span<const OverrideWrite> staged(ChunkKey /*chunk*/) const { return {}; }
};

/// A voxel changed by an edit; `before` and `after` differ.
struct VoxelChange {
  std::uint16_t index = 0;
  MaterialId before{};
  MaterialId after{};
  MaterialId base{};
  bool operator==(const VoxelChange&) const = default;
};

/// All changes in a chunk of level 0, by ascending index; not empty.
struct ChunkChanges {
  ChunkCoord chunk;
  std::vector<VoxelChange> voxels;
  bool operator==(const ChunkChanges&) const = default;
};

/// The same changes as absolute writes, which are idempotent.
[[nodiscard]] std::vector<OverrideWrite> writes_of(const ChunkChanges& changes);

struct Outcome {
  /// The first guard that does not hold. Then nothing changed: an edit is atomic across chunks.
  std::optional<std::size_t> conflict;
  std::size_t changed = 0;           // voxels of level 0, with settled and revealed ones; 0 makes no revision
  std::vector<ChunkChanges> chunks;  // by ascending chunk coordinate
  bool operator==(const Outcome&) const = default;
};

/// Evaluates `edit` on the state `overrides`, then settles loose material by `settles`, if not null. If that
/// changes anything, secret voxels that are as generated and have a face to an edited see-through voxel
/// become overrides with their secret material. Fails if
/// touched_voxels() fails, if `base` lacks a voxel that the edit touches, or if base material may settle and
/// `base` lacks a voxel of settle_box(); the error names it. Every node gets the same error, as edit and base
/// come from the log. `touched`: touched_voxels() of `edit`, if already known; if empty, it is computed.
[[nodiscard]] tl::expected<Outcome, EditError> evaluate(const Edit& edit, const BaseVoxels& base,
                                                        const OverrideSource& overrides,
                                                        const SettleRules* settles = nullptr,
                                                        std::span<const TouchedChunk> touched = {},
                                                        const SecretVoxels* secrets = nullptr);

}  // namespace talus::edits
