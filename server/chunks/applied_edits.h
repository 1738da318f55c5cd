// Read-only view of the applied edit log, for Chunks. server/edits implements it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

#include "chunks/chunk_change.h"

namespace talus::server {

/// The overrides of a chunk of any level at a revision. Null: its last override was removed.
struct EditedChunk {
  std::uint64_t revision = 0;
  std::shared_ptr<const edits::ChunkOverrides> overrides;
};

/// A column is given as any chunk of it.
using ColumnFilter = std::function<bool(ChunkKey column)>;

/// Callable from any thread.
class AppliedEdits {
 public:
  virtual ~AppliedEdits() = default;

  /// Returns the revision of the newest edit that changed the chunk; 0 if it was never edited. It never
  /// falls. Reads memory alone.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey key) const = 0;

  /// Returns the smallest span of rows of the key's column and level that has all chunks ever edited; empty
  /// if no chunk was. Reads memory alone.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;

  /// Appends the chunks ever edited of those columns of the box for which `wanted` returns true. A chunk
  /// whose edit is just being reported may be missing. Reads memory alone.
  virtual void edited_chunks(const LevelBox& box, const ColumnFilter& wanted,
                             std::vector<ChunkKey>& found) const = 0;

  /// Returns the newest overrides of a chunk. It may read the disk: call it on generator threads. An error is
  /// one line.
  [[nodiscard]] virtual tl::expected<EditedChunk, std::string> load(ChunkKey key) const = 0;

  /// Returns the voxels that changed in the chunk after revision `since`, by rising index, with their
  /// materials now, and the revision that they make; nullopt if that is not remembered any more, or if they
  /// are more than `max_voxels`. Reads memory alone.
  using Changes = ChangedVoxels;
  [[nodiscard]] virtual std::optional<Changes> changes_since(ChunkKey key, std::uint64_t since,
                                                             std::size_t max_voxels) const = 0;
};

}  // namespace talus::server
