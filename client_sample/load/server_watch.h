// What the server spends, as its own metrics or the system's tables tell it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>

namespace talus::load {

struct ServerSample {
  std::optional<double> cpu_seconds, resident_bytes, open_files;
  std::map<std::string, double> counters;  // talus_..., labels summed away, where there are metrics
};

class ServerWatch {
 public:
  /// `pid` 0 and no `metrics`: nothing is known. Both: the metrics say what they know, the pid the rest.
  ServerWatch(std::optional<protocol::Endpoint> metrics, int pid) : metrics_{std::move(metrics)}, pid_{pid} {}

  [[nodiscard]] bool watches() const { return metrics_ || pid_ != 0; }
  /// Blocks for as long as the server takes to answer, two seconds at most. An error is one line.
  [[nodiscard]] tl::expected<ServerSample, std::string> sample() const;

 private:
  std::optional<protocol::Endpoint> metrics_;
  int pid_;
};

/// Reads the Prometheus text format: process_* and talus_* samples.
[[nodiscard]] ServerSample read_metrics(const std::string& text);

}  // namespace talus::load
