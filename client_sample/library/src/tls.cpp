#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <filesystem>
#include <new>
#include <system_error>

#include <talus/client/tls.h>

namespace talus::client {
namespace {

std::string last_reason() {
  const char* const text = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return text == nullptr ? "unknown" : text;
}

/// Gives the name to check; false where OpenSSL will not have it.
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
              (name   ? "; give the name that it was made for (TlsOptions::server_name; of the programs "
                        "--tls-name NAME)"
               : date ? "; the server's operator must renew it"
                      : "; give the certificate of who vouches for it (TlsOptions::ca_file; of the programs "
                        "--ca FILE)"),
          {}};
}

}  // namespace

void FreeTls::operator()(ssl_st* tls) const {
  SSL_free(tls);
}

Result<TlsContext> make_tls_context(const TlsOptions& options) {
  ERR_clear_error();
  TlsContext context{SSL_CTX_new(TLS_client_method()), SSL_CTX_free};
  if (context == nullptr || SSL_CTX_set_min_proto_version(context.get(), TLS1_3_VERSION) != 1) {
    return tl::unexpected{ClientError{ErrorKind::untrusted, "TLS 1.3: " + last_reason(), {}}};
  }
  std::error_code ignored;
  if (!options.ca_file.empty() && std::filesystem::exists(options.ca_file, ignored) &&
      !std::filesystem::is_regular_file(options.ca_file, ignored)) {
    return tl::unexpected{
        ClientError{ErrorKind::untrusted,
                    options.ca_file + ": is no regular file; give a PEM file of those to trust",
                    {}}};
  }
  const bool trusted = options.ca_file.empty()
                           ? SSL_CTX_set_default_verify_paths(context.get()) == 1
                           : SSL_CTX_load_verify_file(context.get(), options.ca_file.c_str()) == 1;
  if (!trusted) {
    return tl::unexpected{ClientError{ErrorKind::untrusted,
                                      options.ca_file + ": cannot be read as certificates: " + last_reason() +
                                          "; give a PEM file of those to trust",
                                      {}}};
  }
  SSL_CTX_set_verify(context.get(), options.verify ? SSL_VERIFY_PEER : SSL_VERIFY_NONE, nullptr);
  // Frames have lengths, so a connection cut short is seen without TLS's help.
  SSL_CTX_set_options(context.get(), SSL_OP_NO_TICKET | SSL_OP_IGNORE_UNEXPECTED_EOF);
  SSL_CTX_set_session_cache_mode(context.get(), SSL_SESS_CACHE_OFF);
  SSL_CTX_set_mode(context.get(), SSL_MODE_RELEASE_BUFFERS | SSL_MODE_ENABLE_PARTIAL_WRITE |
                                      SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
  return context;
}

Tls new_tls(const TlsContext& context, const TlsOptions& options, const std::string& host) {
  Tls tls{SSL_new(context.get())};
  if (tls == nullptr) throw std::bad_alloc{};
  if (!expect(tls.get(), options.server_name.empty() ? host : options.server_name)) {
    // No name is left to be right: the handshake fails rather than trust anybody.
    ERR_clear_error();
    SSL_set1_host(tls.get(), "invalid.");
  }
  SSL_set_connect_state(tls.get());
  return tls;
}

ClientError handshake_failure(const ssl_st* tls, const std::error_code& error) {
  if (const long verified = SSL_get_verify_result(tls); verified != X509_V_OK) return untrusted(verified);
  const auto code = static_cast<unsigned long>(error.value());
  if (ERR_GET_LIB(code) == ERR_LIB_SSL && ERR_GET_REASON(code) == SSL_R_WRONG_VERSION_NUMBER) {
    return {ErrorKind::unreachable, "what answers there does not speak TLS; connect without it", {}};
  }
  return {ErrorKind::unreachable, "the TLS handshake failed: " + error.message(), {}};
}

}  // namespace talus::client
