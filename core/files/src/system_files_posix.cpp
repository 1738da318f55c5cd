#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include <talus/files/file_layer.h>

namespace talus::files {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kNewFileMode = 0666;  // reduced by the umask

tl::unexpected<std::error_code> failure(int error) {
  return tl::unexpected{std::error_code{error, std::generic_category()}};
}

FileLayer::Result<int> opened(int file) {
  if (file < 0) return failure(errno);
  return file;
}

FileLayer::Result<void> done(int result) {
  if (result != 0) return failure(errno);
  return {};
}

std::string descriptor_link(int file) {
  return "/proc/self/fd/" + std::to_string(file);
}

class SystemFiles final : public FileLayer {
 public:
  Result<int> open_to_read(const fs::path& path, WaitPolicy wait) override {
    const int never_waits = wait == WaitPolicy::never ? O_NONBLOCK : 0;
    return opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | never_waits));
  }

  Result<int> open_directory(const fs::path& path) override {
    return opened(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  }

  Result<int> create_unnamed(const fs::path& directory) override {
    const int file = ::open(directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kNewFileMode);
    if (file < 0) return failure(errno);
    // name() needs /proc, which may be missing in some roots.
    if (::access(descriptor_link(file).c_str(), F_OK) != 0) {
      ::close(file);
      return failure(EOPNOTSUPP);
    }
    return file;
  }

  Result<int> create_new(const fs::path& path) override {
    return opened(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode));
  }

  Result<mode_t> mode(int file) override {
    struct stat status {};
    if (::fstat(file, &status) != 0) return failure(errno);
    return status.st_mode;
  }

  Result<std::size_t> read(int file, std::span<std::byte> into) override {
    for (;;) {
      const ssize_t bytes = ::read(file, into.data(), into.size());
      if (bytes >= 0) return static_cast<std::size_t>(bytes);
      if (errno != EINTR) return failure(errno);
    }
  }

  Result<std::size_t> write(int file, std::uint64_t offset, std::span<const std::byte> bytes) override {
    for (;;) {
      const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (written > 0) return static_cast<std::size_t>(written);
      if (written == 0) return failure(ENOSPC);
      if (errno != EINTR) return failure(errno);
    }
  }

  Result<void> resize(int file, std::uint64_t bytes) override {
    return done(::ftruncate(file, static_cast<off_t>(bytes)));
  }

  Result<void> sync(int file) override { return done(::fsync(file)); }

  Result<void> name(int file, const fs::path& path) override {
    return done(::linkat(AT_FDCWD, descriptor_link(file).c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW));
  }

  Result<void> rename(const fs::path& from, const fs::path& to) override {
    return done(::rename(from.c_str(), to.c_str()));
  }

  void remove(const fs::path& path) override { ::unlink(path.c_str()); }
  void close(int file) override { ::close(file); }
};

}  // namespace

FileLayer& system_files() {
  static SystemFiles files;
  return files;
}

}  // namespace talus::files
