// A store's files as a tar, piece by piece: what another server takes over the network. Unpacked it is a
// backup as `talusd store backup` writes it.
//
// store.toml comes first, so that who takes it sees early whose it is; the manifest with the checksums last,
// so that each file is read once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/store/backup_manifest.h>

namespace talus::server {

class CheckpointTar {
 public:
  /// Takes the directory over, and removes it when it is sent, or given up. It has db, of which nobody
  /// changes a file. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<CheckpointTar>, std::string> open(
      std::filesystem::path directory);
  ~CheckpointTar();
  CheckpointTar(const CheckpointTar&) = delete;
  CheckpointTar& operator=(const CheckpointTar&) = delete;

  /// Of the tar.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Where the store stands that is sent.
  [[nodiscard]] const edits::Head& head() const { return manifest_.head; }

  /// Reads from the disk, and returns some 256 KiB, valid until the next call; empty at the end. An error is
  /// one line.
  [[nodiscard]] tl::expected<std::string_view, std::string> next();

 private:
  class Writer;
  class InputFile;

  explicit CheckpointTar(std::filesystem::path directory);
  [[nodiscard]] tl::expected<void, std::string> list_files();
  [[nodiscard]] tl::expected<void, std::string> begin_file();
  [[nodiscard]] tl::expected<void, std::string> read_piece();
  void remove_directory();

  std::filesystem::path directory_;
  store::BackupManifest manifest_;  // hashes only of what was read
  std::uint64_t size_ = 0;
  std::size_t next_file_ = 0;  // of manifest_.files
  bool ended_ = false;
  std::unique_ptr<InputFile> file_;  // null: between two
  std::string piece_;
  std::unique_ptr<Writer> writer_;  // into piece_, also when it is destroyed
};

/// How long a tar of such files is.
[[nodiscard]] std::uint64_t tar_bytes(const store::BackupManifest& manifest);

}  // namespace talus::server
