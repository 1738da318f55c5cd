#include "cluster/checkpoint/take_checkpoint.h"

#include <algorithm>
#include <memory>
#include <new>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <xxhash.h>

#include <talus/edits/state_hash.h>
#include <talus/files/atomic_file.h>
#include <talus/store/acknowledged_file.h>
#include <talus/store/backup_manifest.h>
#include <talus/store/read_only_store.h>
#include <talus/store/store_identity.h>
#include <talus/store/store_swap.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;
using Status = tl::expected<void, std::string>;

/// RocksDB's tables have 64 MiB, a few of them less; the newest tables and the log are some dozens of files.
/// A store of 10 GiB may have fewer than 3,000 files by this bound, each costing two syncs.
constexpr std::size_t kFilesOfAny = 300;
constexpr std::uint64_t kBytesPerFile = std::uint64_t{4} << 20U;
constexpr std::uint64_t kMaxSmallFileBytes = 4'096;  // store.toml and acknowledged
constexpr std::string_view kIdentityName = "store.toml";

bool has_digits_alone(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// True for names of files that RocksDB has in a checkpoint.
bool is_database_file(std::string_view name) {
  if (name == "CURRENT" || name == "IDENTITY") return true;
  for (const std::string_view first : {"MANIFEST-", "OPTIONS-"}) {
    if (name.starts_with(first)) return has_digits_alone(name.substr(first.size()));
  }
  for (const std::string_view last : {".sst", ".log"}) {
    if (name.ends_with(last)) return has_digits_alone(name.substr(0, name.size() - last.size()));
  }
  return false;
}

/// `name` includes the directory.
bool is_checkpoint_file(std::string_view name) {
  constexpr std::string_view kDatabase = "db/";
  if (name.starts_with(kDatabase)) return is_database_file(name.substr(kDatabase.size()));
  return name == store::kManifestName || store::is_store_file(name);
}

tl::unexpected<std::string> no_checkpoint(std::string_view why) {
  return tl::unexpected{fmt::format("its answer is not a checkpoint: {}", why)};
}

/// Makes libarchive read from a TarSource; accepts only uncompressed tar.
class TarReader {
 public:
  TarReader(TarSource& source, const OnTaken& on_taken)
      : source_{source}, on_taken_{on_taken}, archive_{::archive_read_new(), ::archive_read_free} {
    if (archive_ == nullptr) throw std::bad_alloc{};
    ::archive_read_support_format_tar(archive_.get());
    opened_ = ::archive_read_open(archive_.get(), this, nullptr, &TarReader::give, nullptr) == ARCHIVE_OK;
  }

  /// Name and size of the next file; nullopt at the end. Rejects everything but regular files.
  struct Entry {
    std::string name;
    std::uint64_t bytes = 0;
  };
  [[nodiscard]] tl::expected<std::optional<Entry>, std::string> next() {
    archive_entry* entry = nullptr;
    const int result = opened_ ? ::archive_read_next_header(archive_.get(), &entry) : ARCHIVE_FATAL;
    if (result == ARCHIVE_EOF) return std::nullopt;
    if (result != ARCHIVE_OK) return failure();
    const char* const name = ::archive_entry_pathname(entry);
    if (name == nullptr) return no_checkpoint("a file in it has no name");
    if (::archive_entry_filetype(entry) != AE_IFREG || ::archive_entry_hardlink(entry) != nullptr ||
        ::archive_entry_symlink(entry) != nullptr || ::archive_entry_sparse_count(entry) != 0) {
      return no_checkpoint(fmt::format(
          "\"{}\" in it is a link, a directory or a device; a store has regular files", escaped(name)));
    }
    if (::archive_entry_size_is_set(entry) == 0 || ::archive_entry_size(entry) < 0) {
      return no_checkpoint(fmt::format("\"{}\" in it has no size", escaped(name)));
    }
    return Entry{name, static_cast<std::uint64_t>(::archive_entry_size(entry))};
  }
  /// Next bytes of the file; empty at its end.
  [[nodiscard]] tl::expected<std::span<const std::byte>, std::string> read(std::uint64_t at) {
    const void* bytes = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    do {
      const int result = ::archive_read_data_block(archive_.get(), &bytes, &size, &offset);
      if (result == ARCHIVE_EOF) return std::span<const std::byte>{};
      if (result != ARCHIVE_OK) return failure();
    } while (size == 0);
    if (offset != static_cast<la_int64_t>(at)) return no_checkpoint("a file in it has holes");
    return std::span{static_cast<const std::byte*>(bytes), size};
  }

 private:
  static la_ssize_t give(archive*, void* of, const void** bytes) {
    auto& reader = *static_cast<TarReader*>(of);
    auto read = reader.source_.read();
    if (!read) {
      reader.source_error_ = std::move(read.error());
      return -1;
    }
    *bytes = read->data();
    reader.given_ += read->size();
    reader.on_taken_(reader.given_);
    return static_cast<la_ssize_t>(read->size());
  }
  [[nodiscard]] tl::unexpected<std::string> failure() const {
    if (!source_error_.empty()) return tl::unexpected{source_error_};
    const char* const said = ::archive_error_string(archive_.get());
    return no_checkpoint(said == nullptr ? "it is damaged" : on_one_line(said));
  }

  TarSource& source_;
  const OnTaken& on_taken_;
  std::uint64_t given_ = 0;
  std::string source_error_;
  bool opened_ = false;
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

class CheckpointReceiver {
 public:
  CheckpointReceiver(TarSource& source, const fs::path& staging, const WantedStore& wanted,
                     const OnTaken& on_taken)
      : tar_{source, on_taken},
        left_{source.size()},
        max_files_{kFilesOfAny + static_cast<std::size_t>(source.size() / kBytesPerFile)},
        staging_{staging},
        wanted_{wanted} {}

  [[nodiscard]] tl::expected<store::StoreMeta, std::string> take() {
    if (auto enough = store::check_space(staging_, left_); !enough) return tl::unexpected{enough.error()};
    std::error_code code;
    fs::create_directory(staging_ / "db", code);
    if (code) return tl::unexpected{fmt::format("{}: {}", staging_.string(), code.message())};
    for (;;) {
      auto entry = tar_.next();
      if (!entry) return tl::unexpected{std::move(entry.error())};
      if (!*entry) break;
      if (auto taken = take_entry(**entry); !taken) return tl::unexpected{std::move(taken.error())};
    }
    if (auto right = check_manifest(); !right) return tl::unexpected{std::move(right.error())};
    if (auto synced = store::sync_directory(staging_ / "db"); !synced)
      return tl::unexpected{std::move(synced.error())};
    return check_store();
  }

 private:
  [[nodiscard]] Status take_entry(const TarReader::Entry& entry) {
    const bool is_manifest = entry.name == store::kManifestName;
    if (!is_checkpoint_file(entry.name)) {
      return no_checkpoint(fmt::format("a store has no file \"{}\"", escaped(entry.name)));
    }
    if (files_.empty() && entry.name != kIdentityName) {
      return no_checkpoint(fmt::format("its first file is \"{}\", not {}", entry.name, kIdentityName));
    }
    if (!manifest_.empty()) return no_checkpoint(fmt::format("\"{}\" follows its manifest", entry.name));
    if (files_.size() >= max_files_) {
      return no_checkpoint(fmt::format("it has over {} files, more than its size needs", max_files_));
    }
    if (!names_.insert(entry.name).second) {
      return no_checkpoint(fmt::format("it has \"{}\" twice", entry.name));
    }
    const bool is_small = !is_manifest && !entry.name.starts_with("db/");
    if (entry.bytes > left_ || (is_small && entry.bytes > kMaxSmallFileBytes) ||
        (is_manifest && entry.bytes > store::kMaxManifestBytes)) {
      return no_checkpoint(
          fmt::format("\"{}\" in it has {} bytes, more than it may", entry.name, entry.bytes));
    }
    left_ -= entry.bytes;
    if (is_manifest) return read_manifest_text();
    if (auto written = write_entry(entry); !written) return written;
    return entry.name == kIdentityName ? check_identity() : Status{};
  }

  [[nodiscard]] Status read_manifest_text() {
    for (;;) {
      const auto piece = tar_.read(manifest_.size());
      if (!piece) return tl::unexpected{piece.error()};
      if (piece->empty()) break;
      manifest_.append(reinterpret_cast<const char*>(piece->data()), piece->size());
    }
    return manifest_.empty() ? no_checkpoint("its manifest is empty") : Status{};
  }

  [[nodiscard]] Status write_entry(const TarReader::Entry& entry) {
    auto file = files::AtomicFile::create(staging_ / entry.name);
    if (!file) return tl::unexpected{file.error().message()};
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state{XXH3_createState(),
                                                                                XXH3_freeState};
    if (state == nullptr) throw std::bad_alloc{};
    XXH3_128bits_reset(state.get());
    std::uint64_t written = 0;
    for (;;) {
      const auto piece = tar_.read(written);
      if (!piece) return tl::unexpected{piece.error()};
      if (piece->empty()) break;
      XXH3_128bits_update(state.get(), piece->data(), piece->size());
      if (auto done = file->write_at(written, *piece); !done) return tl::unexpected{done.error().message()};
      written += piece->size();
    }
    if (written != entry.bytes) return no_checkpoint(fmt::format("\"{}\" in it is cut", entry.name));
    if (auto done = file->commit(); !done) return tl::unexpected{done.error().message()};
    const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
    files_.push_back({entry.name, written, {hash.low64, hash.high64}});
    return {};
  }

  /// Checked before the rest is downloaded.
  [[nodiscard]] Status check_identity() {
    const auto read = store::read_store_identity(staging_ / kIdentityName);
    if (!read) return no_checkpoint("its store.toml was not written by talusd");
    identity_ = *read;
    if (identity_.fingerprint != wanted_.fingerprint) {
      return tl::unexpected{
          fmt::format("its store is of the world with fingerprint {}; this world has {}; give both the same "
                      "--world and secret.key_file",
                      to_string(identity_.fingerprint), to_string(wanted_.fingerprint))};
    }
    if (wanted_.store_id && identity_.store_id != *wanted_.store_id) {
      return tl::unexpected{
          fmt::format("it has store {}; this server wants {}; see cluster.peers and cluster.store",
                      to_string(identity_.store_id), to_string(*wanted_.store_id))};
    }
    return {};
  }

  [[nodiscard]] Status check_manifest() {
    if (manifest_.empty()) return no_checkpoint("it ends before its manifest");
    auto decoded = store::decode_manifest(manifest_);
    if (!decoded) return no_checkpoint(decoded.error());
    listed_ = *std::move(decoded);
    if (listed_.identity != identity_) return no_checkpoint("its manifest is of another store");
    if (listed_.files == files_) return {};
    const auto [listed, come] = std::ranges::mismatch(listed_.files, files_);
    return no_checkpoint(fmt::format("\"{}\" in it differs from its manifest",
                                     come == files_.end() ? listed->name : come->name));
  }

  [[nodiscard]] tl::expected<store::StoreMeta, std::string> check_store() {
    const auto store = store::ReadOnlyStore::open(staging_);
    if (!store) return tl::unexpected{store.error()};
    const store::StoreMeta meta = (*store)->meta();
    if (store::StoreIdentity{meta.store_id, meta.fingerprint} != identity_ || meta.head != listed_.head) {
      return no_checkpoint("its database differs from its manifest");
    }
    if (meta.level_rule != edits::kLevelRule) {
      return tl::unexpected{
          fmt::format("its coarse levels were made by rule {}; this talusd has rule {}; let both "
                      "be of one version",
                      meta.level_rule, edits::kLevelRule)};
    }
    if (auto right = check_place(meta.stream); !right) return tl::unexpected{std::move(right.error())};
    if (auto whole = store::check_acknowledged(staging_, meta); !whole) return tl::unexpected{whole.error()};
    edits::StateHash hash;
    const auto visited =
        (*store)->for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
          hash.add(chunk, stored.voxels);
          return true;
        });
    if (!visited) return tl::unexpected{visited.error()};
    if (hash != meta.head.hash) {
      return no_checkpoint(fmt::format("its edits have hash {}, not {}", edits::to_string(hash),
                                       edits::to_string(meta.head.hash)));
    }
    if (auto sound = (*store)->verify_files(); !sound) return tl::unexpected{std::move(sound.error())};
    return meta;
  }

  [[nodiscard]] Status check_place(const store::StreamPlace& has) const {
    if (!wanted_.place) return {};
    if (has.sequence == 0) return tl::unexpected{std::string{"its store is not in a cluster"}};
    if (wanted_.place->created_ns != 0 && has.created_ns != wanted_.place->created_ns) {
      return tl::unexpected{std::string{"its store is of another stream, which was lost or made anew"}};
    }
    if (has.sequence + 1 >= wanted_.place->first) return {};
    return tl::unexpected{
        fmt::format("its store has read the stream up to message {}, and the stream now begins with {}",
                    has.sequence, wanted_.place->first)};
  }

  TarReader tar_;
  std::uint64_t left_;  // announced bytes not received yet
  const std::size_t max_files_;
  const fs::path& staging_;
  const WantedStore& wanted_;
  store::StoreIdentity identity_;
  std::set<std::string, std::less<>> names_;
  std::vector<store::BackupManifest::File> files_;
  std::string manifest_;
  store::BackupManifest listed_;
};

}  // namespace

tl::expected<store::StoreMeta, std::string> take_checkpoint(TarSource& source, const fs::path& staging,
                                                            const WantedStore& wanted,
                                                            const OnTaken& on_taken) {
  return CheckpointReceiver{source, staging, wanted, on_taken}.take();
}

}  // namespace talus::server
