#include "output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace talus::cli {
namespace {

namespace fs = std::filesystem;

// Where bytes written to `path` would land: at the end of its symlinks, whether or not a file is there.
fs::path followed(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  for (int links = 0; links < kMostLinks && fs::is_symlink(path, error); ++links) {
    const fs::path target = fs::read_symlink(path, error);
    path = path.parent_path() / target;
  }
  return path;
}

// A new file in `directory`, under a name that nothing else has; removed with its object unless renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& directory) {
    constexpr int kMostNames = 1000;
    const std::string name = ".talus-client." + std::to_string(::getpid()) + '.';
    for (int number = 0; descriptor_ < 0 && number < kMostNames; ++number) {
      path_ = directory / (name + std::to_string(number));
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) return;
    }
  }
  ~Temporary() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(path_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  // These and the constructor leave the reason of a failure in errno.
  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

  [[nodiscard]] bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }

  [[nodiscard]] bool rename_to(const fs::path& target) {
    // The name must not reach the disk before the bytes do.
    if (::fsync(descriptor_) != 0 || std::rename(path_.c_str(), target.c_str()) != 0) return false;
    ::close(std::exchange(descriptor_, -1));
    return true;
  }

 private:
  fs::path path_;
  int descriptor_ = -1;
};

}  // namespace

tl::expected<void, std::string> write_file(const fs::path& path, std::span<const std::byte> bytes) {
  const fs::path target = followed(path);
  std::error_code ignored;  // what cannot be seen cannot be written beside either, and that says why
  const auto type = fs::symlink_status(target, ignored).type();
  if (type == fs::file_type::directory || !target.has_filename()) {
    return tl::unexpected{"'" + path.string() + "': a file name is needed"};
  }
  if (type != fs::file_type::regular && type != fs::file_type::not_found && type != fs::file_type::none) {
    return tl::unexpected{path.string() + ": is not a regular file"};
  }
  Temporary temporary{target.has_parent_path() ? target.parent_path() : fs::path{"."}};
  if (!temporary.is_open() || !temporary.write(bytes) || !temporary.rename_to(target)) {
    return tl::unexpected{path.string() + ": cannot be written: " + std::strerror(errno)};
  }
  return {};
}

}  // namespace talus::cli
