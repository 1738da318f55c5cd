// The page that Prometheus scrapes: one table of all metrics with name, help, type, labels and value.
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

/// Values that other modules report when the page is read.
struct RuntimeGauges {
  std::uint64_t jobs = 0;             // chunks queued for or in a generator
  std::uint64_t waiting_clients = 0;  // clients with a queued job
  std::uint64_t chunk_cache_bytes = 0;
  std::uint64_t patch_cache_bytes = 0;
  std::uint64_t map_cache_bytes = 0;
  bool draining = false;
  std::vector<std::uint64_t> memory_bytes{};  // by use, in the order of MetricLabels::memory_uses
  std::uint64_t memory_limit_bytes = 0;       // 0: unlimited
  std::int64_t certificate_expires = 0;       // seconds since 1970; 0: no TLS
  std::uint64_t flows = 0;                    // active flows
  std::uint64_t flow_refusals = 0;            // of all flows
  struct Edits {
    std::uint64_t revision = 0;
    std::uint64_t preparing = 0;  // edits waiting for their ground or their turn
    std::uint64_t logging = 0;    // entries waiting to be written
    std::uint64_t editors = 0;    // known editors
    bool read_only = false;       // the log cannot be written
    std::uint64_t index_bytes = 0;
    std::uint64_t index_limit_bytes = 0;  // beyond it only chunks already edited may change
    std::uint64_t history_bytes = 0;
    std::uint64_t history_limit_bytes = 0;
    std::int64_t history_start = 0;  // seconds since 1970; history is complete from then on; 0: empty
    std::uint64_t clock_jumps = 0;
  };
  std::optional<Edits> edits{};  // nullopt: edits are not stored
  struct Cluster {
    bool connected = false;
    bool quorum = false;
    bool differs = false;
    std::uint64_t lag = 0;       // messages
    std::uint64_t sequence = 0;  // last applied message
    std::uint64_t republished = 0;
    std::uint64_t gaps = 0;
    const LatencyHistogram* publishing = nullptr;
    std::uint64_t joins = 0;    // checkpoints of other servers' stores loaded at this start
    std::uint64_t skipped = 0;  // messages that no talusd can apply
    std::uint64_t bounded = 0;  // batches whose stated time was bounded
    bool stuck = false;         // the next message is for a newer talusd
    bool tail = false;          // messages are pushed by the stream
    std::uint64_t false_messages = 0;
  };
  std::optional<Cluster> cluster{};  // nullopt: this server is alone
  struct Columns {
    std::uint64_t found = 0;  // on disk
    std::uint64_t missing = 0;
    std::uint64_t kept = 0;
    std::uint64_t lost = 0;
    std::uint64_t bytes = 0;
  };
  std::optional<Columns> columns{};  // nullopt: columns are not kept on disk
};

/// Names of the label values that modules count, in the order of their enums. A value with an empty name is
/// omitted. The texts must outlive the page.
struct MetricLabels {
  using Names = std::span<const std::string_view>;
  Names refusals{};        // Metrics::refused
  Names error_codes{};     // Metrics::errors
  Names auth_failures{};   // Metrics::auth_failures
  Names rates{};           // Metrics::throttled_by
  Names memory_uses{};     // RuntimeGauges::memory_bytes
  Names status_classes{};  // Metrics::web_responses
  Names edits_refused{};   // Metrics::edits_refused
};

struct BuildInfo {
  std::string version;
  std::uint64_t generator = 0;
  std::string fingerprint;
  std::string instruction_set;
};

/// Everything that a page is made from.
struct MetricSources {
  const Metrics& metrics;
  const RuntimeGauges& gauges;
  const ProcessStats& process;
  const BuildInfo& build;
  const MetricLabels& labels;
};

/// One value of a metric, with a value for each label of its row.
struct Sample {
  double value = 0;
  std::vector<std::string> labels{};
  const LatencyHistogram* histogram = nullptr;  // instead of `value`
};

/// Counters by label, with the names of the label's values.
struct LabelledMetric {
  LabelledCounters Metrics::*counters;
  MetricLabels::Names MetricLabels::*names;
};

/// Source of a metric's samples. If a function returns an empty list, the metric is omitted.
using MetricValue =
    std::variant<Counter Metrics::*, Gauge Metrics::*, LabelledMetric, std::uint64_t RuntimeGauges::*,
                 double ProcessStats::*, std::uint64_t ProcessStats::*,
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

/// Prometheus' text format, version 0.0.4.
[[nodiscard]] std::string metrics_page(const MetricSources& sources);

}  // namespace talus::server
