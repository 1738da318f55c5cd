// A file that is replaced atomically, even across a power cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/files/file_error.h>
#include <talus/files/file_layer.h>

namespace talus::files {

/// Writes go to a temporary file in the target's directory; commit() renames it over the target. Without
/// commit() the destructor removes the temporary and leaves the target unchanged. If the file system supports
/// it, the temporary has no name until commit(), so that a killed process leaves nothing behind.
class AtomicFile {
 public:
  /// Follows symlinks of `target`. Rejects an existing target that is not a regular file, so that a device is
  /// never replaced. `layer` must outlive the file.
  [[nodiscard]] static tl::expected<AtomicFile, FileError> create(const std::filesystem::path& target,
                                                                  FileLayer& layer = system_files());

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// May be called from many threads at once. Unwritten bytes between written ones read as zero.
  [[nodiscard]] tl::expected<void, FileError> write_at(std::uint64_t offset,
                                                       std::span<const std::byte> bytes) const;
  /// Truncates the file, or extends it with zeros.
  [[nodiscard]] tl::expected<void, FileError> resize(std::uint64_t bytes) const;
  /// Returns when the file and its name are on disk; no other function may be called afterwards. After an
  /// error the target is unchanged, or, if only syncing the directory failed, the complete new file.
  [[nodiscard]] tl::expected<void, FileError> commit();

  /// The path given to create().
  [[nodiscard]] const std::filesystem::path& target() const { return given_; }

 private:
  AtomicFile(FileLayer& layer, std::filesystem::path given, std::filesystem::path target, int directory);
  [[nodiscard]] tl::unexpected<FileError> cannot_write(std::error_code code) const;
  [[nodiscard]] std::filesystem::path directory_path() const;
  [[nodiscard]] FileLayer::Result<int> create_temporary();
  [[nodiscard]] FileLayer::Result<void> sync_directory() const;

  FileLayer* layer_;
  std::filesystem::path given_;
  std::filesystem::path target_;                    // after following symlinks
  std::optional<std::filesystem::path> temporary_;  // set while it has a name
  int file_ = -1;
  int directory_ = -1;
};

/// Writes a complete file through an AtomicFile.
[[nodiscard]] tl::expected<void, FileError> write_file(const std::filesystem::path& path,
                                                       std::span<const std::byte> bytes,
                                                       FileLayer& layer = system_files());
[[nodiscard]] tl::expected<void, FileError> write_file(const std::filesystem::path& path,
                                                       std::string_view text,
                                                       FileLayer& layer = system_files());

}  // namespace talus::files
