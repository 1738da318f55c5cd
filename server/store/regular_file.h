// A file on disk and nothing else under its name.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace talus::server {

/// Open to be read. Opening never waits, as it would for whoever is to write into a pipe of that name.
class RegularFile {
 public:
  /// The error says why not: "cannot be read: No such file or directory", "is no regular file".
  [[nodiscard]] static tl::expected<RegularFile, std::string> open(const std::filesystem::path& file);
  RegularFile(RegularFile&& other) noexcept;
  RegularFile& operator=(RegularFile&&) = delete;
  ~RegularFile();

  [[nodiscard]] mode_t mode() const { return mode_; }
  /// Reads until there is no room or no more; how many bytes, or why not.
  [[nodiscard]] tl::expected<std::size_t, std::string> read(std::span<char> room) const;

 private:
  explicit RegularFile(int descriptor) : descriptor_{descriptor} {}

  int descriptor_;
  mode_t mode_ = 0;
};

}  // namespace talus::server
