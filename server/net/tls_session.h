// One connection's TLS, the server's side, over a socket that does not block. It waits for nothing: each call
// says what it did or what the socket must be ready for. For one thread at a time.
//
// OpenSSL reads and writes the socket itself, so nothing is copied through buffers between; the process must
// ignore SIGPIPE.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <system_error>

#include "net/tls_context.h"

struct ssl_st;  // OpenSSL's SSL

namespace talus::server {

struct TlsStep {
  enum class Next : std::uint8_t { none, wait_to_read, wait_to_write };
  Next next = Next::none;  // none: it is done, with `error` or `bytes`
  std::error_code error{};
  std::size_t bytes = 0;
};

class TlsSession {
 public:
  /// `socket` outlives it, and no other session has it.
  TlsSession(const TlsContext& context, int socket);

  [[nodiscard]] TlsStep handshake();
  /// asio::error::eof where the client has ended.
  [[nodiscard]] TlsStep read(std::span<std::byte> into);
  /// One record at most. What is called again after wait_to_write has the same bytes in front.
  [[nodiscard]] TlsStep write(std::span<const std::byte> from);
  /// Says that nothing more is to come.
  [[nodiscard]] TlsStep say_end();

 private:
  [[nodiscard]] TlsStep after(int result);

  struct Free {
    void operator()(ssl_st* ssl) const;
  };
  std::unique_ptr<ssl_st, Free> ssl_;
};

}  // namespace talus::server
