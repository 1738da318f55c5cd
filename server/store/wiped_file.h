// A small file's bytes, where they may be secret or the file somebody else's.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server {

/// All of a regular file. Its memory is wiped at the end.
class WipedFile {
 public:
  /// Never waits, as to open a pipe of that name would. The error says why not: "cannot be read: No such file
  /// or directory", "is no regular file", "has over 8192 bytes".
  [[nodiscard]] static tl::expected<WipedFile, std::string> read(const std::filesystem::path& file,
                                                                 std::size_t most_bytes);
  WipedFile(WipedFile&&) = default;
  WipedFile& operator=(WipedFile&&) = delete;
  ~WipedFile();

  [[nodiscard]] std::string_view text() const { return {bytes_.data(), bytes_.size()}; }
  [[nodiscard]] mode_t mode() const { return mode_; }

 private:
  WipedFile() = default;

  std::vector<char> bytes_;  // reserved at once: nothing is left behind by growing
  mode_t mode_ = 0;
};

}  // namespace talus::server
