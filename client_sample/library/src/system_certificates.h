// The certificates that the operating system trusts.
#pragma once

struct ssl_ctx_st;  // OpenSSL's SSL_CTX

namespace talus::client {

/// Returns false if OpenSSL fails; it has queued the error. A system without certificates is no failure.
[[nodiscard]] bool trust_system_certificates(ssl_ctx_st* context);

}  // namespace talus::client
