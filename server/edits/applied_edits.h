// Read-only view of the applied edit log, for chunk sources.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

#include "chunks/chunk_change.h"

namespace talus::server {

/// The overrides of a chunk of any level at a revision; null if all were removed.
struct EditedChunk {
  std::uint64_t revision = 0;
  std::shared_ptr<const edits::ChunkOverrides> overrides;
};

/// Callable from any thread.
class AppliedEdits {
 public:
  virtual ~AppliedEdits() = default;

  /// Revision of the newest edit that changed the chunk; 0 if it was never edited. Never decreases. Reads
  /// only memory.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey key) const = 0;

  /// The smallest range of rows that has all edited chunks of the key's column and level; may be empty. Reads
  /// only memory.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;

  /// The newest overrides of a chunk. May read the disk: for generator threads. An error is one line.
  [[nodiscard]] virtual tl::expected<EditedChunk, std::string> load(ChunkKey key) const = 0;

  /// Voxels that changed in the chunk after revision `since`, by ascending index, with their current
  /// materials, and the revision that they make. nullopt if they are not remembered any more, or more than
  /// `most`. Reads only memory.
  using Changes = ChangedVoxels;
  [[nodiscard]] virtual std::optional<Changes> changes_since(ChunkKey key, std::uint64_t since,
                                                             std::size_t most) const = 0;
};

}  // namespace talus::server
