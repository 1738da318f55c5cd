// Replaces tls.cpp and tls_stream.cpp if the library is built without OpenSSL (TALUS_TLS=OFF).
#include "tls_stream.h"

namespace talus::client {

Result<std::unique_ptr<TlsStream>> make_tls_stream(asio::ip::tcp::socket& /*socket*/,
                                                   const TlsOptions& /*options*/,
                                                   const std::string& /*host*/) {
  return tl::unexpected{ClientError{ErrorKind::untrusted, "this client was built without TLS", {}}};
}

}  // namespace talus::client
