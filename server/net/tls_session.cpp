#include "net/tls_session.h"

#include <openssl/err.h>
#include <openssl/ssl.h>

#include <cerrno>
#include <new>

#include <asio/error.hpp>
#include <asio/ssl/error.hpp>

namespace talus::server {

TlsSession::TlsSession(const TlsContext& context, int socket) : ssl_{SSL_new(context.get())} {
  if (ssl_ == nullptr || SSL_set_fd(ssl_.get(), socket) != 1) throw std::bad_alloc{};
  SSL_set_accept_state(ssl_.get());
}

void TlsSession::Free::operator()(ssl_st* ssl) const {
  SSL_free(ssl);
}

TlsStep TlsSession::handshake() {
  ERR_clear_error();
  return after(SSL_do_handshake(ssl_.get()));
}

TlsStep TlsSession::read(std::span<std::byte> into) {
  if (into.empty()) return {};
  ERR_clear_error();
  std::size_t bytes = 0;
  const int result = SSL_read_ex(ssl_.get(), into.data(), into.size(), &bytes);
  return result == 1 ? TlsStep{TlsStep::Next::none, {}, bytes} : after(result);
}

TlsStep TlsSession::write(std::span<const std::byte> from) {
  if (from.empty()) return {};
  ERR_clear_error();
  std::size_t bytes = 0;
  const int result = SSL_write_ex(ssl_.get(), from.data(), from.size(), &bytes);
  return result == 1 ? TlsStep{TlsStep::Next::none, {}, bytes} : after(result);
}

TlsStep TlsSession::say_end() {
  ERR_clear_error();
  const int result = SSL_shutdown(ssl_.get());
  return result >= 0 ? TlsStep{} : after(result);  // 0: said, and the client has not answered
}

TlsStep TlsSession::after(int result) {
  using Next = TlsStep::Next;
  const int system_error = errno;
  switch (SSL_get_error(ssl_.get(), result)) {
    case SSL_ERROR_NONE:
      return {};
    case SSL_ERROR_WANT_READ:
      return {Next::wait_to_read};
    case SSL_ERROR_WANT_WRITE:
      return {Next::wait_to_write};
    case SSL_ERROR_ZERO_RETURN:
      return {Next::none, asio::error::eof};
    case SSL_ERROR_SYSCALL:
      if (system_error == 0) return {Next::none, asio::error::eof};
      return {Next::none, {system_error, std::system_category()}};
    default:
      return {Next::none, {static_cast<int>(ERR_get_error()), asio::error::get_ssl_category()}};
  }
}

}  // namespace talus::server
