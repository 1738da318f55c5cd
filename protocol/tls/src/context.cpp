#include <openssl/err.h>
#include <openssl/ssl.h>

#include <talus/tls/context.h>

namespace talus::tls {

void FreeHandle::operator()(ssl_st* handle) const {
  SSL_free(handle);
}

Context new_context(Role role) {
  ERR_clear_error();
  Context context{SSL_CTX_new(role == Role::server ? TLS_server_method() : TLS_client_method()),
                  SSL_CTX_free};
  if (context == nullptr || SSL_CTX_set_min_proto_version(context.get(), TLS1_3_VERSION) != 1) return nullptr;
  SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  // Frames carry lengths, so truncation is detected without TLS's help.
  SSL_CTX_set_options(context.get(), SSL_OP_NO_TICKET | SSL_OP_IGNORE_UNEXPECTED_EOF);
  // Writes proceed record by record; the rest may be at another address.
  SSL_CTX_set_mode(context.get(), SSL_MODE_RELEASE_BUFFERS | SSL_MODE_ENABLE_PARTIAL_WRITE |
                                      SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  return context;
}

std::string last_reason() {
  const char* const text = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return text == nullptr ? "" : text;
}

}  // namespace talus::tls
