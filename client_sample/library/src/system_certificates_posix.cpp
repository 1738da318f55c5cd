#include "system_certificates.h"

#include <openssl/ssl.h>

namespace talus::client {

bool trust_system_certificates(ssl_ctx_st* context) {
  return SSL_CTX_set_default_verify_paths(context) == 1;
}

}  // namespace talus::client
