// Edits on top of the land that a world generates.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <talus/edits/chunk_overrides.h>
#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::tools {

/// Thread-safe.
class LandEdits {
 public:
  virtual ~LandEdits() = default;

  [[nodiscard]] virtual ContentHash store_id() const = 0;
  /// Revision of the newest edit.
  [[nodiscard]] virtual std::uint64_t revision() const = 0;
  /// Materials of edits in addition to the world's, by ascending id.
  [[nodiscard]] virtual const std::vector<terrain::Material>& materials() const = 0;

  /// A range that contains every edited row of chunks in the key's column; empty if no chunk was edited.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;
  /// Overrides of a chunk of any level; empty if it is as generated.
  [[nodiscard]] virtual Expected<edits::ChunkOverrides> overrides(ChunkKey key) const = 0;
};

/// Opens the store in a directory that talusd used as --data, or in a backup of one; it must belong to the
/// world.
[[nodiscard]] Expected<std::unique_ptr<const LandEdits>> open_store(const std::string& directory,
                                                                    const terrain::World& world);

}  // namespace talus::tools
