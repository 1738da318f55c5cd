#include <openssl/err.h>
#include <openssl/ssl.h>

#include <cerrno>
#include <new>
#include <utility>

#include <talus/tls/session.h>

namespace talus::tls {
namespace {

class ErrorCategory final : public std::error_category {
 public:
  [[nodiscard]] const char* name() const noexcept override { return "tls"; }
  [[nodiscard]] std::string message(int value) const override {
    const char* const text = ERR_reason_error_string(static_cast<unsigned long>(value));
    return text == nullptr ? "TLS error" : text;
  }
};

Handle new_handle(const Context& context, Role role) {
  Handle handle{SSL_new(context.get())};
  if (handle == nullptr) throw std::bad_alloc{};
  if (role == Role::server) {
    SSL_set_accept_state(handle.get());
  } else {
    SSL_set_connect_state(handle.get());
  }
  return handle;
}

}  // namespace

const std::error_category& error_category() {
  static const ErrorCategory category;
  return category;
}

Session::Session(const Context& context, Role role, int socket)
    : Session{new_handle(context, role), socket} {}

Session::Session(Handle handle, int socket) : handle_{std::move(handle)} {
  if (SSL_set_fd(handle_.get(), socket) != 1) throw std::bad_alloc{};
}

Step Session::handshake() {
  ERR_clear_error();
  const int result = SSL_do_handshake(handle_.get());
  return result == 1 ? Step{} : after(result);
}

Step Session::read(std::span<std::byte> into) {
  if (into.empty()) return {};
  ERR_clear_error();
  std::size_t bytes = 0;
  const int result = SSL_read_ex(handle_.get(), into.data(), into.size(), &bytes);
  return result == 1 ? Step{Step::Result::done, {}, bytes} : after(result);
}

Step Session::write(std::span<const std::byte> from) {
  if (from.empty()) return {};
  ERR_clear_error();
  std::size_t bytes = 0;
  const int result = SSL_write_ex(handle_.get(), from.data(), from.size(), &bytes);
  return result == 1 ? Step{Step::Result::done, {}, bytes} : after(result);
}

Step Session::close_notify() {
  ERR_clear_error();
  const int result = SSL_shutdown(handle_.get());
  return result >= 0 ? Step{} : after(result);  // 0: sent, the peer has not answered
}

bool Session::has_more() const {
  return SSL_pending(handle_.get()) > 0;
}

Step Session::after(int result) {
  using Result = Step::Result;
  const int system_error = errno;
  switch (SSL_get_error(handle_.get(), result)) {
    case SSL_ERROR_NONE:
      return {};
    case SSL_ERROR_WANT_READ:
      return {Result::wait_to_read};
    case SSL_ERROR_WANT_WRITE:
      return {Result::wait_to_write};
    case SSL_ERROR_ZERO_RETURN:
      return {Result::closed};
    case SSL_ERROR_SYSCALL:
      if (system_error == 0) return {Result::closed};
      return {Result::failed, {system_error, std::system_category()}};
    default:
      return {Result::failed, {static_cast<int>(ERR_get_error()), error_category()}};
  }
}

}  // namespace talus::tls
