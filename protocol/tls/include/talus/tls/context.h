// What OpenSSL keeps for the connections of one side: TLS 1.3 and how it is used.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct ssl_ctx_st;  // OpenSSL's SSL_CTX
struct ssl_st;      // and SSL

namespace talus::tls {

enum class Role : std::uint8_t { client, server };

/// Connections of any thread may share it, and keep it alive.
using Context = std::shared_ptr<ssl_ctx_st>;

struct FreeHandle {
  void operator()(ssl_st* handle) const;
};
/// OpenSSL's side of one connection.
using Handle = std::unique_ptr<ssl_st, FreeHandle>;

/// TLS 1.3 alone, without session tickets or a session cache, with buffers that an idle connection does not
/// keep and writes of one record at a time. Whom to trust and what to show is the caller's to set. Null where
/// OpenSSL fails; last_reason() says why.
[[nodiscard]] Context new_context(Role role);

/// What OpenSSL says went wrong last on this thread; clears its queue of errors. Empty: it says nothing.
[[nodiscard]] std::string last_reason();

}  // namespace talus::tls
