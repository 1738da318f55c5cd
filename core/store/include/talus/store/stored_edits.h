// The edits of an unused data directory or a backup, by place: for programs that draw the land. Changes no
// file.
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

/// Callable from any thread.
class StoredEdits {
 public:
  /// Reads every chunk once, and keeps the rows of every edited column in memory. No server may use the
  /// directory now or during this object's lifetime. An error is one line for users of --store: the store is
  /// missing, in use by a talusd, of another world, damaged, or of a newer format.
  [[nodiscard]] static tl::expected<std::unique_ptr<StoredEdits>, std::string> open(
      const std::filesystem::path& directory, ContentHash fingerprint);
  ~StoredEdits();
  StoredEdits(const StoredEdits&) = delete;
  StoredEdits& operator=(const StoredEdits&) = delete;

  [[nodiscard]] ContentHash store_id() const { return store_->meta().store_id; }
  [[nodiscard]] std::uint64_t revision() const { return store_->meta().head.revision; }
  /// Material ids that the store has assigned, by name.
  [[nodiscard]] const std::map<std::string, MaterialId>& materials() const { return store_->materials(); }

  /// Range of rows with chunks that were ever edited in the key's column; empty if none was.
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const;
  /// Empty if the chunk is as generated. An error is one line.
  [[nodiscard]] tl::expected<edits::ChunkOverrides, std::string> overrides(ChunkKey key) const;

 private:
  explicit StoredEdits(int lock) : lock_{lock} {}

  const int lock_;  // a descriptor holding the directory's lock; -1: unlocked
  std::unique_ptr<ReadOnlyStore> store_;
  std::unordered_map<ChunkKey, ChunkRange> rows_;  // by the key of row 0
};

}  // namespace talus::store
