#include "net/tls_context.h"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <time.h>

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include <talus/files/secret_file.h>

#include "runtime/log/escape.h"
#include "runtime/log/utc_time.h"

namespace talus::server {
namespace {

constexpr std::size_t kMaxPemBytes = 1'000'000;
constexpr const char* kCiphers = "TLS_AES_128_GCM_SHA256:TLS_AES_256_GCM_SHA384:TLS_CHACHA20_POLY1305_SHA256";
constexpr const char* kGroups = "X25519:P-256:P-384";

template <auto free>
struct Free {
  template <typename T>
  void operator()(T* held) const {
    free(held);
  }
};
using Bio = std::unique_ptr<BIO, Free<BIO_free>>;
using Certificate = std::unique_ptr<X509, Free<X509_free>>;
using PrivateKey = std::unique_ptr<EVP_PKEY, Free<EVP_PKEY_free>>;

struct FreeChain {
  void operator()(STACK_OF(X509) * chain) const { sk_X509_pop_free(chain, X509_free); }
};
using Chain = std::unique_ptr<STACK_OF(X509), FreeChain>;

std::string reason() {
  const std::string text = tls::last_reason();
  return text.empty() ? "OpenSSL refuses it" : text;
}

tl::unexpected<std::string> wrong(std::string_view setting, const std::filesystem::path& file,
                                  std::string_view what) {
  return tl::make_unexpected(fmt::format("{} {}: {}", setting, escaped(file.string(), 500), what));
}

/// Never prompts on the terminal: a server has no user to ask.
int no_passphrase(char*, int, int, void* asked) {
  *static_cast<bool*>(asked) = true;
  return -1;
}

struct CertificateFile {
  Certificate certificate;
  Chain chain;
};

tl::expected<files::SecretFile, std::string> read_pem(std::string_view setting,
                                                      const std::filesystem::path& file) {
  auto pem = files::SecretFile::read(file, kMaxPemBytes);
  if (pem) return *std::move(pem);
  return wrong(setting, file, pem.error().reason + "; give a PEM file that talusd may read");
}

Bio bio_of(const files::SecretFile& pem) {
  return Bio{BIO_new_mem_buf(pem.text().data(), static_cast<int>(pem.text().size()))};
}

tl::expected<CertificateFile, std::string> read_certificate(const std::filesystem::path& file) {
  constexpr std::string_view kSetting = "tls.certificate";
  const auto pem = read_pem(kSetting, file);
  if (!pem) return tl::make_unexpected(pem.error());
  const Bio bio = bio_of(*pem);
  bool asked = false;
  CertificateFile read{Certificate{PEM_read_bio_X509(bio.get(), nullptr, no_passphrase, &asked)},
                       Chain{sk_X509_new_null()}};
  const std::string failure = read.certificate ? "" : reason();
  if (!read.certificate) {
    return wrong(kSetting, file,
                 fmt::format("holds no certificate ({}); give a PEM file with the server's certificate and "
                             "then its issuers' certificates",
                             failure));
  }
  while (X509* const next = PEM_read_bio_X509(bio.get(), nullptr, no_passphrase, &asked)) {
    sk_X509_push(read.chain.get(), next);
  }
  if (ERR_GET_REASON(ERR_peek_last_error()) != PEM_R_NO_START_LINE) {
    return wrong(kSetting, file,
                 fmt::format("certificate {} in it is damaged ({}); copy it anew",
                             sk_X509_num(read.chain.get()) + 2, reason()));
  }
  ERR_clear_error();
  return read;
}

tl::expected<PrivateKey, std::string> read_key(const std::filesystem::path& file) {
  constexpr std::string_view kSetting = "tls.key";
  const auto pem = read_pem(kSetting, file);
  if (!pem) return tl::make_unexpected(pem.error());
  bool asked = false;
  const Bio bio = bio_of(*pem);
  PrivateKey key{PEM_read_bio_PrivateKey(bio.get(), nullptr, no_passphrase, &asked)};
  if (asked) {
    ERR_clear_error();
    return wrong(kSetting, file,
                 "is encrypted with a passphrase; remove that with openssl pkey, and let only talusd's user "
                 "read the file");
  }
  if (!key) {
    ERR_clear_error();
    return wrong(kSetting, file,
                 "holds no private key that can be read; give the PEM file with the key of tls.certificate");
  }
  return key;
}

std::int64_t seconds_since_1970(const ASN1_TIME* time) {
  tm broken_down{};
  return ASN1_TIME_to_tm(time, &broken_down) == 1 ? ::timegm(&broken_down) : 0;
}

tl::expected<tls::Context, std::string> new_context() {
  tls::Context context = tls::new_context(tls::Role::server);
  const bool made = context != nullptr && SSL_CTX_set_ciphersuites(context.get(), kCiphers) == 1 &&
                    SSL_CTX_set1_groups_list(context.get(), kGroups) == 1 &&
                    SSL_CTX_set_num_tickets(context.get(), 0) == 1;
  if (!made)
    return tl::make_unexpected(fmt::format("TLS: this OpenSSL cannot do what is needed: {}", reason()));
  // A client with fast AES gets the first cipher; one that prefers ChaCha20 gets ChaCha20.
  SSL_CTX_set_options(context.get(), SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION |
                                         SSL_OP_CIPHER_SERVER_PREFERENCE | SSL_OP_PRIORITIZE_CHACHA);
  // After a record without data (e.g. a key update) other handlers of the thread run.
  SSL_CTX_clear_mode(context.get(), SSL_MODE_AUTO_RETRY);
  return context;
}

/// A client that accepts what this server offers, whatever the machine's openssl.cnf prescribes.
tls::Context new_client_context() {
  tls::Context client = tls::new_context(tls::Role::client);
  const bool made = client != nullptr && SSL_CTX_set_max_proto_version(client.get(), TLS1_3_VERSION) == 1 &&
                    SSL_CTX_set_ciphersuites(client.get(), kCiphers) == 1 &&
                    SSL_CTX_set1_groups_list(client.get(), kGroups) == 1;
  if (!made) return nullptr;
  SSL_CTX_set_verify(client.get(), SSL_VERIFY_NONE, nullptr);
  return client;
}

/// Returns true if a client and the server complete a handshake in memory. A key of a kind that TLS 1.3
/// cannot sign with, or restricted to an algorithm that no client offers, loads but fails every handshake.
bool shakes_hands(SSL_CTX* context) {
  const tls::Context clients = new_client_context();
  const tls::Handle client{clients ? SSL_new(clients.get()) : nullptr};
  const tls::Handle server{SSL_new(context)};
  BIO* to_server = nullptr;
  BIO* to_client = nullptr;
  if (!client || !server || BIO_new_bio_pair(&to_server, 0, &to_client, 0) != 1) return false;
  SSL_set_bio(client.get(), to_server, to_server);
  SSL_set_bio(server.get(), to_client, to_client);
  SSL_set_connect_state(client.get());
  SSL_set_accept_state(server.get());
  // Each turn moves up to 17 KiB, the capacity of a pair; a client accepts chains of up to 100 KiB.
  for (int turn = 0; turn < 20; ++turn) {
    bool done = true;
    for (const tls::Handle* side : {&client, &server}) {
      ERR_clear_error();  // SSL_get_error considers the whole queue
      const int result = SSL_do_handshake(side->get());
      const int error = result == 1 ? SSL_ERROR_NONE : SSL_get_error(side->get(), result);
      if (error != SSL_ERROR_NONE && error != SSL_ERROR_WANT_READ && error != SSL_ERROR_WANT_WRITE)
        return false;
      done = done && result == 1;
    }
    if (done) return true;
  }
  return false;
}

}  // namespace

tl::expected<TlsIdentity, std::string> load_tls(const std::filesystem::path& certificate_file,
                                                const std::filesystem::path& key_file,
                                                std::chrono::sys_seconds wall) {
  ERR_clear_error();
  if (certificate_file.empty()) {
    return wrong("tls.key", key_file, "is set and tls.certificate is not; set both for TLS, or neither");
  }
  if (key_file.empty()) {
    return wrong("tls.certificate", certificate_file,
                 "is set and tls.key is not; set both for TLS, or neither");
  }
  auto certificate = read_certificate(certificate_file);
  if (!certificate) return tl::make_unexpected(certificate.error());
  const auto key = read_key(key_file);
  if (!key) return tl::make_unexpected(key.error());
  X509* const own = certificate->certificate.get();
  if (X509_check_private_key(own, key->get()) != 1) {
    ERR_clear_error();
    return wrong("tls.key", key_file,
                 fmt::format("is not the key of the certificate in {}; give the key that it was made with",
                             escaped(certificate_file.string(), 500)));
  }
  auto context = new_context();
  if (!context) return tl::make_unexpected(context.error());
  if (SSL_CTX_use_cert_and_key(context->get(), own, key->get(), certificate->chain.get(), 1) != 1) {
    return wrong("tls.certificate", certificate_file,
                 fmt::format("cannot be used: {}; make one with a P-256 or RSA-2048 key", reason()));
  }
  if (X509_check_purpose(own, X509_PURPOSE_SSL_SERVER, 0) != 1) {
    ERR_clear_error();
    return wrong("tls.certificate", certificate_file,
                 "is not for servers, by its key usages; give one with serverAuth among its extended usages, "
                 "or without extended usages");
  }
  if (!shakes_hands(context->get())) {
    return wrong("tls.key", key_file,
                 fmt::format("makes no handshake by TLS 1.3, with tls.certificate: {}; a key of RSA, P-256, "
                             "P-384, P-521 or Ed25519 and a chain of "
                             "less than 100 KiB do",
                             reason()));
  }
  const std::int64_t begins = seconds_since_1970(X509_get0_notBefore(own));
  const std::int64_t expires = seconds_since_1970(X509_get0_notAfter(own));
  const auto now = std::chrono::system_clock::to_time_t(wall);
  return TlsIdentity{
      *std::move(context),
      fmt::format("certificate of {}, valid until {} UTC", escaped(certificate_file.string(), 500),
                  utc_time(std::chrono::sys_seconds{std::chrono::seconds{expires}}, "%Y-%m-%d %H:%M")),
      expires, begins <= now && now < expires};
}

}  // namespace talus::server
