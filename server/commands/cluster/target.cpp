#include "commands/cluster/target.h"

#include <filesystem>

#include <fmt/format.h>

#include <talus/store/store_identity.h>

#include "config/cluster_check.h"

namespace talus::server::cluster_tool {
namespace {

/// Reads the data directory's store id; nullopt if it has no store.
tl::expected<std::optional<ContentHash>, std::string> store_of(const std::filesystem::path& data) {
  if (data.empty()) return std::nullopt;
  const std::filesystem::path file = data / "store.toml";
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  const auto identity = store::read_store_identity(file);
  if (!identity) return tl::unexpected{identity.error()};
  return identity->store_id;
}

tl::expected<Target, std::string> target_of(const Config& config, bool may_be_new) {
  const Cluster& cluster = config.cluster;
  const auto here = store_of(config.data);
  if (!here) return tl::unexpected{here.error()};
  const auto named = store::parse_hash(cluster.store);
  if (named && *here && *named != **here) {
    return tl::unexpected{
        fmt::format("cluster.store: {} is not the store of the data directory {}, which is {}; name that, or "
                    "another directory",
                    to_string(*named), config.data.string(), to_string(**here))};
  }
  if (may_be_new && !named && *here) {
    return tl::unexpected{
        fmt::format("the data directory {} has a store; \"talusd store join-cluster\" takes it into a "
                    "cluster with what it "
                    "holds, and --store ID begins a world of its own",
                    config.data.string())};
  }
  if (!named && !*here && !may_be_new) {
    return tl::unexpected{
        std::string{"cluster.store: is not set, and the data directory has no store; give --store ID, as "
                    "\"talusd cluster init\" printed it"}};
  }
  auto credentials = jetstream::load_credentials(cluster);
  if (!credentials) return tl::unexpected{credentials.error()};
  const ContentHash id = named ? *named : *here ? **here : store::random_store_id();
  return Target{cluster.nats,
                std::make_shared<const jetstream::Credentials>(*std::move(credentials)),
                id,
                jetstream::StreamNames::of(id),
                cluster.replicas,
                config.admin};
}

}  // namespace

tl::expected<void, std::string> check_target(const Config& config) {
  if (!config.cluster.wanted()) {
    return tl::unexpected{std::string{
        "cluster.nats: names no NATS server; give --config with [cluster] in it, or TALUS_CLUSTER_NATS"}};
  }
  return check_cluster(config.cluster);
}

tl::expected<Target, std::string> Target::of(const Config& config) {
  return target_of(config, false);
}

tl::expected<Target, std::string> Target::for_init(const Config& config) {
  return target_of(config, true);
}

tl::expected<std::shared_ptr<jetstream::Connection>, StreamFailure> Target::connect() const {
  return jetstream::Connection::open(urls, credentials, nullptr, jetstream::Retry::never);
}

}  // namespace talus::server::cluster_tool
