// A response body generated while it is sent, so that it need not fit in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <asio/awaitable.hpp>

namespace talus::server::http {

class BodySource {
 public:
  virtual ~BodySource() = default;

  /// Size of the whole body, known from the start.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Returns the next piece, valid until the next call; empty after size() bytes. Called on the connection's
  /// executor. An exception closes the connection in the middle of the body.
  [[nodiscard]] virtual asio::awaitable<std::string_view> next() = 0;
};

}  // namespace talus::server::http
