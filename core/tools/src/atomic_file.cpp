#include "atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

namespace talus::tools {
namespace {

tl::unexpected<Failure> cannot_write(const std::filesystem::path& target, int error) {
  return failed(target.string() + ": cannot write: " + std::strerror(error));
}

// A file without a name vanishes even with a killed process; where the file system has none, one with the
// temporary's name must do. Negative where neither can be made.
int open_unnamed(const std::filesystem::path& temporary) {
  const auto directory = temporary.has_parent_path() ? temporary.parent_path() : std::filesystem::path{"."};
  const int unnamed = ::open(directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (unnamed >= 0) return unnamed;
  return ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

// Gives an unnamed file the temporary's name; rename alone could not, and linkat replaces nothing.
bool name_file(int descriptor, const std::filesystem::path& temporary) {
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && status.st_nlink > 0) return true;
  ::unlink(temporary.c_str());
  const std::string file = "/proc/self/fd/" + std::to_string(descriptor);
  return ::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, temporary.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

}  // namespace

Expected<AtomicFile> AtomicFile::create(const std::filesystem::path& target) {
  std::error_code error;
  std::filesystem::path file = target;
  if (std::filesystem::is_symlink(file, error)) file = std::filesystem::weakly_canonical(file, error);
  const auto type = std::filesystem::status(file, error).type();
  if (type == std::filesystem::file_type::directory) {
    return failed(target.string() + ": is a directory; a file name is needed");
  }
  if (std::filesystem::exists(file, error) && type != std::filesystem::file_type::regular) {
    return failed(target.string() + ": is not a regular file");
  }
  if (!file.has_filename()) return failed("'" + target.string() + "': a file name is needed");
  std::filesystem::path temporary = file;
  temporary.replace_filename("." + file.filename().string() + "." + std::to_string(::getpid()) + ".partial");
  const int descriptor = open_unnamed(temporary);
  if (descriptor < 0) return cannot_write(target, errno);
  return AtomicFile{std::move(file), std::move(temporary), descriptor};
}

AtomicFile::AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor)
    : target_{std::move(target)}, temporary_{std::move(temporary)}, descriptor_{descriptor} {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_{std::move(other.target_)},
      temporary_{std::move(other.temporary_)},
      descriptor_{std::exchange(other.descriptor_, -1)} {}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

Expected<void> AtomicFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return cannot_write(target_, written == 0 ? ENOSPC : errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return {};
}

Expected<void> AtomicFile::resize(std::uint64_t bytes) const {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) return cannot_write(target_, errno);
  return {};
}

Expected<void> AtomicFile::commit() {
  // The name must not reach the disk before the bytes do.
  if (::fsync(descriptor_) != 0) return cannot_write(target_, errno);
  if (!name_file(descriptor_, temporary_)) return cannot_write(target_, errno);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return cannot_write(target_, errno);
  ::close(std::exchange(descriptor_, -1));
  return {};
}

}  // namespace talus::tools
