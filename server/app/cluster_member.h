// Connects a talusd to its cluster: the log that all servers share, and the peers.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>

#include "cluster/checkpoint/from_peers.h"
#include "cluster/jetstream/credentials.h"
#include "cluster/join/prepare_store.h"
#include "cluster/log_stream.h"
#include "commands/store/cluster_moves.h"
#include "config/access/key_file.h"
#include "config/config.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Contents of the files of [cluster], read before root privileges are dropped.
struct ClusterKeys {
  std::shared_ptr<const jetstream::Credentials> nats;
  std::optional<Secret> peers_token;
  std::vector<std::string> warnings;  // one line each
};

/// An error is one line that begins with a key.
[[nodiscard]] tl::expected<ClusterKeys, std::string> load_cluster_keys(const Cluster& settings);

/// Opens the log of a store without testing whether NATS can be reached.
[[nodiscard]] tl::expected<std::unique_ptr<LogStream>, std::string> open_shared_log(const Cluster& settings,
                                                                                    const ClusterKeys& keys,
                                                                                    ContentHash store_id,
                                                                                    Logger log);

/// The cluster functions that "talusd store" uses.
[[nodiscard]] ClusterTools cluster_tools();

/// Prepares the store in `directory` (cluster/join/prepare_store.h) and returns its log. Waits as long as
/// neither the log nor a peer can be reached. An error is one line.
[[nodiscard]] tl::expected<join::PreparedStore, std::string> prepare_member(
    const Cluster& settings, const ClusterKeys& keys, store::DataDirectory& directory,
    ContentHash fingerprint, const OnJoining& on_joining,
    const std::function<void(const std::optional<AsideStore>&)>& on_aside, Logger log);

}  // namespace talus::server
