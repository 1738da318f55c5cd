// A store that moves from one machine into a cluster, back, or into another one where the cluster's stream is
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

/// What the commands need of the cluster's log.
struct ClusterTools {
  /// The stream of a store, as [cluster] reaches it; with `make` it is made where it is missing. An error is
  /// one line.
  std::function<tl::expected<std::unique_ptr<LogStream>, std::string>(const Cluster&, ContentHash store_id,
                                                                      bool make)>
      open;
  /// By which loose material slides in a world.
  std::function<edits::SettleRules(const terrain::World&)> settle_rules;
};

// Each returns what to print; an error is one line. The directory is locked by the caller, and nobody uses
// its store.

/// The store of one machine begins a new stream, under its own id.
[[nodiscard]] tl::expected<std::string, std::string> join_cluster(const store::DataDirectory& directory,
                                                                  const Cluster& settings,
                                                                  const terrain::World& world,
                                                                  const ClusterTools& tools);

/// The store is one machine's again, at the place that it has reached; under a new id, unless `keeps_id`.
[[nodiscard]] tl::expected<std::string, std::string> leave_cluster(const store::DataDirectory& directory,
                                                                   const Cluster& settings,
                                                                   const ClusterTools& tools, bool keeps_id,
                                                                   bool confirmed);

/// The store begins a new stream, under a new id: what the old stream has beyond it is lost for it.
[[nodiscard]] tl::expected<std::string, std::string> fork_cluster(const store::DataDirectory& directory,
                                                                  const Cluster& settings,
                                                                  const terrain::World& world,
                                                                  const ClusterTools& tools, bool confirmed);

}  // namespace talus::server
