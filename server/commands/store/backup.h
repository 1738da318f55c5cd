// Backups of a store: its files as of one position, and a manifest of checksums that is written last. A
// directory without a manifest is not a backup.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/progress/progress_bar.h>
#include <talus/store/backup_manifest.h>
#include <talus/store/data_directory.h>
#include <talus/store/read_only_store.h>

namespace talus::server {

/// Copies the store in `path`, as of one moment, into `target`, which must be new or empty. If a server
/// writes the store, it must keep its files: EditDatabase::hold_files(). On error removes everything that it
/// created, or the error names what is left.
[[nodiscard]] tl::expected<store::BackupManifest, std::string> write_backup(
    const std::filesystem::path& path, const std::filesystem::path& target);

/// Reads a backup's manifest. The error says if `backup` is not a backup or is unfinished.
[[nodiscard]] tl::expected<store::BackupManifest, std::string> read_manifest(
    const std::filesystem::path& backup);

struct RestoreResult {
  store::BackupManifest manifest;
  ContentHash store_id;
  std::filesystem::path replaced;  // where the previous store is kept; empty: there was none
};
/// Verifies every byte of the backup, then puts it into `directory` as a store with a new id. An existing
/// store is an error, or, with `replace`, moved aside.
[[nodiscard]] tl::expected<RestoreResult, std::string> restore_backup(const std::filesystem::path& backup,
                                                                      const store::DataDirectory& directory,
                                                                      bool replace);

}  // namespace talus::server
