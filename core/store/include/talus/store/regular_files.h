// Files that others may have put where a store's are. RocksDB opens whatever has a name that it knows: a pipe
// would hold it for ever, a device feed it for ever, a link lead it elsewhere. So what is there is looked at
// first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace talus::store {

/// Opened to be read. No link was followed to it, and reading never waits for anybody.
class RegularFile {
 public:
  /// An error is one line, and names the file.
  [[nodiscard]] static tl::expected<RegularFile, std::string> open(const std::filesystem::path& path);
  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&&) = delete;
  ~RegularFile();

  /// As it was opened.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// 0 at its end.
  [[nodiscard]] tl::expected<std::size_t, std::string> read(std::span<std::byte> into) const;

 private:
  RegularFile(int file, std::filesystem::path path) : file_{file}, path_{std::move(path)} {}

  int file_;
  std::filesystem::path path_;
  std::uint64_t bytes_ = 0;
};

/// That `path` is a regular file, or that there is nothing. Opens nothing.
[[nodiscard]] tl::expected<void, std::string> check_regular_file(const std::filesystem::path& path);

/// That `directory` is one, not a link to one, and all that it holds are regular files, of which those that
/// RocksDB reads whole when it opens a database are small; or that there is nothing.
[[nodiscard]] tl::expected<void, std::string> check_regular_files(const std::filesystem::path& directory);

/// Of all files that `directory` holds; those that vanish meanwhile, or are none, count nothing.
[[nodiscard]] std::uint64_t bytes_of_files(const std::filesystem::path& directory);

}  // namespace talus::store
