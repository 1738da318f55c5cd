// Backups of a store: its files as of one position, with a manifest of their checksums, which is written
// last. A directory without one is no backup.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/progress/progress_bar.h>
#include <talus/store/backup_manifest.h>
#include <talus/store/data_directory.h>
#include <talus/store/read_only_store.h>

namespace talus::server {

/// Of the store whose files are in `path`, of one moment, into `target`, which is new or empty. While a
/// server writes them none may be removed: EditDatabase::hold_files(). After an error nothing is left that
/// was not there before, or the error says where.
[[nodiscard]] tl::expected<store::BackupManifest, std::string> write_backup(
    const std::filesystem::path& path, const std::filesystem::path& target);

/// That of a backup; says so where `backup` is none, or was not finished.
[[nodiscard]] tl::expected<store::BackupManifest, std::string> read_manifest(
    const std::filesystem::path& backup);

struct Restored {
  store::BackupManifest manifest;
  ContentHash store_id;
  std::filesystem::path replaced;  // where the store is that was there; empty: there was none
};
/// Puts the backup into `directory`, as a store of a new id, when every byte of it was verified. A store that
/// is there is refused, or with `replace` moved aside.
[[nodiscard]] tl::expected<Restored, std::string> restore_backup(const std::filesystem::path& backup,
                                                                 const store::DataDirectory& directory,
                                                                 bool replace);

}  // namespace talus::server
