// The edits of a data directory, or of a backup of one, read while no server has it. Nothing in it changes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

#include "store/data_directory.h"
#include "store/read_only_store.h"

namespace talus::server {

/// Any thread may call any of these.
class StoredEdits {
 public:
  /// Looks at every key and checksum, and keeps the place of every edited column in memory. An error is one
  /// line: there is no store, a talusd uses it, it is of another world, damaged, or of a newer format.
  [[nodiscard]] static tl::expected<std::unique_ptr<StoredEdits>, std::string> open(
      const std::filesystem::path& directory, ContentHash fingerprint);

  [[nodiscard]] ContentHash store_id() const { return directory_.store_id(); }
  [[nodiscard]] std::uint64_t revision() const { return store_->meta().head.revision; }
  /// What the store has given an id, by name.
  [[nodiscard]] const std::map<std::string, MaterialId>& materials() const { return store_->materials(); }

  /// Rows of the chunks of the key's column that were ever edited lie in this span; empty: none was.
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const;
  /// Empty where the chunk is as generated. An error is one line.
  [[nodiscard]] tl::expected<edits::ChunkOverrides, std::string> overrides(ChunkKey key) const;

 private:
  StoredEdits(DataDirectory directory, std::unique_ptr<ReadOnlyStore> store)
      : directory_{std::move(directory)}, store_{std::move(store)} {}
  void note(ChunkKey key);

  const DataDirectory directory_;  // holds its lock
  const std::unique_ptr<ReadOnlyStore> store_;
  std::unordered_map<ChunkKey, ChunkRange> rows_;  // by the key of row 0
};

}  // namespace talus::server
