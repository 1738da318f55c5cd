// How the stream is, and how far this server has read it.
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
  /// This server's metrics talus_cluster_*, without that part of their names; none where it does not run.
  std::optional<std::map<std::string, double>> here;
  std::string not_here;  // why there are none
  std::string state{};   // what it says of itself at /-/ready
  bool ready = false;
};

/// An error is one line.
[[nodiscard]] tl::expected<ClusterStatus, std::string> read_status(const Target& target);

/// Those of a page /metrics.
[[nodiscard]] std::map<std::string, double> cluster_metrics(std::string_view page);

[[nodiscard]] std::string status_lines(const ClusterStatus& status);
[[nodiscard]] std::string status_json(const ClusterStatus& status);

}  // namespace talus::server::cluster_tool
