// The page that Prometheus reads: one table of every metric with its name, help, type, labels and value.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/metrics/metrics.h"
#include "runtime/metrics/process.h"

namespace talus::server {

/// What other modules report when the page is read.
struct RuntimeGauges {
  std::uint64_t jobs = 0;             // chunks that wait for a generator, or are in one
  std::uint64_t waiting_clients = 0;  // with a job in the queue
  std::uint64_t chunk_cache_bytes = 0;
  std::uint64_t patch_cache_bytes = 0;
  std::uint64_t map_cache_bytes = 0;
  bool draining = false;
  std::vector<std::uint64_t> memory_bytes{};  // by use, as MetricLabels::memory_uses names them
  std::uint64_t memory_limit_bytes = 0;       // 0: none
  std::int64_t certificate_expires = 0;       // seconds since 1970; 0: no TLS
  std::uint64_t flows = 0;                    // that are served
  std::uint64_t flow_refusals = 0;            // of all flows
  struct Edits {
    std::uint64_t revision = 0;
    std::uint64_t preparing = 0;  // edits that wait for their ground, or their turn
    std::uint64_t logging = 0;    // entries that wait to be written
    std::uint64_t editors = 0;    // that are known
    bool read_only = false;       // the log cannot be written
    std::uint64_t index_bytes = 0;
    std::uint64_t index_limit_bytes = 0;  // from there on only chunks that were edited may be
    std::uint64_t history_bytes = 0;
    std::uint64_t history_limit_bytes = 0;
    std::int64_t history_start = 0;  // seconds since 1970 from which on it has all; 0: there is none
  };
  std::optional<Edits> edits{};  // none: nothing is stored
  struct Cluster {
    bool connected = false;
    bool quorum = false;
    bool differs = false;
    std::uint64_t lag = 0;       // messages
    std::uint64_t sequence = 0;  // of the last message that is applied
    std::uint64_t republished = 0;
    std::uint64_t gaps = 0;
    const LatencyHistogram* publishing = nullptr;
    std::uint64_t joins = 0;    // checkpoints of other servers' stores that were taken at this start
    std::uint64_t skipped = 0;  // messages that no talusd can apply
    std::uint64_t bounded = 0;  // batches whose time did not count as they said
    bool stuck = false;         // the next message is for a newer talusd
    bool tail = false;          // messages come by themselves
    std::uint64_t false_messages = 0;
  };
  std::optional<Cluster> cluster{};  // none: this server is alone
  struct Columns {
    std::uint64_t found = 0;  // on disk
    std::uint64_t missing = 0;
    std::uint64_t kept = 0;
    std::uint64_t lost = 0;
    std::uint64_t bytes = 0;
  };
  std::optional<Columns> columns{};  // none: none are kept on disk
};

/// Names of the values that modules count by, in the order of their enums. A value with an empty name is left
/// out. The texts outlive the page.
struct MetricLabels {
  using Names = std::span<const std::string_view>;
  Names refusals{};        // of Metrics::refused
  Names error_codes{};     // of Metrics::errors
  Names auth_failures{};   // of Metrics::auth_failures
  Names rates{};           // of Metrics::throttled_by
  Names memory_uses{};     // of RuntimeGauges::memory_bytes
  Names status_classes{};  // of Metrics::web_responses
  Names edits_refused{};   // of Metrics::edits_refused
};

struct BuildInfo {
  std::string version;
  std::uint64_t generator = 0;
  std::string fingerprint;
  std::string instruction_set;
};

/// All that a page is made of.
struct MetricSources {
  const Metrics& metrics;
  const RuntimeGauges& gauges;
  const ProcessReading& process;
  const BuildInfo& build;
  const MetricLabels& labels;
};

/// One value of a metric, with a value for each label of its row.
struct Sample {
  double value = 0;
  std::vector<std::string> labels{};
  const LatencyHistogram* histogram = nullptr;  // instead of `value`
};

/// Counters by label, and the names of the label's values.
struct LabelledMetric {
  LabelledCounters Metrics::*counters;
  MetricLabels::Names MetricLabels::*names;
};

/// Where a metric's samples come from. A function may return none: then the metric is left out.
using MetricValue =
    std::variant<Counter Metrics::*, Gauge Metrics::*, LabelledMetric, std::uint64_t RuntimeGauges::*,
                 double ProcessReading::*, std::uint64_t ProcessReading::*,
                 std::vector<Sample> (*)(const MetricSources&)>;

enum class MetricType : std::uint8_t { counter, gauge, histogram };

struct MetricRow {
  std::string_view name;
  std::string_view help;
  MetricType type;
  std::vector<std::string_view> labels;
  MetricValue value;
};

/// In the order of the page.
[[nodiscard]] std::span<const MetricRow> metric_rows();

/// In Prometheus' text format, version 0.0.4.
[[nodiscard]] std::string metrics_page(const MetricSources& sources);

}  // namespace talus::server
