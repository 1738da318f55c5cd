// Builds a new edit store chunk by chunk in a staging directory, for restore, import and rebase. Memory is
// bounded regardless of the number of chunks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/store/store_identity.h>

namespace rocksdb {
class DB;
class WriteBatch;
}  // namespace rocksdb

namespace talus::store {

class StoreBuilder {
 public:
  using Status = tl::expected<void, std::string>;

  /// Creates the database in `directory`, which must be empty. Its log continues after `position` and `link`.
  [[nodiscard]] static tl::expected<std::unique_ptr<StoreBuilder>, std::string> create(
      const std::filesystem::path& directory, const StoreIdentity& identity, std::uint64_t position,
      std::uint64_t link);
  ~StoreBuilder();

  /// Adds a chunk of level 0, each once, in any order; coarse levels are derived. Without voxels nothing is
  /// written. `revision` is at least 1.
  [[nodiscard]] Status add(ChunkCoord chunk, std::uint64_t revision, std::span<const Override> voxels);
  [[nodiscard]] Status add(std::string_view name, MaterialId material);

  [[nodiscard]] std::uint64_t chunks() const { return chunks_; }  // of level 0
  [[nodiscard]] std::uint64_t voxels() const { return voxels_; }
  [[nodiscard]] edits::StateHash hash() const { return hash_; }

  /// Writes the store's meta and the files next to the database, and syncs. `revision` must be at least the
  /// revision of each chunk.
  [[nodiscard]] Status finish(std::uint64_t revision, std::int64_t time_ms);

 private:
  struct Coarse {
    std::uint64_t revision = 0;
    std::vector<Override> voxels;
  };

  StoreBuilder(std::filesystem::path directory, const StoreIdentity& identity);
  [[nodiscard]] Status put(const std::string& key);
  [[nodiscard]] Status write();
  [[nodiscard]] Status write_coarse();

  std::filesystem::path directory_;
  std::unique_ptr<rocksdb::DB> db_;
  std::unique_ptr<rocksdb::WriteBatch> batch_;
  StoreMeta meta_;
  edits::StateHash hash_;
  std::uint64_t chunks_ = 0;
  std::uint64_t voxels_ = 0;
  std::unordered_map<ChunkKey, Coarse> coarse_;  // not written yet
  std::size_t coarse_voxels_ = 0;
  Bytes value_;
};

/// Writes the files next to a database at `meta`: store.toml and acknowledged.
[[nodiscard]] tl::expected<void, std::string> write_store_files(const std::filesystem::path& directory,
                                                                const StoreMeta& meta);

}  // namespace talus::store
