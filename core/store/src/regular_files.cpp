#include <talus/store/regular_files.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace talus::store {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> unreadable(const fs::path& path, int error) {
  return tl::unexpected{fmt::format("{}: cannot be read: {}{}", path.string(),
                                    std::generic_category().message(error),
                                    error == EACCES ? "; run this as the user that owns the store" : "")};
}

std::string_view kind_of(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFDIR:
      return "a directory";
    case S_IFIFO:
      return "a pipe";
    case S_IFLNK:
      return "a link";
    case S_IFSOCK:
      return "a socket";
    case S_IFREG:
      return "a regular file";
    default:
      return "a device";
  }
}

tl::unexpected<std::string> wrong_kind(const fs::path& path, mode_t mode, std::string_view wanted) {
  return tl::unexpected{
      fmt::format("{}: it is {}, and must be {} of talusd's own; remove it, or restore a backup",
                  path.string(), kind_of(mode), wanted)};
}

}  // namespace

tl::expected<RegularFile, std::string> RegularFile::open(const fs::path& path) {
  RegularFile file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK | O_NOFOLLOW), path};
  if (file.file_ < 0 && errno == ELOOP) return wrong_kind(path, S_IFLNK, "a regular file");
  if (file.file_ < 0) return unreadable(path, errno);
  struct stat about {};
  if (::fstat(file.file_, &about) != 0) return unreadable(path, errno);
  if (!S_ISREG(about.st_mode)) return wrong_kind(path, about.st_mode, "a regular file");
  file.bytes_ = static_cast<std::uint64_t>(about.st_size);
  return file;
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : file_{std::exchange(other.file_, -1)}, path_{std::move(other.path_)}, bytes_{other.bytes_} {}

RegularFile::~RegularFile() {
  if (file_ >= 0) ::close(file_);
}

tl::expected<std::size_t, std::string> RegularFile::read(std::span<std::byte> into) const {
  for (;;) {
    const ssize_t got = ::read(file_, into.data(), into.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) return unreadable(path_, errno);
  }
}

tl::expected<void, std::string> check_regular_file(const fs::path& path) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0) {
    if (errno == ENOENT) return {};
    return unreadable(path, errno);
  }
  if (!S_ISREG(about.st_mode)) return wrong_kind(path, about.st_mode, "a regular file");
  return {};
}

namespace {

/// RocksDB writes less than 100 bytes into each, but reads them whole.
tl::expected<void, std::string> check_small_file(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = 4096;
  if (path.filename() != "CURRENT" && path.filename() != "IDENTITY") return {};
  std::error_code code;
  const std::uintmax_t bytes = fs::file_size(path, code);
  if (code || bytes <= kMaxBytes) return {};
  return tl::unexpected{fmt::format("{}: it has {} bytes, and talusd's own has at most {}; restore a backup",
                                    path.string(), bytes, kMaxBytes)};
}

}  // namespace

tl::expected<void, std::string> check_regular_files(const fs::path& directory) {
  struct stat about {};
  if (::lstat(directory.c_str(), &about) != 0) {
    if (errno == ENOENT) return {};
    return unreadable(directory, errno);
  }
  if (!S_ISDIR(about.st_mode)) return wrong_kind(directory, about.st_mode, "a directory");
  std::error_code code;
  for (fs::directory_iterator at{directory, code}, end; !code && at != end; at.increment(code)) {
    if (auto good = check_regular_file(at->path()); !good) return good;
    if (auto good = check_small_file(at->path()); !good) return good;
  }
  if (code) return unreadable(directory, code.value());
  return {};
}

std::uint64_t bytes_of_files(const fs::path& directory) {
  std::uint64_t bytes = 0;
  std::error_code code;
  for (fs::directory_iterator at{directory, code}, end; !code && at != end; at.increment(code)) {
    std::error_code vanished;
    const std::uint64_t each = at->file_size(vanished);
    if (!vanished) bytes += each;
  }
  return bytes;
}

}  // namespace talus::store
