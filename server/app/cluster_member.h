// What makes a talusd a server of a cluster: how it reaches the log that all share, and its peers.
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

/// What the files of [cluster] hold. They are read before root's rights are dropped.
struct ClusterKeys {
  std::shared_ptr<const jetstream::Credentials> nats;
  std::optional<Secret> peers_token;
  std::vector<std::string> warnings;  // one line each
};

/// An error is one line that begins with a key.
[[nodiscard]] tl::expected<ClusterKeys, std::string> load_cluster_keys(const Cluster& settings);

/// The log of a store. Whether a NATS server can be reached turns out later.
[[nodiscard]] tl::expected<std::unique_ptr<LogStream>, std::string> open_shared_log(const Cluster& settings,
                                                                                    const ClusterKeys& keys,
                                                                                    ContentHash store_id,
                                                                                    Logger log);

/// What "talusd store" needs of it.
[[nodiscard]] ClusterTools cluster_tools();

/// Makes the store in `directory` ready, as cluster/join/prepare_store.h says, and returns its log. Waits as
/// long as neither log nor peers can be reached. An error is one line.
[[nodiscard]] tl::expected<join::Prepared, std::string> prepare_member(
    const Cluster& settings, const ClusterKeys& keys, store::DataDirectory& directory,
    ContentHash fingerprint, const OnJoining& on_joining,
    const std::function<void(const std::optional<AsideStore>&)>& on_aside, Logger log);

}  // namespace talus::server
