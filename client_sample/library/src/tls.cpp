#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <filesystem>
#include <new>
#include <system_error>

#include <talus/client/tls.h>

#include "system_certificates.h"

namespace talus::client {
namespace {

/// Sets the name to verify; returns false if OpenSSL rejects it.
bool expect(SSL* tls, const std::string& name) {
  if (X509_VERIFY_PARAM_set1_ip_asc(SSL_get0_param(tls), name.c_str()) == 1) return true;
  ERR_clear_error();
  SSL_set_hostflags(tls, X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS);
  return SSL_set1_host(tls, name.c_str()) == 1 && SSL_set_tlsext_host_name(tls, name.c_str()) == 1;
}

ClientError untrusted(long result) {
  const bool name = result == X509_V_ERR_HOSTNAME_MISMATCH || result == X509_V_ERR_IP_ADDRESS_MISMATCH;
  const bool date = result == X509_V_ERR_CERT_HAS_EXPIRED || result == X509_V_ERR_CERT_NOT_YET_VALID;
  return {ErrorKind::untrusted,
          std::string{"certificate verify failed: "} + X509_verify_cert_error_string(result) +
              (name   ? "; give the name that it was made for (TlsOptions::server_name; in the programs "
                        "--tls-name NAME)"
               : date ? "; the server's operator must renew it"
                      : "; give its issuer's certificate (TlsOptions::ca_file; in the programs --ca FILE)"),
          {}};
}

}  // namespace

Result<tls::Context> make_tls_context(const TlsOptions& options) {
  tls::Context context = tls::new_context(tls::Role::client);
  if (context == nullptr) {
    return tl::unexpected{ClientError{ErrorKind::untrusted, "TLS 1.3: " + tls::last_reason(), {}}};
  }
  std::error_code ignored;
  const std::filesystem::path file{std::u8string{options.ca_file.begin(), options.ca_file.end()}};
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
    return tl::unexpected{
        ClientError{ErrorKind::untrusted,
                    options.ca_file + ": is not a regular file; give a PEM file of trusted certificates",
                    {}}};
  }
  const bool trusted = options.ca_file.empty()
                           ? trust_system_certificates(context.get())
                           : SSL_CTX_load_verify_file(context.get(), options.ca_file.c_str()) == 1;
  if (!trusted) {
    return tl::unexpected{ClientError{ErrorKind::untrusted,
                                      options.ca_file + ": cannot be read as certificates: " +
                                          tls::last_reason() + "; give a PEM file of trusted certificates",
                                      {}}};
  }
  SSL_CTX_set_verify(context.get(), options.verify ? SSL_VERIFY_PEER : SSL_VERIFY_NONE, nullptr);
  return context;
}

tls::Handle new_tls(const tls::Context& context, const TlsOptions& options, const std::string& host) {
  tls::Handle handle{SSL_new(context.get())};
  if (handle == nullptr) throw std::bad_alloc{};
  if (!expect(handle.get(), options.server_name.empty() ? host : options.server_name)) {
    // No valid name to verify: make the handshake fail rather than trust any server.
    ERR_clear_error();
    SSL_set1_host(handle.get(), "invalid.");
  }
  SSL_set_connect_state(handle.get());
  return handle;
}

ClientError handshake_failure(const ssl_st* tls, const std::error_code& error) {
  if (const long verified = SSL_get_verify_result(tls); verified != X509_V_OK) return untrusted(verified);
  const auto code = static_cast<unsigned long>(error.value());
  if (ERR_GET_LIB(code) == ERR_LIB_SSL && ERR_GET_REASON(code) == SSL_R_WRONG_VERSION_NUMBER) {
    return {ErrorKind::unreachable, "the peer does not speak TLS; connect without it", {}};
  }
  return {ErrorKind::unreachable, "the TLS handshake failed: " + error.message(), {}};
}

}  // namespace talus::client
