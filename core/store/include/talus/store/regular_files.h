// Guards against foreign files in a store's directory. RocksDB opens any file with a name that it knows: a
// pipe would block it for ever, a device feed it for ever, a link redirect it. So file types are checked
// first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace talus::store {

/// A file opened for reading. Links are not followed, and reading never blocks.
class RegularFile {
 public:
  /// An error is one line and names the file.
  [[nodiscard]] static tl::expected<RegularFile, std::string> open(const std::filesystem::path& path);
  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&&) = delete;
  ~RegularFile();

  /// Size when the file was opened.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Returns 0 at the end.
  [[nodiscard]] tl::expected<std::size_t, std::string> read(std::span<std::byte> into) const;

 private:
  RegularFile(int file, std::filesystem::path path) : file_{file}, path_{std::move(path)} {}

  int file_;
  std::filesystem::path path_;
  std::uint64_t bytes_ = 0;
};

/// Checks that `path` is a regular file or missing. Opens nothing.
[[nodiscard]] tl::expected<void, std::string> check_regular_file(const std::filesystem::path& path);

/// Checks that `directory` is missing, or a real directory (not a link) of regular files only, in which the
/// files that RocksDB reads whole when opening a database are small.
[[nodiscard]] tl::expected<void, std::string> check_regular_files(const std::filesystem::path& directory);

/// Total size of the files in `directory`. Files that vanish meanwhile and non-files count 0.
[[nodiscard]] std::uint64_t bytes_of_files(const std::filesystem::path& directory);

}  // namespace talus::store
