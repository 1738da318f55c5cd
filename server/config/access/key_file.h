// Secrets are read from files, to keep them out of the configuration, the environment and the process list.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

/// Bytes that the destructor overwrites.
class Secret {
 public:
  explicit Secret(std::string_view bytes) : bytes_{bytes} {}
  Secret(Secret&& other) noexcept { bytes_.swap(other.bytes_); }
  Secret& operator=(Secret&&) = delete;
  ~Secret();

  [[nodiscard]] std::string_view bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

struct KeyFile {
  Secret secret;
  std::optional<std::string> warning;  // one line: other users may read or change the file
};

struct KeyBounds {
  std::size_t min_bytes;
  std::size_t max_bytes;
  /// How to create such a file, for errors: "it must have ..., as {}".
  std::string_view as = "\"head -c 32 /dev/urandom | base64\" prints";
  /// All bytes count, whatever they are: no newline is left out, and nothing is refused as an editor's.
  bool is_binary = false;
};

/// Reads the file, if text without one trailing newline. An error is one line that begins with the file: it
/// cannot be read, is not a regular file, has a length out of bounds, is not a secret (blank, or one repeated
/// character), or begins with a byte order mark or ends with empty lines, which no client sends.
[[nodiscard]] tl::expected<KeyFile, std::string> read_key_file(const std::filesystem::path& file,
                                                               KeyBounds bounds);

/// Returns a one-line warning if other users may read or change the file; nullopt if not.
[[nodiscard]] std::optional<std::string> open_to_others(const std::filesystem::path& file);

}  // namespace talus::server
