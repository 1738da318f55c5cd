// Reads small files that may hold secrets.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/files/file_error.h>
#include <talus/files/file_layer.h>

namespace talus::files {

/// Contents of a regular file. The destructor overwrites the memory.
class SecretFile {
 public:
  /// Never blocks, as opening a pipe would. The error's reason is "cannot be read: No such file or
  /// directory", "is not a regular file" or "has over 8192 bytes".
  [[nodiscard]] static tl::expected<SecretFile, FileError> read(const std::filesystem::path& file,
                                                                std::size_t max_bytes,
                                                                FileLayer& layer = system_files());
  SecretFile(SecretFile&&) = default;
  SecretFile& operator=(SecretFile&&) = delete;
  ~SecretFile();

  [[nodiscard]] std::string_view text() const { return {bytes_.data(), bytes_.size()}; }
  [[nodiscard]] mode_t mode() const { return mode_; }

 private:
  SecretFile() = default;

  std::vector<char> bytes_;  // allocated at once, so that growing leaves no copies
  mode_t mode_ = 0;
};

}  // namespace talus::files
