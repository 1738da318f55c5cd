// TLS over a connection's socket. Two sources implement it: one by OpenSSL, and one for builds without it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <system_error>
#include <tuple>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>

#include <talus/client/error.h>
#include <talus/client/options.h>

namespace talus::client {

/// What a read or a write gives: how it went, and the bytes.
using Transferred = std::tuple<std::error_code, std::size_t>;

class TlsStream {
 public:
  virtual ~TlsStream() = default;
  /// An error says whom it does not trust, or what failed.
  [[nodiscard]] virtual asio::awaitable<Result<void>> handshake() = 0;
  [[nodiscard]] virtual asio::awaitable<Transferred> read_some(asio::mutable_buffer into) = 0;
  [[nodiscard]] virtual asio::awaitable<Transferred> write_all(asio::const_buffer from) = 0;
};

/// `socket` is connected, and outlives the stream; `host` is the name that was given to connect().
[[nodiscard]] Result<std::unique_ptr<TlsStream>> make_tls_stream(asio::ip::tcp::socket& socket,
                                                                 const TlsOptions& options,
                                                                 const std::string& host);

}  // namespace talus::client
