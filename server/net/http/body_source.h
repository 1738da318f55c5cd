// The body of a response that is made while it is sent, so that it need not fit in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <asio/awaitable.hpp>

namespace talus::server::http {

class BodySource {
 public:
  virtual ~BodySource() = default;

  /// Of all of it, known from the beginning.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// The next piece, valid until the next call; empty at the end, which is not before size() bytes. On the
  /// connection's executor; what it throws ends the connection in the middle of the body.
  [[nodiscard]] virtual asio::awaitable<std::string_view> next() = 0;
};

}  // namespace talus::server::http
