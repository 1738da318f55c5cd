// TLS of one connection, client or server, over a non-blocking socket. Never blocks: each call returns what
// it did, or what the socket must become ready for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <system_error>

#include <talus/tls/context.h>

namespace talus::tls {

/// Result of a call to a Session.
struct Step {
  enum class Result : std::uint8_t {
    done,           // `bytes` were read or written
    wait_to_read,   // call again when the socket is readable
    wait_to_write,  // call again when the socket is writable
    closed,         // the peer ended the stream
    failed,         // see `error`
  };
  Result result = Result::done;
  std::error_code error{};  // from the system, or from error_category()
  std::size_t bytes = 0;

  [[nodiscard]] bool waits() const {
    return result == Result::wait_to_read || result == Result::wait_to_write;
  }
};

/// Category of OpenSSL's error codes, as returned by ERR_get_error().
[[nodiscard]] const std::error_category& error_category();

/// OpenSSL reads and writes the socket directly, without intermediate buffers; the process must ignore
/// SIGPIPE. Not thread-safe.
class Session {
 public:
  /// `socket` must outlive the session, which must be its only one.
  Session(const Context& context, Role role, int socket);
  /// Takes a handle with its own settings, whose role is set.
  Session(Handle handle, int socket);

  [[nodiscard]] Step handshake();
  /// Reads at most one record.
  [[nodiscard]] Step read(std::span<std::byte> into);
  /// Writes at most one record. After wait_to_write, the next call must begin with the same bytes.
  [[nodiscard]] Step write(std::span<const std::byte> from);
  /// Notifies the peer that the stream ends.
  [[nodiscard]] Step close_notify();

  /// True if decrypted bytes are buffered: read() returns them even if the socket is not readable.
  [[nodiscard]] bool has_more() const;
  [[nodiscard]] const ssl_st* handle() const { return handle_.get(); }

 private:
  [[nodiscard]] Step after(int result);

  Handle handle_;
};

}  // namespace talus::tls
