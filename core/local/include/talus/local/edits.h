// Edits of one player on a world, in memory. Everything follows core/edits: an edit here does what a server
// would do.
#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/edits/edit.h>
#include <talus/edits/evaluate.h>
#include <talus/local/local.h>
#include <talus/voxel/material.h>

namespace talus::local {

struct EditOutcome {
  std::optional<std::size_t> conflict;  // the first guard that does not hold; nothing changed then
  std::size_t changed = 0;              // voxels of level 0
  std::vector<ChunkKey> chunks;         // that changed, of all levels, each once
};

/// Id of a world's placeable material, by its index in World::placeables(). A server's store may assign
/// others.
[[nodiscard]] MaterialId placeable_id(std::size_t index);

/// Not thread-safe. Settles nothing.
class Edits final : private edits::OverrideSource {
 public:
  /// Applies an edit whole or not at all; an error names what `workspace`'s world forbids. Generates the
  /// chunks that it touches.
  tl::expected<EditOutcome, edits::EditError> apply(Workspace& workspace, const edits::Edit& edit);

  /// A chunk as generated, with its edits.
  [[nodiscard]] Chunk merged_over(ChunkKey key, const Chunk& generated) const;

 private:
  [[nodiscard]] const edits::ChunkOverrides* find(ChunkKey chunk) const override;

  std::unordered_map<ChunkKey, edits::ChunkOverrides> overrides_;
};

}  // namespace talus::local
