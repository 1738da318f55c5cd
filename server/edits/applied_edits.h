// The state of edits as those see it who serve chunks. What is behind it applies the log.
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

/// The overrides of a chunk of any level at a revision. Null: it has none any more.
struct EditedChunk {
  std::uint64_t revision = 0;
  std::shared_ptr<const edits::ChunkOverrides> overrides;
};

/// Any thread may call any of these.
class AppliedEdits {
 public:
  virtual ~AppliedEdits() = default;

  /// Of the newest edit that changed the chunk; 0: none ever did. Never falls. Reads memory alone.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey key) const = 0;

  /// The least span of rows of the key's column and level that has all chunks ever edited; empty: none was.
  /// Reads memory alone.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;

  /// The newest overrides of a chunk. May read the disk: on generator threads. An error is one line.
  [[nodiscard]] virtual tl::expected<EditedChunk, std::string> load(ChunkKey key) const = 0;

  /// Voxels that changed in the chunk after revision `since`, by rising index, with their materials now, and
  /// the revision that they make. None where that is not remembered any more, or they are more than `most`.
  /// Reads memory alone.
  using Changes = ChangedVoxels;
  [[nodiscard]] virtual std::optional<Changes> changes_since(ChunkKey key, std::uint64_t since,
                                                             std::size_t most) const = 0;
};

}  // namespace talus::server
