// Edits that are laid over what a world generates.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <talus/edits/chunk_overrides.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

#include "failure.h"

namespace talus::tools {

/// Any thread may call any of these.
class LandEdits {
 public:
  virtual ~LandEdits() = default;

  [[nodiscard]] virtual ContentHash store_id() const = 0;
  /// Of the newest edit.
  [[nodiscard]] virtual std::uint64_t revision() const = 0;
  /// Materials that edits may have beyond the world's, by rising id.
  [[nodiscard]] virtual const std::vector<terrain::Material>& materials() const = 0;

  /// Rows of the chunks of the key's column that were ever edited lie in this span; empty: none was.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;
  /// Of a chunk of any level; empty where it is as generated.
  [[nodiscard]] virtual Expected<edits::ChunkOverrides> overrides(ChunkKey key) const = 0;
};

/// Those of the store in a directory that talusd was given as --data, or in a backup of one, which must be of
/// the world.
[[nodiscard]] Expected<std::unique_ptr<const LandEdits>> open_store(const std::string& directory,
                                                                    const terrain::World& world);

}  // namespace talus::tools
