// The system calls that reading and writing files need, as an interface, so that tests can make each of them
// fail.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <system_error>

#include <tl/expected.hpp>

namespace talus::files {

/// Calls may come from many threads at once. A file is a number that open_to_read(), open_directory() or one
/// of the create functions returned; the caller closes it once.
class FileLayer {
 public:
  template <typename Value>
  using Result = tl::expected<Value, std::error_code>;

  /// Whether opening and reading may wait, as for the writer of a pipe.
  enum class Waiting : std::uint8_t { allowed, never };

  virtual ~FileLayer() = default;

  [[nodiscard]] virtual Result<int> open_to_read(const std::filesystem::path& path, Waiting waiting) = 0;
  [[nodiscard]] virtual Result<int> open_directory(const std::filesystem::path& path) = 0;
  /// A new file without a name, which vanishes when it is closed, also with a killed process. Fails where the
  /// file system has no such files.
  [[nodiscard]] virtual Result<int> create_unnamed(const std::filesystem::path& directory) = 0;
  /// A new file. Fails with file_exists where the name is taken.
  [[nodiscard]] virtual Result<int> create_new(const std::filesystem::path& path) = 0;
  /// The file's type and permissions (st_mode).
  [[nodiscard]] virtual Result<mode_t> mode(int file) = 0;
  /// Bytes read, 0 at the end of the file; may be fewer than asked for.
  [[nodiscard]] virtual Result<std::size_t> read(int file, std::span<std::byte> into) = 0;
  /// Bytes written at `offset`, at least 1; may be fewer than given.
  [[nodiscard]] virtual Result<std::size_t> write(int file, std::uint64_t offset,
                                                  std::span<const std::byte> bytes) = 0;
  [[nodiscard]] virtual Result<void> resize(int file, std::uint64_t bytes) = 0;
  /// Returns when the file's bytes, or the directory's names, are on the disk.
  [[nodiscard]] virtual Result<void> sync(int file) = 0;
  /// Gives an unnamed file its name. Fails with file_exists where the name is taken.
  [[nodiscard]] virtual Result<void> name(int file, const std::filesystem::path& path) = 0;
  /// Replaces `to` in one step.
  [[nodiscard]] virtual Result<void> rename(const std::filesystem::path& from,
                                            const std::filesystem::path& to) = 0;
  virtual void remove(const std::filesystem::path& path) = 0;
  virtual void close(int file) = 0;
};

/// The operating system's files. Holds no state.
[[nodiscard]] FileLayer& system_files();

}  // namespace talus::files
