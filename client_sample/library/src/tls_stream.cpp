#include "tls_stream.h"

#include <asio/experimental/as_tuple.hpp>
#include <asio/ssl/stream.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include <talus/client/tls.h>

namespace talus::client {
namespace {

constexpr auto kTlsAsTuple = asio::experimental::as_tuple(asio::use_awaitable);

class OpenSslStream final : public TlsStream {
 public:
  OpenSslStream(asio::ip::tcp::socket& socket, tls::Handle handle) : stream_{socket, handle.release()} {}

  asio::awaitable<Result<void>> handshake() override {
    const auto [error] = co_await stream_.async_handshake(asio::ssl::stream_base::client, kTlsAsTuple);
    if (error) co_return tl::unexpected{handshake_failure(stream_.native_handle(), error)};
    co_return Result<void>{};
  }
  asio::awaitable<TransferResult> read_some(asio::mutable_buffer into) override {
    return stream_.async_read_some(into, kTlsAsTuple);
  }
  asio::awaitable<TransferResult> write_all(asio::const_buffer from) override {
    return asio::async_write(stream_, from, kTlsAsTuple);
  }

 private:
  asio::ssl::stream<asio::ip::tcp::socket&> stream_;
};

}  // namespace

Result<std::unique_ptr<TlsStream>> make_tls_stream(asio::ip::tcp::socket& socket, const TlsOptions& options,
                                                   const std::string& host) {
  const auto context = make_tls_context(options);
  if (!context) return tl::unexpected{context.error()};
  return std::make_unique<OpenSslStream>(socket, new_tls(*context, options, host));
}

}  // namespace talus::client
