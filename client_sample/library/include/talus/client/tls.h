// A Client's TLS layer, only for programs that open additional connections themselves.
#pragma once

#include <string>
#include <system_error>

#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/tls/context.h>

namespace talus::client {

/// Creates a TLS 1.3 context. An error states what is wrong with options.ca_file.
[[nodiscard]] Result<tls::Context> make_tls_context(const TlsOptions& options);

/// Creates the client side of one connection; it expects the server name in the options, or `host`.
[[nodiscard]] tls::Handle new_tls(const tls::Context& context, const TlsOptions& options,
                                  const std::string& host);

/// Describes why the handshake failed with `error`; the text completes "HOST:PORT: ...".
[[nodiscard]] ClientError handshake_failure(const ssl_st* tls, const std::error_code& error);

}  // namespace talus::client
