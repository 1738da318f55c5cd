// The edits of a data directory that no server has, or of a backup of one, by place: for programs that show
// the land. No file changes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/store/read_only_store.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::store {

/// Any thread may call any of these.
class StoredEdits {
 public:
  /// Reads every chunk once, and keeps the rows of every edited column in memory. No server may use the
  /// directory, and none can while this lives. An error is one line, for people who give a program --store:
  /// there is no store, a talusd uses it, it is of another world, damaged, or of a newer format.
  [[nodiscard]] static tl::expected<std::unique_ptr<StoredEdits>, std::string> open(
      const std::filesystem::path& directory, ContentHash fingerprint);
  ~StoredEdits();
  StoredEdits(const StoredEdits&) = delete;
  StoredEdits& operator=(const StoredEdits&) = delete;

  [[nodiscard]] ContentHash store_id() const { return store_->meta().store_id; }
  [[nodiscard]] std::uint64_t revision() const { return store_->meta().head.revision; }
  /// What the store has given an id, by name.
  [[nodiscard]] const std::map<std::string, MaterialId>& materials() const { return store_->materials(); }

  /// Rows of the chunks of the key's column that were ever edited lie in this span; empty: none was.
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const;
  /// Empty where the chunk is as generated. An error is one line.
  [[nodiscard]] tl::expected<edits::ChunkOverrides, std::string> overrides(ChunkKey key) const;

 private:
  explicit StoredEdits(int lock) : lock_{lock} {}

  const int lock_;  // a descriptor, which holds the directory's lock; -1: it has none
  std::unique_ptr<ReadOnlyStore> store_;
  std::unordered_map<ChunkKey, ChunkRange> rows_;  // by the key of row 0
};

}  // namespace talus::store
