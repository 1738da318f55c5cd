#include <talus/store/whole_store.h>

#include <memory>

#include <fmt/format.h>
#include <rocksdb/utilities/checkpoint.h>

#include <talus/store/id_check.h>
#include <talus/store/open_rocks.h>
#include <talus/store/regular_files.h>
#include <talus/store/rocks.h>
#include <talus/store/store_builder.h>
#include <talus/store/store_reader.h>
#include <talus/store/store_swap.h>

namespace talus::store {
namespace {

/// Requires `bytes` of free space: on a full disk RocksDB may abort the process.
tl::expected<OpenedRocks, std::string> open_to_write(const std::filesystem::path& path, std::uint64_t bytes) {
  if (const auto regular = check_regular_files(path / "db"); !regular) {
    return tl::unexpected{fmt::format("edits {}: {}", path.string(), regular.error())};
  }
  if (const auto enough = check_space(path, bytes); !enough) return tl::unexpected{enough.error()};
  auto opened = open_rocks(path, {}, RocksUse::write);
  if (!opened) return tl::unexpected{std::move(opened.error().line)};
  return *std::move(opened);
}

tl::unexpected<std::string> whole_failure(const std::filesystem::path& path, const rocksdb::Status& status) {
  return tl::unexpected{fmt::format("edits {}: {}", path.string(), status.ToString())};
}

/// Closes the database unless `done`, what was done with it, failed. Returns the first error.
rocksdb::Status close(const OpenedRocks& opened, rocksdb::Status done) {
  if (done.ok()) done = opened.db->Close();
  return opened.failure->is_set() ? opened.failure->get() : done;
}

/// Changes only the store's meta, and syncs.
template <typename Change>
tl::expected<StoreMeta, std::string> change_meta(const std::filesystem::path& path, const Change& change) {
  const auto db = open_to_write(path, 0);
  if (!db) return tl::unexpected{db.error()};
  const StoreReader reader{*db->db, path};
  const auto read = reader.meta();
  if (!read) return tl::unexpected{read.error()};
  if (!*read) {
    return reader.failure(fmt::format("its record of the store's state is missing; {}", kStoreLost));
  }
  StoreMeta meta = **read;
  change(meta);
  Bytes value;
  encode(meta, value);
  rocksdb::WriteOptions synced;
  synced.sync = true;
  const auto status = close(*db, db->db->Put(synced, meta_key(), as_slice(value)));
  if (!status.ok()) return whole_failure(path, status);
  return meta;
}

}  // namespace

tl::expected<std::filesystem::path, std::string> stage_copy(const std::filesystem::path& path) {
  const auto db = open_to_write(path, kCheckpointCopiesBytes);
  if (!db) return tl::unexpected{db.error()};
  auto staging = make_staging(path);
  if (!staging) return staging;
  rocksdb::Checkpoint* made = nullptr;
  rocksdb::Status status = rocksdb::Checkpoint::Create(db->db.get(), &made);
  const std::unique_ptr<rocksdb::Checkpoint> checkpoint{made};
  if (status.ok()) status = checkpoint->CreateCheckpoint((*staging / "db").string(), UINT64_MAX);
  status = close(*db, status);
  if (!status.ok()) return whole_failure(path, status);
  return staging;
}

tl::expected<void, std::string> give_identity(const std::filesystem::path& path, ContentHash store_id) {
  const auto meta = change_meta(path, [&](StoreMeta& changed) {
    changed.store_id = store_id;
    changed.stream = {};  // the store leaves its stream
  });
  if (!meta) return tl::unexpected{meta.error()};
  if (auto written = write_store_files(path, *meta); !written) return written;
  return sync_directory(path / "db");
}

tl::expected<void, std::string> enter_stream(const std::filesystem::path& path, const StreamPlace& place) {
  const auto meta = change_meta(path, [&](StoreMeta& changed) { changed.stream = place; });
  return meta ? tl::expected<void, std::string>{} : tl::unexpected{meta.error()};
}

tl::expected<void, std::string> compact(const std::filesystem::path& path) {
  const auto db =
      open_to_write(path, bytes_of_files(path / "db"));  // old files are deleted after the new ones exist
  if (!db) return tl::unexpected{db.error()};
  // Compaction drops the end of the log with its records, which would hide a loss: check first.
  const StoreReader reader{*db->db, path};
  const auto meta = reader.meta();
  if (!meta) return tl::unexpected{meta.error()};
  if (!*meta)
    return reader.failure(fmt::format("its record of the store's state is missing; {}", kStoreLost));
  if (const auto whole = check_whole_store(path, **meta); !whole) return whole;
  rocksdb::CompactRangeOptions all;
  all.bottommost_level_compaction = rocksdb::BottommostLevelCompaction::kForce;
  const auto status = close(*db, db->db->CompactRange(all, nullptr, nullptr));
  if (!status.ok()) return whole_failure(path, status);
  return {};
}

}  // namespace talus::store
