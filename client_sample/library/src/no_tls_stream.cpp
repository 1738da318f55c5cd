// In place of tls.cpp and tls_stream.cpp where the library is built without OpenSSL (TALUS_TLS=OFF).
#include "tls_stream.h"

namespace talus::client {

Result<std::unique_ptr<TlsStream>> make_tls_stream(asio::ip::tcp::socket& /*socket*/,
                                                   const TlsOptions& /*options*/,
                                                   const std::string& /*host*/) {
  return tl::unexpected{ClientError{ErrorKind::untrusted, "this client was built without TLS", {}}};
}

}  // namespace talus::client
