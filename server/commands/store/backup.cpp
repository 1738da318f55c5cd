#include "commands/store/backup.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>
#include <talus/store/store_builder.h>
#include <talus/store/store_swap.h>
#include <talus/store/whole_store.h>

#include "commands/store/copied_file.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> no_backup(const fs::path& path, std::string_view why) {
  return tl::unexpected{fmt::format("backup {}: {}", path.string(), why)};
}

/// True for database files that list other files.
bool lists_files(std::string_view name) {
  return name == "db/CURRENT" || name.starts_with("db/MANIFEST-");
}

/// Lists the store's database files, the newest log last; hashes are not set yet.
tl::expected<std::vector<store::BackupManifest::File>, std::string> database_files(const fs::path& path) {
  std::vector<store::BackupManifest::File> files;
  std::error_code code;
  for (fs::directory_iterator at{path / "db", code}, end; !code && at != end; at.increment(code)) {
    const std::string name = "db/" + at->path().filename().string();
    // These are temporary.
    if (at->path().filename() == "LOCK" || name.ends_with(".dbtmp") || !store::is_store_file(name)) continue;
    files.push_back({name, at->file_size(code), {}});
  }
  if (code) return no_backup(path, code.message());
  std::ranges::sort(files, {}, [](const store::BackupManifest::File& file) {
    return std::pair{file.name.ends_with(".log"), std::string_view{file.name}};
  });
  return files;
}

/// Copies the database of `path` into `target`, and returns its files with checksums; nullopt if a file
/// vanished after it was listed.
tl::expected<std::optional<std::vector<store::BackupManifest::File>>, std::string> copy_database(
    const fs::path& path, const fs::path& target, ProgressBar& progress) {
  std::vector<store::BackupManifest::File> all;
  // A server may write meanwhile, so the files that list others are copied first: the files that they list
  // exist when the rest is listed.
  for (const bool lists : {true, false}) {
    auto found = database_files(path);
    if (!found) return tl::unexpected{found.error()};
    for (store::BackupManifest::File& file : *found) {
      if (lists_files(file.name) != lists) continue;
      const auto copied = copy_file(path / file.name, target / file.name, UINT64_MAX, progress);
      if (!copied) {
        std::error_code code;
        if (!fs::exists(path / file.name, code) && !code) return std::nullopt;
        return tl::unexpected{copied.error()};
      }
      file.bytes = copied->bytes;
      file.hash = copied->hash;
      all.push_back(std::move(file));
    }
  }
  return all;
}

/// Returns the directory that holds `path`.
fs::path parent_of(const fs::path& path) {
  const fs::path absolute = fs::absolute(path).lexically_normal();
  return absolute.has_filename() ? absolute.parent_path() : absolute.parent_path().parent_path();
}

/// Deletes an unfinished backup from a directory that was empty, and the directory if it is new. Returns the
/// end of an error line if something is left.
std::string remove_unfinished(const fs::path& target, bool is_new) {
  std::error_code code;
  for (const std::string_view name : {store::kManifestName, std::string_view{"store.toml"},
                                      std::string_view{"acknowledged"}, std::string_view{"db"}}) {
    fs::remove_all(target / name, code);
  }
  if (is_new) fs::remove(target, code);
  const bool stays = is_new ? fs::exists(target, code) : !fs::is_empty(target, code);
  return stays ? fmt::format("; the files left in {} are not a backup, and may be removed", target.string())
               : "";
}

/// `target` must exist and be empty.
tl::expected<store::BackupManifest, std::string> fill_backup(const fs::path& path, const fs::path& target) {
  std::error_code code;
  fs::create_directory(target / "db", code);
  if (code) return no_backup(target, code.message());
  const auto found = database_files(path);
  if (!found) return tl::unexpected{found.error()};
  std::uint64_t bytes = 0;
  for (const store::BackupManifest::File& file : *found) bytes += file.bytes;
  if (const auto enough = store::check_space(target, bytes); !enough) return tl::unexpected{enough.error()};
  ProgressBar progress{"backup", "bytes"};
  progress.expect(bytes);
  store::BackupManifest manifest;
  // A file that the server had dropped before its files were held may still vanish.
  constexpr int kTries = 10;
  for (int tries = 1;; ++tries) {
    auto copied = copy_database(path, target, progress);
    if (!copied) return tl::unexpected{std::move(copied.error())};
    if (*copied) {
      manifest.files = **std::move(copied);
      break;
    }
    if (tries == kTries) return no_backup(path, "its files go while they are copied; try again");
    fs::remove_all(target / "db", code);
    fs::create_directories(target / "db", code);
    if (code) return no_backup(target, code.message());
  }
  {
    const auto store = store::ReadOnlyStore::open(target);
    if (!store) return tl::unexpected{store.error()};
    const store::StoreMeta& meta = (*store)->meta();
    manifest.identity = {meta.store_id, meta.fingerprint};
    manifest.head = meta.head;
    if (const auto written = store::write_store_files(target, meta); !written) {
      return tl::unexpected{written.error()};
    }
  }
  std::ranges::sort(manifest.files, {}, &store::BackupManifest::File::name);
  for (const char* const name : {"acknowledged", "store.toml"}) {
    const auto read = hash_file(target / name, progress);
    if (!read) return tl::unexpected{read.error()};
    manifest.files.push_back({name, read->bytes, read->hash});
  }
  if (const auto synced = store::sync_directory(target / "db"); !synced)
    return tl::unexpected{synced.error()};
  // The manifest makes it a backup.
  if (const auto written =
          files::write_file(target / store::kManifestName, std::string_view{encode(manifest)});
      !written) {
    return tl::unexpected{written.error().message()};
  }
  return manifest;
}

}  // namespace

