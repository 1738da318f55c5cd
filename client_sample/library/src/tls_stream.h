// TLS over a connection's socket. Two implementations: OpenSSL, and one for builds without it.
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

/// Result of a read or a write: error code and number of bytes.
using TransferResult = std::tuple<std::error_code, std::size_t>;

class TlsStream {
 public:
  virtual ~TlsStream() = default;
  /// An error names the untrusted server, or the failure.
  [[nodiscard]] virtual asio::awaitable<Result<void>> handshake() = 0;
  [[nodiscard]] virtual asio::awaitable<TransferResult> read_some(asio::mutable_buffer into) = 0;
  [[nodiscard]] virtual asio::awaitable<TransferResult> write_all(asio::const_buffer from) = 0;
};

/// `socket` is connected and must outlive the stream; `host` is the name passed to connect().
[[nodiscard]] Result<std::unique_ptr<TlsStream>> make_tls_stream(asio::ip::tcp::socket& socket,
                                                                 const TlsOptions& options,
                                                                 const std::string& host);

}  // namespace talus::client
