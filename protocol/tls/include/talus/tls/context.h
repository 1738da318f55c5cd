// OpenSSL's shared state for the connections of one side, restricted to TLS 1.3.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct ssl_ctx_st;  // OpenSSL's SSL_CTX
struct ssl_st;      // OpenSSL's SSL

namespace talus::tls {

enum class Role : std::uint8_t { client, server };

/// Shared and kept alive by connections of any thread.
using Context = std::shared_ptr<ssl_ctx_st>;

struct FreeHandle {
  void operator()(ssl_st* handle) const;
};
/// OpenSSL's state of one connection.
using Handle = std::unique_ptr<ssl_st, FreeHandle>;

/// Creates a TLS 1.3 context without session tickets or session cache. Idle connections release their
/// buffers, and each write sends one record. The caller sets trusted certificates and its own certificate.
/// Null if OpenSSL fails; last_reason() returns the reason.
[[nodiscard]] Context new_context(Role role);

/// OpenSSL's last error on this thread, empty if none is queued; clears its error queue.
[[nodiscard]] std::string last_reason();

}  // namespace talus::tls
