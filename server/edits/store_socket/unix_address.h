// The address of a Unix socket with a path of any length; the system's limit is 107 bytes.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace talus::server {

/// An address of `path`, valid while this lives: a long path goes through a descriptor of its directory.
class UnixAddress {
 public:
  [[nodiscard]] static tl::expected<UnixAddress, std::string> of(const std::filesystem::path& path);
  UnixAddress(UnixAddress&& other) noexcept;
  UnixAddress& operator=(UnixAddress&&) = delete;
  ~UnixAddress();

  [[nodiscard]] const sockaddr* address() const { return reinterpret_cast<const sockaddr*>(&address_); }
  [[nodiscard]] socklen_t size() const { return sizeof address_; }

 private:
  UnixAddress() = default;

  sockaddr_un address_{};
  int directory_ = -1;
};

}  // namespace talus::server
