#include "net/tls_stream.h"

#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>

#include "net/stream.h"

namespace talus::server {

static_assert(Stream<TlsStream>);

asio::awaitable<void> TlsStream::say_end() {
  std::error_code ignored;
  co_await compose([](tls::Session& session) { return session.close_notify(); },
                   asio::redirect_error(asio::use_awaitable, ignored));
}

}  // namespace talus::server
