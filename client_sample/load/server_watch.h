// Reads the server's resource usage from its metrics or from /proc.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>

namespace talus::load {

struct ServerSample {
  std::optional<double> cpu_seconds, resident_bytes, open_files;
  std::map<std::string, double> counters;  // talus_..., summed over labels, if there are metrics
};

class ServerWatch {
 public:
  /// Without `pid` (0) and `metrics`, nothing is known. With both, `pid` supplements the metrics.
  ServerWatch(std::optional<protocol::Endpoint> metrics, int pid) : metrics_{std::move(metrics)}, pid_{pid} {}

  [[nodiscard]] bool watches() const { return metrics_ || pid_ != 0; }
  /// Blocks until the server answers, at most two seconds. An error is one line.
  [[nodiscard]] tl::expected<ServerSample, std::string> sample() const;

 private:
  std::optional<protocol::Endpoint> metrics_;
  int pid_;
};

/// Reads the Prometheus text format: process_* and talus_* samples.
[[nodiscard]] ServerSample read_metrics(const std::string& text);

}  // namespace talus::load
