// Pull interface for the bytes of a checkpoint's tar.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

class TarSource {
 public:
  virtual ~TarSource() = default;

  /// Size announced by the sender; known before reading.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Waits for the next bytes, valid until the next call; empty after size() bytes. An error is one line.
  [[nodiscard]] virtual tl::expected<std::string_view, std::string> read() = 0;
};

}  // namespace talus::server
