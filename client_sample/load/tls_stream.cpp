#include "tls_stream.h"

#include <openssl/err.h>
#include <openssl/ssl.h>

#include <cerrno>
#include <new>

#include <asio/error.hpp>
#include <asio/ssl/error.hpp>

namespace talus::load {

TlsStream::TlsStream(client::Tls tls, int socket) : tls_{std::move(tls)} {
  if (SSL_set_fd(tls_.get(), socket) != 1) throw std::bad_alloc{};
}

void TlsStream::handshake(std::error_code& error) {
  ERR_clear_error();
  const int result = SSL_do_handshake(tls_.get());
  error = result == 1 ? std::error_code{} : after(result);
}

std::size_t TlsStream::read(std::span<std::byte> into, std::error_code& error) {
  error.clear();
  std::size_t all = 0;
  while (all < into.size()) {  // a record at a time
    ERR_clear_error();
    std::size_t bytes = 0;
    const int result = SSL_read_ex(tls_.get(), into.data() + all, into.size() - all, &bytes);
    if (result != 1) {
      if (all == 0) error = after(result);  // else what stopped it comes again
      break;
    }
    all += bytes;
  }
  return all;
}

std::size_t TlsStream::write(std::span<const std::byte> from, std::error_code& error) {
  ERR_clear_error();
  std::size_t bytes = 0;
  const int result = SSL_write_ex(tls_.get(), from.data(), from.size(), &bytes);
  error = result == 1 ? std::error_code{} : after(result);
  return bytes;
}

bool TlsStream::waits_to_write() const {
  return SSL_want_write(tls_.get());
}

bool TlsStream::has_more() const {
  return SSL_pending(tls_.get()) > 0;
}

std::string TlsStream::failure(const std::error_code& error) const {
  return client::handshake_failure(tls_.get(), error).message;
}

std::error_code TlsStream::after(int result) const {
  const int system_error = errno;
  switch (SSL_get_error(tls_.get(), result)) {
    case SSL_ERROR_WANT_READ:
    case SSL_ERROR_WANT_WRITE:
      return asio::error::would_block;
    case SSL_ERROR_ZERO_RETURN:
      return asio::error::eof;
    case SSL_ERROR_SYSCALL:
      if (system_error == 0) return asio::error::eof;
      return {system_error, asio::error::get_system_category()};
    default:
      return {static_cast<int>(ERR_get_error()), asio::error::get_ssl_category()};
  }
}

}  // namespace talus::load
