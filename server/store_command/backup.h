// Backups of a store: its files as of one position, with a manifest of their checksums, which is written
// last. A directory without one is no backup.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>
#include <talus/progress/progress_bar.h>

#include "store/data_directory.h"
#include "store/read_only_store.h"

namespace talus::server {

/// FORMAT.md of this folder has every byte.
struct BackupManifest {
  struct File {
    std::string name;  // "db/000012.sst"
    std::uint64_t bytes = 0;
    ContentHash hash;  // XXH3-128 of its bytes
    bool operator==(const File&) const = default;
  };
  StoreIdentity identity;
  edits::Head head;
  std::vector<File> files;

  /// Where it is more than the type holds: the most that it does.
  [[nodiscard]] std::uint64_t bytes() const;
  bool operator==(const BackupManifest&) const = default;
};

[[nodiscard]] std::string encode(const BackupManifest& manifest);
/// An error is one line. Any text is safe; a name that leads out of the backup is an error.
[[nodiscard]] tl::expected<BackupManifest, std::string> decode_manifest(std::string_view text);

/// Of the store whose files are in `path`, of one moment, into `target`, which is new or empty. While a
/// server writes them none may be removed: EditDatabase::hold_files().
[[nodiscard]] tl::expected<BackupManifest, std::string> write_backup(const std::filesystem::path& path,
                                                                     const std::filesystem::path& target);

/// That of a backup; says so where `backup` is none, or was not finished.
[[nodiscard]] tl::expected<BackupManifest, std::string> read_manifest(const std::filesystem::path& backup);

struct Restored {
  BackupManifest manifest;
  ContentHash store_id;
  std::filesystem::path replaced;  // where the store is that was there; empty: there was none
};
/// Puts the backup into `directory`, as a store of a new id, when every byte of it was verified. A store that
/// is there is refused, or with `replace` moved aside.
[[nodiscard]] tl::expected<Restored, std::string> restore_backup(const std::filesystem::path& backup,
                                                                 const DataDirectory& directory,
                                                                 bool replace);

}  // namespace talus::server
