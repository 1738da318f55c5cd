// System calls for reading and writing files behind an interface, so that tests can make each of them fail.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <system_error>

#include <tl/expected.hpp>

namespace talus::files {

/// May be called from many threads at once. A file is a number returned by open_to_read(), open_directory()
/// or a create function; the caller must close it once.
class FileLayer {
 public:
  template <typename Value>
  using Result = tl::expected<Value, std::error_code>;

  /// Selects whether opening and reading may block, as on a pipe without a writer.
  enum class WaitPolicy : std::uint8_t { allowed, never };

  virtual ~FileLayer() = default;

  [[nodiscard]] virtual Result<int> open_to_read(const std::filesystem::path& path, WaitPolicy wait) = 0;
  [[nodiscard]] virtual Result<int> open_directory(const std::filesystem::path& path) = 0;
  /// Creates a file without a name, which vanishes when it is closed or the process is killed. Fails if the
  /// file system does not support this.
  [[nodiscard]] virtual Result<int> create_unnamed(const std::filesystem::path& directory) = 0;
  /// Creates a file. Fails with file_exists if the name is taken.
  [[nodiscard]] virtual Result<int> create_new(const std::filesystem::path& path) = 0;
  /// The file's type and permissions (st_mode).
  [[nodiscard]] virtual Result<mode_t> mode(int file) = 0;
  /// Number of bytes read, possibly fewer than requested; 0 at the end of the file.
  [[nodiscard]] virtual Result<std::size_t> read(int file, std::span<std::byte> into) = 0;
  /// Number of bytes written at `offset`, possibly fewer than given, but at least 1.
  [[nodiscard]] virtual Result<std::size_t> write(int file, std::uint64_t offset,
                                                  std::span<const std::byte> bytes) = 0;
  [[nodiscard]] virtual Result<void> resize(int file, std::uint64_t bytes) = 0;
  /// Returns when the file's bytes, or the directory's names, are on disk.
  [[nodiscard]] virtual Result<void> sync(int file) = 0;
  /// Gives an unnamed file its name. Fails with file_exists if the name is taken.
  [[nodiscard]] virtual Result<void> name(int file, const std::filesystem::path& path) = 0;
  /// Replaces `to` atomically.
  [[nodiscard]] virtual Result<void> rename(const std::filesystem::path& from,
                                            const std::filesystem::path& to) = 0;
  virtual void remove(const std::filesystem::path& path) = 0;
  virtual void close(int file) = 0;
};

/// The operating system's files. Stateless.
[[nodiscard]] FileLayer& system_files();

}  // namespace talus::files
