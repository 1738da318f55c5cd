// TLS as a Client does it, for those who make connections of their own beside one. Nobody else needs this.
#pragma once

#include <memory>
#include <string>
#include <system_error>

#include <talus/client/error.h>
#include <talus/client/options.h>

struct ssl_ctx_st;  // OpenSSL's SSL_CTX
struct ssl_st;      // and SSL

namespace talus::client {

/// May be shared by connections of all threads.
using TlsContext = std::shared_ptr<ssl_ctx_st>;

struct FreeTls {
  void operator()(ssl_st* tls) const;
};
using Tls = std::unique_ptr<ssl_st, FreeTls>;

/// TLS 1.3, and whom to trust. An error says what is wrong with options.ca_file.
[[nodiscard]] Result<TlsContext> make_tls_context(const TlsOptions& options);

/// The client's side of one connection, which expects the server that the options name, or `host`.
[[nodiscard]] Tls new_tls(const TlsContext& context, const TlsOptions& options, const std::string& host);

/// Why the handshake failed with `error`, as the end of "HOST:PORT: ...".
[[nodiscard]] ClientError handshake_failure(const ssl_st* tls, const std::error_code& error);

}  // namespace talus::client
