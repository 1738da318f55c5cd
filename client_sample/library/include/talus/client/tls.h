// TLS as a Client does it, for those who make connections of their own beside one. Nobody else needs this.
#pragma once

#include <string>
#include <system_error>

#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/tls/context.h>

namespace talus::client {

/// Their names in 0.1; they go with 0.3.
using TlsContext [[deprecated("its name is talus::tls::Context")]] = tls::Context;
using Tls [[deprecated("its name is talus::tls::Handle")]] = tls::Handle;
using FreeTls [[deprecated("its name is talus::tls::FreeHandle")]] = tls::FreeHandle;

/// TLS 1.3, and whom to trust. An error says what is wrong with options.ca_file.
[[nodiscard]] Result<tls::Context> make_tls_context(const TlsOptions& options);

/// The client's side of one connection, which expects the server that the options name, or `host`.
[[nodiscard]] tls::Handle new_tls(const tls::Context& context, const TlsOptions& options,
                                  const std::string& host);

/// Why the handshake failed with `error`, as the end of "HOST:PORT: ...".
[[nodiscard]] ClientError handshake_failure(const ssl_st* tls, const std::error_code& error);

}  // namespace talus::client
