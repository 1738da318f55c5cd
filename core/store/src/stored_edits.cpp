#include <talus/store/stored_edits.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <talus/store/id_check.h>
#include <talus/store/store_identity.h>

namespace talus::store {
namespace {

namespace fs = std::filesystem;

ChunkKey column_of(ChunkKey key) {
  return {{key.coord.x, 0, key.coord.z}, key.lod};
}

/// Returns an error text if the store's identity is not of this world.
std::optional<std::string> check_identity(const fs::path& directory, ContentHash fingerprint) {
  std::error_code error;
  if (!fs::exists(directory / "store.toml", error)) {
    return fmt::format(
        "store {}: it has no store.toml; give --store a directory that talusd was given as --data, or a "
        "backup of one",
        directory.string());
  }
  if (!fs::exists(directory / "lock", error) && !fs::exists(directory / "manifest", error)) {
    return fmt::format(
        "store {}: it is a backup without its manifest, so one that was not finished; make another",
        directory.string());
  }
  if (fs::exists(directory / "talus-next", error)) {
    return fmt::format("store {}: another store was being put in its place; let talusd open it once",
                       directory.string());
  }
  const auto identity = read_store_identity(directory / "store.toml");
  if (!identity) return identity.error();
  if (identity->fingerprint == fingerprint) return std::nullopt;
  return fmt::format(
      "store {}: it belongs to the world with fingerprint {}; this world has fingerprint {}; give --world "
      "the "
      "store's world",
      directory.string(), to_string(identity->fingerprint), to_string(fingerprint));
}

}  // namespace

tl::expected<std::unique_ptr<StoredEdits>, std::string> StoredEdits::open(const fs::path& directory,
                                                                          ContentHash fingerprint) {
  const int lock = ::open((directory / "lock").c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (lock < 0 && errno != ENOENT && errno != ENOTDIR) {
    return tl::unexpected{
        fmt::format("store {}: cannot open its lock: {}; run this as a user who may read it",
                    directory.string(), std::generic_category().message(errno))};
  }
  std::unique_ptr<StoredEdits> edits{new StoredEdits{lock}};
  if (lock >= 0 && ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno != EWOULDBLOCK) {
    return tl::unexpected{fmt::format("store {}: cannot lock its lock: {}; copy it to a local disk",
                                      directory.string(), std::generic_category().message(errno))};
  }
  if (lock >= 0 && ::flock(lock, LOCK_SH | LOCK_NB) != 0) {
    return tl::unexpected{
        fmt::format("store {}: a talusd uses it; stop that, or let `talusd store backup` make a copy, and "
                    "give --store the "
                    "copy",
                    directory.string())};
  }
  if (auto wrong = check_identity(directory, fingerprint)) return tl::unexpected{*std::move(wrong)};
  auto store = ReadOnlyStore::open(directory);
  if (!store) return tl::unexpected{std::move(store.error())};
  edits->store_ = *std::move(store);
  auto done = check_whole_store(directory, edits->store_->meta());
  if (!done) return tl::unexpected{std::move(done.error())};
  done = edits->store_->for_each_chunk([&](ChunkKey key, const StoredChunk&) {
    const auto [at, added] = edits->rows_.try_emplace(column_of(key), ChunkRange{key.coord.y, key.coord.y});
    at->second.first = std::min<std::int64_t>(at->second.first, key.coord.y);
    at->second.last = std::max<std::int64_t>(at->second.last, key.coord.y);
    return true;
  });
  if (!done) return tl::unexpected{std::move(done.error())};
  return edits;
}

StoredEdits::~StoredEdits() {
  store_.reset();
  if (lock_ >= 0) ::close(lock_);
}

ChunkRange StoredEdits::edited_rows(ChunkKey key) const {
  const auto found = rows_.find(column_of(key));
  return found == rows_.end() ? ChunkRange{} : found->second;
}

tl::expected<edits::ChunkOverrides, std::string> StoredEdits::overrides(ChunkKey key) const {
  if (!edited_rows(key).contains(key.coord.y)) return edits::ChunkOverrides{};
  auto chunk = store_->chunk(key);
  if (!chunk) return tl::unexpected{std::move(chunk.error())};
  if (!*chunk) return edits::ChunkOverrides{};
  return edits::ChunkOverrides{std::move((*chunk)->voxels)};
}

}  // namespace talus::store
