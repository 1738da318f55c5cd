#include "system_certificates.h"

#include <windows.h>

#include <wincrypt.h>

#include <memory>

// After wincrypt.h, whose macros have some of its names.
#include <openssl/err.h>
#include <openssl/ssl.h>

namespace talus::client {
namespace {

constexpr DWORD kOpen = CERT_STORE_READONLY_FLAG | CERT_SYSTEM_STORE_CURRENT_USER;

struct CloseStore {
  void operator()(void* store) const { ::CertCloseStore(store, 0); }
};

}  // namespace

// The user's store includes the machine's. OpenSSL 3.0 does not read it by itself (3.2 does).
bool trust_system_certificates(ssl_ctx_st* context) {
  const std::unique_ptr<void, CloseStore> roots{
      ::CertOpenStore(CERT_STORE_PROV_SYSTEM_W, 0, 0, kOpen, L"ROOT")};
  if (roots == nullptr) return true;
  X509_STORE* const trusted = SSL_CTX_get_cert_store(context);
  const CERT_CONTEXT* root = nullptr;
  while ((root = ::CertEnumCertificatesInStore(roots.get(), root)) != nullptr) {
    const unsigned char* bytes = root->pbCertEncoded;
    X509* const certificate = d2i_X509(nullptr, &bytes, static_cast<long>(root->cbCertEncoded));
    if (certificate == nullptr) {
      ERR_clear_error();  // one that OpenSSL cannot read is not trusted
      continue;
    }
    const bool added = X509_STORE_add_cert(trusted, certificate) == 1;
    X509_free(certificate);
    if (!added) {
      ::CertFreeCertificateContext(root);
      return false;
    }
  }
  return true;
}

}  // namespace talus::client
