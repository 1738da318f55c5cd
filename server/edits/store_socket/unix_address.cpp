#include "edits/store_socket/unix_address.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace talus::server {

tl::expected<UnixAddress, std::string> UnixAddress::of(const std::filesystem::path& path) {
  UnixAddress made;
  made.address_.sun_family = AF_UNIX;
  std::string name = path.string();
  if (name.size() >= sizeof made.address_.sun_path) {
    made.directory_ = ::open(path.parent_path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (made.directory_ < 0) {
      return tl::unexpected{fmt::format("{}: {}", path.string(), std::generic_category().message(errno))};
    }
    name = fmt::format("/proc/self/fd/{}/{}", made.directory_, path.filename().string());
  }
  if (name.size() >= sizeof made.address_.sun_path) {
    return tl::unexpected{fmt::format("{}: the name is too long for a socket", path.string())};
  }
  std::memcpy(made.address_.sun_path, name.c_str(), name.size() + 1);
  return made;
}

UnixAddress::UnixAddress(UnixAddress&& other) noexcept
    : address_{other.address_}, directory_{std::exchange(other.directory_, -1)} {}

UnixAddress::~UnixAddress() {
  if (directory_ >= 0) ::close(directory_);
}

}  // namespace talus::server
