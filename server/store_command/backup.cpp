#include "store_command/backup.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>

#include "store/store_builder.h"
#include "store/store_swap.h"
#include "store/whole_store.h"
#include "store_command/copied_file.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> no_backup(const fs::path& path, std::string_view why) {
  return tl::unexpected{fmt::format("backup {}: {}", path.string(), why)};
}

}  // namespace

tl::expected<BackupManifest, std::string> write_backup(const ReadOnlyStore& store, const fs::path& path,
                                                       const fs::path& target) {
  std::error_code code;
  if (fs::exists(target, code) && !fs::is_empty(target, code)) {
    return no_backup(target,
                     code ? code.message() : "the directory is not empty; give one that is, or a new name");
  }
  fs::create_directories(target / "db", code);
  if (code) return no_backup(target, code.message());
  const StoreMeta& meta = store.meta();
  BackupManifest manifest{{meta.store_id, meta.fingerprint}, meta.head, {}};
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator{path / "db", code}) {
    const std::string name = "db/" + entry.path().filename().string();
    if (entry.path().filename() == "LOCK" || !is_store_file(name)) continue;
    manifest.files.push_back({name, entry.file_size(code), {}});
    bytes += manifest.files.back().bytes;
  }
  if (code) return no_backup(path, code.message());
  if (const auto enough = check_space(target, bytes); !enough) return tl::unexpected{enough.error()};
  std::ranges::sort(manifest.files, {}, &BackupManifest::File::name);
  if (const auto written = write_store_files(target, meta); !written) return tl::unexpected{written.error()};
  ProgressBar progress{"backup", "bytes"};
  progress.expect(bytes);
  for (BackupManifest::File& file : manifest.files) {
    const auto copied = copy_file(path / file.name, target / file.name, progress);
    if (!copied) return tl::unexpected{copied.error()};
    file.bytes = copied->bytes;
    file.hash = copied->hash;
  }
  for (const char* const name : {"acknowledged", "store.toml"}) {
    const auto read = hash_file(target / name, progress);
    if (!read) return tl::unexpected{read.error()};
    manifest.files.push_back({name, read->bytes, read->hash});
  }
  if (const auto synced = sync_directory(target / "db"); !synced) return tl::unexpected{synced.error()};
  // From here on it is a backup.
  if (const auto written = files::write_file(target / kManifestName, std::string_view{encode(manifest)});
      !written) {
    return tl::unexpected{written.error().message()};
  }
  return manifest;
}

tl::expected<BackupManifest, std::string> read_manifest(const fs::path& backup) {
  std::error_code code;
  if (!fs::is_directory(backup, code)) return no_backup(backup, "there is no such directory");
  if (!fs::exists(backup / kManifestName, code)) {
    return no_backup(backup, "it has no manifest: it is no backup, or was not finished; give another one");
  }
  const auto text = files::read_regular_file(backup / kManifestName, kMaxManifestBytes);
  if (!text) return tl::unexpected{text.error().message()};
  auto manifest = decode_manifest(*text);
  if (!manifest) return no_backup(backup, fmt::format("{}; give another one", manifest.error()));
  return manifest;
}

tl::expected<Restored, std::string> restore_backup(const fs::path& backup, const DataDirectory& directory,
                                                   bool replace) {
  auto manifest = read_manifest(backup);
  if (!manifest) return tl::unexpected{manifest.error()};
  if (directory.has_store() && !replace) {
    return tl::unexpected{
        fmt::format("data {}: it holds a store; give --replace to move that aside, or another --data",
                    directory.path().string())};
  }
  if (const auto enough = check_space(directory.path(), manifest->bytes()); !enough) {
    return tl::unexpected{enough.error()};
  }
  const auto staging = make_staging(directory.path());
  if (!staging) return tl::unexpected{staging.error()};
  std::error_code code;
  fs::create_directory(*staging / "db", code);
  if (code) return tl::unexpected{fmt::format("{}: {}", staging->string(), code.message())};
  ProgressBar progress{"restore", "bytes"};
  progress.expect(manifest->bytes());
  for (const BackupManifest::File& file : manifest->files) {
    const auto copied = copy_file(backup / file.name, *staging / file.name, progress);
    if (!copied) return tl::unexpected{copied.error()};
    if (copied->bytes != file.bytes || copied->hash != file.hash) {
      return no_backup(
          backup,
          fmt::format("{} is damaged: it is not what its manifest says; give another one", file.name));
    }
  }
  {
    const auto store = ReadOnlyStore::open(*staging);
    if (!store) return tl::unexpected{store.error()};
    if ((*store)->meta().head != manifest->head) {
      return no_backup(backup,
                       "its database is not at the position that its manifest says; give another one");
    }
  }
  const ContentHash id = random_store_id();
  if (const auto given = give_identity(*staging, id); !given) return tl::unexpected{given.error()};
  if (const auto synced = sync_directory(*staging / "db"); !synced) return tl::unexpected{synced.error()};
  auto replaced = swap_in(directory.path());
  if (!replaced) return tl::unexpected{replaced.error()};
  return Restored{*std::move(manifest), id, *std::move(replaced)};
}

}  // namespace talus::server