tl::expected<store::BackupManifest, std::string> write_backup(const fs::path& path, const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code) && !fs::is_empty(target, code)) {
    return no_backup(target,
                     code ? code.message() : "the directory is not empty; give one that is, or a new name");
  }
  // Does not make it: a missing directory is mostly the mount point of a disk.
  if (const fs::path parent = parent_of(target); !fs::is_directory(parent, code)) {
    return no_backup(target,
                     fmt::format("{} is not a directory; make it, or mount its disk", parent.string()));
  }
  {
    const auto store = store::ReadOnlyStore::open(path);
    if (!store) return tl::unexpected{store.error()};
    if (const auto sound = (*store)->verify_files(); !sound) return tl::unexpected{sound.error()};
  }
  const bool is_new = fs::create_directory(target, code);
  tl::expected<store::BackupManifest, std::string> written = no_backup(target, code.message());
  if (!code) written = fill_backup(path, target);
  if (!written) written.error() += remove_unfinished(target, is_new);
  return written;
}

tl::expected<store::BackupManifest, std::string> read_manifest(const fs::path& backup) {
  std::error_code code;
  if (!fs::is_directory(backup, code)) return no_backup(backup, "the directory does not exist");
  if (fs::is_symlink(backup / "db", code)) return no_backup(backup, "db is a link; give another one");
  if (!fs::exists(backup / store::kManifestName, code)) {
    return no_backup(backup, "it has no manifest: it is not a backup, or was not finished; give another one");
  }
  const auto text = files::read_regular_file(backup / store::kManifestName, store::kMaxManifestBytes);
  if (!text) return tl::unexpected{text.error().message()};
  auto manifest = store::decode_manifest(*text);
  if (!manifest) return no_backup(backup, fmt::format("{}; give another one", manifest.error()));
  return manifest;
}

tl::expected<RestoreResult, std::string> restore_backup(const fs::path& backup,
                                                        const store::DataDirectory& directory, bool replace) {
  auto manifest = read_manifest(backup);
  if (!manifest) return tl::unexpected{manifest.error()};
  if (directory.has_store() && !replace) {
    return tl::unexpected{
        fmt::format("data {}: it holds a store; give --replace to move that aside, or another --data",
                    directory.path().string())};
  }
  if (const auto enough = store::check_space(directory.path(), manifest->bytes()); !enough) {
    return tl::unexpected{enough.error()};
  }
  const auto staging = store::make_staging(directory.path());
  if (!staging) return tl::unexpected{staging.error()};
  std::error_code code;
  fs::create_directory(*staging / "db", code);
  if (code) return tl::unexpected{fmt::format("{}: {}", staging->string(), code.message())};
  ProgressBar progress{"restore", "bytes"};
  progress.expect(manifest->bytes());
  for (const store::BackupManifest::File& file : manifest->files) {
    const auto copied = copy_file(backup / file.name, *staging / file.name, file.bytes, progress);
    if (!copied) return tl::unexpected{copied.error()};
    if (!copied->all || copied->bytes != file.bytes || copied->hash != file.hash) {
      return no_backup(
          backup, fmt::format("{} is damaged: it differs from its manifest; give another one", file.name));
    }
  }
  // An older talusd may have backed up a damaged store.
  const auto copied = store::ReadOnlyStore::open(backup);
  if (!copied) return tl::unexpected{copied.error()};
  if (const auto sound = (*copied)->verify_files(); !sound) return tl::unexpected{sound.error()};
  {
    const auto store = store::ReadOnlyStore::open(*staging);
    if (!store) return tl::unexpected{store.error()};
    if ((*store)->meta().head != manifest->head) {
      return no_backup(backup, "its database is not at its manifest's position; give another one");
    }
  }
  const ContentHash id = store::random_store_id();
  if (const auto given = store::give_identity(*staging, id); !given) return tl::unexpected{given.error()};
  auto replaced = store::swap_in(directory.path());
  if (!replaced) return tl::unexpected{replaced.error()};
  return RestoreResult{*std::move(manifest), id, *std::move(replaced)};
}

}  // namespace talus::server
