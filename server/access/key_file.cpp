#include "access/key_file.h"

#include <fcntl.h>
#include <openssl/crypto.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "log/escape.h"

namespace talus::server {
namespace {

constexpr std::size_t kMostBytes = 8192;  // of any file that is taken for a key

/// Where a file's bytes lie until they are a Secret.
class Buffer {
 public:
  Buffer() = default;
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { OPENSSL_cleanse(bytes_.data(), bytes_.size()); }

  /// Reads to the end, or until there is no room; 0 or the errno.
  int fill(int descriptor) {
    while (size_ < bytes_.size()) {
      const ssize_t got = ::read(descriptor, bytes_.data() + size_, bytes_.size() - size_);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return errno;
      if (got == 0) break;
      size_ += static_cast<std::size_t>(got);
    }
    return 0;
  }
  [[nodiscard]] std::string_view text() const { return {bytes_.data(), size_}; }

 private:
  std::array<char, kMostBytes + 1> bytes_{};
  std::size_t size_ = 0;
};

std::string_view without_line_end(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

std::optional<std::string> too_open(const std::filesystem::path& file, mode_t mode) {
  if ((mode & (S_IROTH | S_IWOTH | S_IWGRP)) == 0) return std::nullopt;
  return fmt::format("{}: may be read or changed by others (mode {:03o}); chmod 600 it, or 640",
                     escaped(file.string(), 500), mode & 0777U);
}

}  // namespace

std::optional<std::string> open_to_others(const std::filesystem::path& file) {
  struct stat about {};
  return ::stat(file.c_str(), &about) == 0 ? too_open(file, about.st_mode) : std::nullopt;
}

Secret::~Secret() {
  OPENSSL_cleanse(bytes_.data(), bytes_.size());
}

tl::expected<KeyFile, std::string> read_key_file(const std::filesystem::path& file, KeyBounds bounds) {
  const auto unreadable = [&](int error) {
    return tl::make_unexpected(
        fmt::format("{}: cannot be read: {}; give a file that the user of talusd may read",
                    escaped(file.string(), 500), std::generic_category().message(error)));
  };
  // Without waiting: a pipe under this name would hold the server up for ever.
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0) return unreadable(errno);
  struct stat about {};
  Buffer buffer;
  int failed = ::fstat(descriptor, &about) == 0 ? 0 : errno;
  const bool regular = failed == 0 && S_ISREG(about.st_mode);
  if (regular) failed = buffer.fill(descriptor);
  ::close(descriptor);
  if (failed != 0) return unreadable(failed);
  if (!regular) {
    return tl::make_unexpected(
        fmt::format("{}: is no regular file; give one with the secret in it", escaped(file.string(), 500)));
  }
  const std::string_view bytes = without_line_end(buffer.text());
  if (bytes.size() < bounds.least_bytes || bytes.size() > bounds.most_bytes) {
    return tl::make_unexpected(fmt::format(
        "{}: has {} bytes; {} to {} are right, as of \"openssl rand -base64 32\"",
        escaped(file.string(), 500),
        bytes.size() > kMostBytes ? fmt::format("over {}", kMostBytes) : fmt::to_string(bytes.size()),
        bounds.least_bytes, bounds.most_bytes));
  }
  return KeyFile{Secret{bytes}, too_open(file, about.st_mode)};
}

}  // namespace talus::server
