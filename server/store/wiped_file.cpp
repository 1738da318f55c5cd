#include "store/wiped_file.h"

#include <fcntl.h>
#include <openssl/crypto.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "store/descriptor.h"

namespace talus::server {
namespace {

tl::unexpected<std::string> unreadable(int error) {
  return tl::make_unexpected("cannot be read: " + std::generic_category().message(error));
}

}  // namespace

tl::expected<WipedFile, std::string> WipedFile::read(const std::filesystem::path& file,
                                                     std::size_t most_bytes) {
  const Descriptor in{::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)};
  struct stat about {};
  if (in.get() < 0 || ::fstat(in.get(), &about) != 0) return unreadable(errno);
  if (!S_ISREG(about.st_mode)) return tl::make_unexpected("is no regular file");
  WipedFile read;
  read.mode_ = about.st_mode;
  read.bytes_.resize(most_bytes + 1);
  std::size_t size = 0;
  while (size < read.bytes_.size()) {
    const ssize_t got = ::read(in.get(), read.bytes_.data() + size, read.bytes_.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(errno);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size > most_bytes) return tl::make_unexpected(fmt::format("has over {} bytes", most_bytes));
  read.bytes_.resize(size);
  return read;
}

WipedFile::~WipedFile() {
  OPENSSL_cleanse(bytes_.data(), bytes_.size());
}

}  // namespace talus::server
