// A connection's TLS over a socket that does not block: what cannot go on now says so, and for what it waits.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <system_error>

#include <talus/client/tls.h>

namespace talus::load {

class TlsStream {
 public:
  /// `socket` outlives it.
  TlsStream(client::Tls tls, int socket);

  // Each sets asio::error::would_block where the socket is not ready, and asio::error::eof at the end.
  void handshake(std::error_code& error);
  std::size_t read(std::span<std::byte> into, std::error_code& error);
  std::size_t write(std::span<const std::byte> from, std::error_code& error);

  /// After would_block: whether it waits to write, and not to read.
  [[nodiscard]] bool waits_to_write() const;
  /// Bytes are here that the socket will not tell of.
  [[nodiscard]] bool has_more() const;
  /// One line, after the handshake failed with `error`.
  [[nodiscard]] std::string failure(const std::error_code& error) const;

 private:
  [[nodiscard]] std::error_code after(int result) const;

  client::Tls tls_;
};

}  // namespace talus::load
