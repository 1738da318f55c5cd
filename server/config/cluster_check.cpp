#include "config/cluster_check.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

constexpr std::size_t kIdDigits = 32;

bool is_store_id(std::string_view text) {
  return text.size() == kIdDigits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

tl::unexpected<std::string> conflict(std::string_view key, std::string_view what) {
  return tl::unexpected{fmt::format("cluster.{}: {}", key, what)};
}

tl::expected<void, std::string> check_credentials(const Cluster& cluster) {
  const int ways = (cluster.user.empty() ? 0 : 1) + (cluster.token_file.empty() ? 0 : 1) +
                   (cluster.nkey_file.empty() ? 0 : 1);
  if (ways > 1) {
    return conflict(cluster.token_file.empty() ? "nkey_file" : "token_file",
                    "is set and another credential is too; set one of user, token_file and nkey_file");
  }
  if (cluster.user.empty() != cluster.password_file.empty()) {
    return cluster.user.empty() ? conflict("password_file", "is set and user is not; set both, or neither")
                                : conflict("user", "is set and password_file is not; set both, or neither");
  }
  return {};
}

tl::expected<void, std::string> check_tls(const Cluster& cluster) {
  const bool tls = cluster.nats.scheme() == "tls";
  if (cluster.certificate.empty() != cluster.key.empty()) {
    return cluster.key.empty() ? conflict("certificate", "is set and key is not; set both, or neither")
                               : conflict("key", "is set and certificate is not; set both, or neither");
  }
  if (tls && cluster.ca.empty()) {
    return conflict(
        "ca",
        "is not set, and the addresses of cluster.nats are tls://; give the PEM file of the authorities that "
        "sign the NATS servers' certificates, such as /etc/ssl/certs/ca-certificates.crt");
  }
  if (!cluster.certificate.empty() && !tls) {
    return conflict("certificate", "needs TLS; write the addresses of cluster.nats as tls://HOST:PORT");
  }
  return {};
}

}  // namespace

tl::expected<void, std::string> check_cluster(const Cluster& cluster) {
  if (!cluster.store.empty() && !is_store_id(cluster.store)) {
    return conflict("store", fmt::format("\"{}\" is not the id of a store; give 32 hexadecimal digits, as "
                                         "\"talusd store stat\" prints them, or \"\"",
                                         escaped(cluster.store)));
  }
  if (cluster.replicas != 1 && cluster.replicas != 3 && cluster.replicas != 5) {
    return conflict("replicas", fmt::format("{} is wrong; give 1, 3 or 5", cluster.replicas));
  }
  if (auto done = check_credentials(cluster); !done) return done;
  if (cluster.nats.empty()) return {};
  return check_tls(cluster);
}

tl::expected<void, std::string> check_member(const Config& config) {
  const Cluster& cluster = config.cluster;
  if (auto done = check_cluster(cluster); !done) return done;
  if (!cluster.wanted()) return {};
  if (config.data.empty()) {
    return conflict("nats",
                    "is set and data is not; a server of a cluster keeps edits on its own disk too: "
                    "set data to a directory");
  }
  if (!cluster.peers.empty() && cluster.peers_token_file.empty()) {
    return conflict(
        "peers_token_file",
        "is not set, and peers is; give a file with a token of the right admin, which peers take");
  }
  return {};
}

}  // namespace talus::server
