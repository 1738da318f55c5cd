// Streams a store's files as a tar to another server. Unpacked it is a backup like those of `talusd store
// backup`.
//
// store.toml comes first, so that the receiver can check the store's identity early; the manifest with the
// checksums comes last, so that each file is read once.
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
  /// Takes ownership of the directory, and deletes it when it is sent or abandoned. It contains db, whose
  /// files must not change. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<CheckpointTar>, std::string> open(
      std::filesystem::path directory);
  ~CheckpointTar();
  CheckpointTar(const CheckpointTar&) = delete;
  CheckpointTar& operator=(const CheckpointTar&) = delete;

  /// Size of the tar.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Head of the store that is sent.
  [[nodiscard]] const edits::Head& head() const { return manifest_.head; }

  /// Reads about 256 KiB from the disk, valid until the next call; empty at the end. An error is one line.
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
  store::BackupManifest manifest_;  // hashes only of files already read
  std::uint64_t size_ = 0;
  std::size_t next_file_ = 0;  // index in manifest_.files
  bool ended_ = false;
  std::unique_ptr<InputFile> file_;  // null between files
  std::string piece_;
  std::unique_ptr<Writer> writer_;  // writes to piece_, even when destroyed
};

/// Size of a tar of these files.
[[nodiscard]] std::uint64_t tar_bytes(const store::BackupManifest& manifest);

}  // namespace talus::server
