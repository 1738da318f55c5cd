#include "certificates.h"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <memory>
#include <stdexcept>

namespace {

void must(bool done) {
  if (!done) throw std::runtime_error{"OpenSSL makes no certificate"};
}

template <typename Write>
std::string pem(Write write) {
  const std::unique_ptr<BIO, decltype(&BIO_free)> bio{BIO_new(BIO_s_mem()), BIO_free};
  must(write(bio.get()) == 1);
  char* text = nullptr;
  const long bytes = BIO_get_mem_data(bio.get(), &text);
  return {text, static_cast<std::size_t>(bytes)};
}

void add_extension(X509* certificate, int kind, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, certificate, certificate, nullptr, nullptr, 0);
  const std::unique_ptr<X509_EXTENSION, decltype(&X509_EXTENSION_free)> extension{
      X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()), X509_EXTENSION_free};
  must(extension != nullptr && X509_add_ext(certificate, extension.get(), -1) == 1);
}

}  // namespace

TestCertificate make_certificate(long serial, const std::string& name, int hours, const char* curve) {
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key{EVP_EC_gen(curve), EVP_PKEY_free};
  const std::unique_ptr<X509, decltype(&X509_free)> made{X509_new(), X509_free};
  must(key != nullptr && made != nullptr);
  X509* const certificate = made.get();
  X509_set_version(certificate, X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(certificate), serial);
  constexpr long kHour = 3600;
  X509_gmtime_adj(X509_getm_notBefore(certificate), (hours < 0 ? 2 * hours : -1) * kHour);
  X509_gmtime_adj(X509_getm_notAfter(certificate), hours * kHour);
  X509_NAME* const subject = X509_get_subject_name(certificate);
  must(X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC,
                                  reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1, 0) == 1);
  X509_set_issuer_name(certificate, subject);
  X509_set_pubkey(certificate, key.get());
  add_extension(certificate, NID_basic_constraints, "critical,CA:TRUE");
  add_extension(certificate, NID_subject_alt_name,
                "DNS:" + name + (name == "localhost" ? ",IP:127.0.0.1" : ""));
  must(X509_sign(certificate, key.get(), EVP_sha256()) > 0);
  return {pem([&](BIO* bio) { return PEM_write_bio_X509(bio, certificate); }), pem([&](BIO* bio) {
            return PEM_write_bio_PrivateKey(bio, key.get(), nullptr, nullptr, 0, nullptr, nullptr);
          })};
}

void use_certificate(ssl_ctx_st* context, const TestCertificate& certificate) {
  const auto bio = [](const std::string& text) {
    return std::unique_ptr<BIO, decltype(&BIO_free)>{
        BIO_new_mem_buf(text.data(), static_cast<int>(text.size())), BIO_free};
  };
  const auto certificate_pem = bio(certificate.certificate);
  const auto key_pem = bio(certificate.key);
  const std::unique_ptr<X509, decltype(&X509_free)> own{
      PEM_read_bio_X509(certificate_pem.get(), nullptr, nullptr, nullptr), X509_free};
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key{
      PEM_read_bio_PrivateKey(key_pem.get(), nullptr, nullptr, nullptr), EVP_PKEY_free};
  must(SSL_CTX_use_cert_and_key(context, own.get(), key.get(), nullptr, 1) == 1);
}
