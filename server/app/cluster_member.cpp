#include "app/cluster_member.h"

#include <thread>
#include <utility>

#include <talus/local/settle_rules.h>
#include <talus/store/store_identity.h>

#include "cluster/jetstream/jetstream_log.h"
#include "cluster/jetstream/stream_admin.h"
#include "cluster/join/prepare_store.h"

namespace talus::server {
namespace {

constexpr KeyBounds kPeersTokenBounds{1, 4096};

/// Creates the stream if it is missing.
tl::expected<void, std::string> ensure_stream(const Cluster& settings, const ClusterKeys& keys,
                                              ContentHash store_id) {
  const auto connection =
      jetstream::Connection::open(settings.nats, keys.nats, nullptr, jetstream::Retry::never);
  if (!connection) return tl::unexpected{connection.error().reason};
  const auto present =
      jetstream::ensure_stream(**connection, jetstream::StreamNames::of(store_id), settings.replicas);
  if (!present) return tl::unexpected{present.error()};
  return {};
}

}  // namespace

tl::expected<ClusterKeys, std::string> load_cluster_keys(const Cluster& settings) {
  auto credentials = jetstream::load_credentials(settings);
  if (!credentials) return tl::unexpected{std::move(credentials.error())};
  ClusterKeys keys;
  keys.warnings = std::move(credentials->warnings);
  keys.nats = std::make_shared<const jetstream::Credentials>(*std::move(credentials));
  if (!settings.peers_token_file.empty()) {
    auto token = read_key_file(settings.peers_token_file, kPeersTokenBounds);
    if (!token) return tl::unexpected{"cluster.peers_token_file: " + token.error()};
    keys.peers_token.emplace(std::move(token->secret));
    if (token->warning) keys.warnings.push_back(*std::move(token->warning));
  }
  return keys;
}

tl::expected<std::unique_ptr<LogStream>, std::string> open_shared_log(const Cluster& settings,
                                                                      const ClusterKeys& keys,
                                                                      ContentHash store_id, Logger log) {
  auto opened = jetstream::JetStreamLog::open(
      {settings.nats, jetstream::StreamNames::of(store_id), settings.replicas}, keys.nats, std::move(log));
  if (!opened) return tl::unexpected{std::move(opened.error().reason)};
  return std::unique_ptr<LogStream>{*std::move(opened)};
}

ClusterTools cluster_tools() {
  ClusterTools tools;
  tools.open = [](const Cluster& settings, ContentHash store_id,
                  bool make) -> tl::expected<std::unique_ptr<LogStream>, std::string> {
    const auto keys = load_cluster_keys(settings);
    if (!keys) return tl::unexpected{keys.error()};
    if (make) {
      if (auto there = ensure_stream(settings, *keys, store_id); !there) return tl::unexpected{there.error()};
    }
    return open_shared_log(settings, *keys, store_id, make_logger("off", "text"));
  };
  tools.settle_rules = local::settle_rules;
  return tools;
}

tl::expected<join::PreparedStore, std::string> prepare_member(
    const Cluster& settings, const ClusterKeys& keys, store::DataDirectory& directory,
    ContentHash fingerprint, const OnJoining& on_joining,
    const std::function<void(const std::optional<AsideStore>&)>& on_aside, Logger log) {
  PeerAccess access;
  if (keys.peers_token) access.token = keys.peers_token->bytes();
  access.ca = keys.nats->ca;
  access.certificate = keys.nats->certificate;
  if (keys.nats->key) access.key = keys.nats->key->bytes();
  return join::prepare_store(
      {directory,
       fingerprint,
       store::parse_hash(settings.store),
       {{settings.peers.begin(), settings.peers.end()}, std::move(access)},
       [&](ContentHash store_id) { return open_shared_log(settings, keys, store_id, log); },
       log,
       on_joining,
       [](std::chrono::milliseconds wait) {
         std::this_thread::sleep_for(wait);  // a signal ends the process
         return true;
       },
       on_aside});
}

}  // namespace talus::server
