// One connection's TLS, of either side, over a socket that does not block. It never waits: each call says
// what it did or what the socket must be ready for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <system_error>

#include <talus/tls/context.h>

namespace talus::tls {

/// What a call to a Session did.
struct Step {
  enum class Result : std::uint8_t {
    done,           // `bytes` were read or written
    wait_to_read,   // call again when the socket can be read from
    wait_to_write,  // call again when the socket can be written to
    closed,         // the other side has ended the stream
    failed,         // `error` says why
  };
  Result result = Result::done;
  std::error_code error{};  // the system's, or of error_category()
  std::size_t bytes = 0;

  [[nodiscard]] bool waits() const {
    return result == Result::wait_to_read || result == Result::wait_to_write;
  }
};

/// OpenSSL's error codes as ERR_get_error() gives them.
[[nodiscard]] const std::error_category& error_category();

/// OpenSSL reads and writes the socket itself, so nothing is copied through buffers between; the process must
/// ignore SIGPIPE. For one thread at a time.
class Session {
 public:
  /// `socket` outlives the session, and no other session has it.
  Session(const Context& context, Role role, int socket);
  /// The same of a connection with settings of its own, whose role is set.
  Session(Handle handle, int socket);

  [[nodiscard]] Step handshake();
  /// What one record holds at most.
  [[nodiscard]] Step read(std::span<std::byte> into);
  /// One record at most. The call after wait_to_write has the same bytes in front.
  [[nodiscard]] Step write(std::span<const std::byte> from);
  /// Tells the other side that nothing more comes.
  [[nodiscard]] Step close_notify();

  /// Whether bytes of a record are held that the socket does not tell of: read() returns them at once.
  [[nodiscard]] bool has_more() const;
  [[nodiscard]] const ssl_st* handle() const { return handle_.get(); }

 private:
  [[nodiscard]] Step after(int result);

  Handle handle_;
};

}  // namespace talus::tls
