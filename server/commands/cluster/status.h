// State of the stream, and of this server's progress in it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cluster/jetstream/stream_info.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

struct ClusterStatus {
  std::string stream;
  std::string store;
  jetstream::StreamInfo info;
  /// This server's metrics talus_cluster_*, without that prefix; nullopt if it does not run.
  std::optional<std::map<std::string, double>> here;
  std::string not_here;  // why `here` is empty
  std::string state{};   // its answer to /-/ready
  bool ready = false;
};

/// An error is one line.
[[nodiscard]] tl::expected<ClusterStatus, std::string> read_status(const Target& target);

/// Extracts the cluster metrics of a page /metrics.
[[nodiscard]] std::map<std::string, double> cluster_metrics(std::string_view page);

[[nodiscard]] std::string status_lines(const ClusterStatus& status);
[[nodiscard]] std::string status_json(const ClusterStatus& status);

}  // namespace talus::server::cluster_tool
