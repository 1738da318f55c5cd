#include "cluster/jetstream/credentials.h"

#include <utility>

#include <fmt/format.h>

#include <talus/files/read_file.h>

#include "cluster/jetstream/nkey.h"
#include "runtime/log/escape.h"

namespace talus::server::jetstream {
namespace {

constexpr KeyBounds kPasswordBounds{1, 1024, "the NATS servers have it"};
constexpr KeyBounds kSeedBounds{1, 128, "\"nk -gen user\" prints"};
constexpr KeyBounds kPemBounds{1, 8192, "a private key's PEM file has"};
constexpr std::size_t kMaxCertificateBytes = 1U << 20;  // five times all certificates of a system

/// Returns nullopt if no file is configured.
tl::expected<std::optional<Secret>, std::string> load_secret(std::string_view key,
                                                             const std::filesystem::path& file,
                                                             KeyBounds bounds,
                                                             std::vector<std::string>& warnings) {
  if (file.empty()) return std::nullopt;
  auto read = read_key_file(file, bounds);
  if (!read) return tl::unexpected{fmt::format("cluster.{}: {}", key, read.error())};
  if (read->warning) warnings.push_back(fmt::format("cluster.{}: {}", key, *read->warning));
  return std::move(read->secret);
}

/// Returns an empty string if no file is configured.
tl::expected<std::string, std::string> load_pem(std::string_view key, const std::filesystem::path& file) {
  if (file.empty()) return std::string{};
  auto read = files::read_regular_file(file, kMaxCertificateBytes);
  const auto wrong = [&](std::string_view what) {
    return tl::unexpected{fmt::format("cluster.{}: {}: {}", key, escaped(file.string(), 500), what)};
  };
  if (!read) return wrong(read.error().reason + "; name a PEM file that the user of talusd may read");
  if (read->find("-----BEGIN CERTIFICATE-----") == std::string::npos) {
    return wrong("holds no certificate; give a PEM file with \"-----BEGIN CERTIFICATE-----\"");
  }
  return *std::move(read);
}

}  // namespace

tl::expected<Credentials, std::string> load_credentials(const Cluster& cluster) {
  Credentials credentials;
  credentials.user = cluster.user;
  credentials.tls = cluster.nats.scheme() == "tls";
  struct SecretSetting {
    std::string_view key;
    const std::filesystem::path& file;
    KeyBounds bounds;
    std::optional<Secret>& secret;
  };
  for (const SecretSetting& wanted :
       {SecretSetting{"password_file", cluster.password_file, kPasswordBounds, credentials.password},
        SecretSetting{"token_file", cluster.token_file, kPasswordBounds, credentials.token},
        SecretSetting{"nkey_file", cluster.nkey_file, kSeedBounds, credentials.seed},
        SecretSetting{"key", cluster.key, kPemBounds, credentials.key}}) {
    auto loaded = load_secret(wanted.key, wanted.file, wanted.bounds, credentials.warnings);
    if (!loaded) return tl::unexpected{loaded.error()};
    if (*loaded) wanted.secret.emplace(**std::move(loaded));
  }
  // OpenSSL would prompt for the passphrase on the terminal.
  if (credentials.key && credentials.key->bytes().find("ENCRYPTED") != std::string_view::npos) {
    return tl::unexpected{fmt::format("cluster.key: {}: is encrypted; give a key without a passphrase",
                                      escaped(cluster.key.string(), 500))};
  }
  if (credentials.seed) {
    auto key = public_nkey(credentials.seed->bytes());
    if (!key) {
      return tl::unexpected{
          fmt::format("cluster.nkey_file: {}: {}", escaped(cluster.nkey_file.string(), 500), key.error())};
    }
    credentials.public_key = *std::move(key);
  }
  auto ca = load_pem("ca", cluster.ca);
  if (!ca) return tl::unexpected{ca.error()};
  auto certificate = load_pem("certificate", cluster.certificate);
  if (!certificate) return tl::unexpected{certificate.error()};
  credentials.ca = *std::move(ca);
  credentials.certificate = *std::move(certificate);
  return credentials;
}

}  // namespace talus::server::jetstream
