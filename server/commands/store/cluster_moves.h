// Moves a store from a single server into a cluster, back, or into a new stream if the cluster's stream is
// lost.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/settle.h>
#include <talus/store/data_directory.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include "cluster/log_stream.h"
#include "config/config.h"

namespace talus::server {

/// Access to the cluster's log for commands.
struct ClusterTools {
  /// Opens the stream of a store as configured in [cluster]; with `make` creates it if it is missing. An
  /// error is one line.
  std::function<tl::expected<std::unique_ptr<LogStream>, std::string>(const Cluster&, ContentHash store_id,
                                                                      bool make)>
      open;
  /// Rules by which loose material slides in a world.
  std::function<edits::SettleRules(const terrain::World&)> settle_rules;
};

// Each returns text to print; an error is one line. The caller must have locked the directory, so that the
// store is unused.

/// Starts a new stream from a single server's store, which keeps its id.
[[nodiscard]] tl::expected<std::string, std::string> join_cluster(const store::DataDirectory& directory,
                                                                  const Cluster& settings,
                                                                  const terrain::World& world,
                                                                  const ClusterTools& tools);

/// Takes the store out of the cluster at its current place, with a new id unless `keeps_id`.
[[nodiscard]] tl::expected<std::string, std::string> leave_cluster(const store::DataDirectory& directory,
                                                                   const Cluster& settings,
                                                                   const ClusterTools& tools, bool keeps_id,
                                                                   bool confirmed);

/// Starts a new stream from the store with a new id. The store loses what the old stream has beyond it.
[[nodiscard]] tl::expected<std::string, std::string> fork_cluster(const store::DataDirectory& directory,
                                                                  const Cluster& settings,
                                                                  const terrain::World& world,
                                                                  const ClusterTools& tools, bool confirmed);

}  // namespace talus::server
