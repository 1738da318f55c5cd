#include "store/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace talus::server {
namespace {

tl::unexpected<std::string> unreadable(int error) {
  return tl::make_unexpected("cannot be read: " + std::generic_category().message(error));
}

}  // namespace

tl::expected<RegularFile, std::string> RegularFile::open(const std::filesystem::path& path) {
  RegularFile file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)};
  struct stat about {};
  if (file.descriptor_ < 0 || ::fstat(file.descriptor_, &about) != 0) return unreadable(errno);
  if (!S_ISREG(about.st_mode)) return tl::make_unexpected("is no regular file");
  file.mode_ = about.st_mode;
  return file;
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : descriptor_{std::exchange(other.descriptor_, -1)}, mode_{other.mode_} {}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

tl::expected<std::size_t, std::string> RegularFile::read(std::span<char> room) const {
  std::size_t size = 0;
  while (size < room.size()) {
    const ssize_t got = ::read(descriptor_, room.data() + size, room.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(errno);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  return size;
}

}  // namespace talus::server
