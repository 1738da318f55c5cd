#include "runtime/metrics/metrics_page.h"

#include <array>
#include <cassert>

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

namespace talus::server {
namespace {

using Source = MetricSources;
using Samples = std::vector<Sample>;
using ClusterGauges = RuntimeGauges::Cluster;
using enum MetricType;

Sample labelled(const char* label, double value) {
  return {value, {label}};
}
Sample labelled(const char* label, const Counter& counter, double unit = 1) {
  return labelled(label, static_cast<double>(counter.total()) * unit);
}
Sample labelled(const char* label, const LatencyHistogram& histogram) {
  return {0, {label}, &histogram};
}

Samples build_info(const Source& s) {
  return {
      {1,
       {s.build.version, std::to_string(s.build.generator), s.build.fingerprint, s.build.instruction_set}}};
}

Samples edits_waiting(const Source& s) {
  if (!s.gauges.edits) return {};
  return {labelled("intake", static_cast<double>(s.gauges.edits->preparing)),
          labelled("log", static_cast<double>(s.gauges.edits->logging))};
}

Samples edit_latency(const Source& s) {
  if (!s.gauges.edits) return {};
  return {{0, {}, &s.metrics.edit_latency}};
}

Samples edits_read_only(const Source& s) {
  if (!s.gauges.edits) return {};
  return {{s.gauges.edits->read_only ? 1.0 : 0.0}};
}

Samples edits_history_start(const Source& s) {
  if (!s.gauges.edits || s.gauges.edits->history_start == 0) return {};
  return {{static_cast<double>(s.gauges.edits->history_start)}};
}

template <auto member>
Samples of_edits(const Source& s) {
  if (!s.gauges.edits) return {};
  return {{static_cast<double>((*s.gauges.edits).*member)}};
}

/// A metric of the log that servers share; empty if this server is alone.
template <auto member>
Samples of_cluster(const Source& s) {
  if (!s.gauges.cluster) return {};
  return {{static_cast<double>((*s.gauges.cluster).*member)}};
}

Samples cluster_publishing(const Source& s) {
  if (!s.gauges.cluster || s.gauges.cluster->publishing == nullptr) return {};
  return {{0, {}, s.gauges.cluster->publishing}};
}

Samples draining(const Source& s) {
  return {{s.gauges.draining ? 1.0 : 0.0}};
}

Samples sessions(const Source& s) {
  const auto open = static_cast<double>(s.metrics.open.now());
  const auto greeted = static_cast<double>(s.metrics.greeted.now());
  return {labelled("handshake", open - greeted), labelled("greeted", greeted)};
}

Samples tls_handshakes(const Source& s) {
  return {labelled("done", s.metrics.tls_handshakes), labelled("failed", s.metrics.tls_failed),
          labelled("late", s.metrics.tls_late)};
}

Samples certificate_expiry(const Source& s) {
  if (s.gauges.certificate_expires == 0) return {};
  return {{static_cast<double>(s.gauges.certificate_expires)}};
}

Samples chunk_latency(const Source& s) {
  return {labelled("hot", s.metrics.hot_latency), labelled("cold", s.metrics.cold_latency)};
}

Samples web_latency(const Source& s) {
  Samples samples;
  for (std::size_t kind = 0; kind < kAnswerKinds.size(); ++kind) {
    samples.push_back({0, {std::string{kAnswerKinds[kind]}}, &s.metrics.web_latency[kind]});
  }
  return samples;
}

Samples views(const Source& s) {
  return {labelled("local", static_cast<double>(s.metrics.views_local.now())),
          labelled("stream", static_cast<double>(s.metrics.views_stream.now()))};
}

Samples map_tiles(const Source& s) {
  return {labelled("drawn", s.metrics.map_tiles_made), labelled("cached", s.metrics.map_tiles_found)};
}

Samples cache_bytes(const Source& s) {
  return {labelled("chunks", static_cast<double>(s.gauges.chunk_cache_bytes)),
          labelled("patches", static_cast<double>(s.gauges.patch_cache_bytes)),
          labelled("maps", static_cast<double>(s.gauges.map_cache_bytes)),
          labelled("disk", s.gauges.columns ? static_cast<double>(s.gauges.columns->bytes) : 0.0)};
}

Samples disk_columns(const Source& s) {
  if (!s.gauges.columns) return {};
  const auto& columns = *s.gauges.columns;
  return {labelled("found", static_cast<double>(columns.found)),
          labelled("missing", static_cast<double>(columns.missing)),
          labelled("kept", static_cast<double>(columns.kept)),
          labelled("lost", static_cast<double>(columns.lost))};
}

Samples generation_seconds(const Source& s) {
  constexpr double kNanosecond = 1e-9;
  return {
      labelled("patch", s.metrics.patch_ns, kNanosecond), labelled("chunk", s.metrics.chunk_ns, kNanosecond),
      labelled("heights", s.metrics.heights_ns, kNanosecond), labelled("map", s.metrics.map_ns, kNanosecond)};
}

Samples memory_bytes(const Source& s) {
  assert(s.gauges.memory_bytes.size() <= s.labels.memory_uses.size());
  Samples samples;
  for (std::size_t use = 0; use < s.gauges.memory_bytes.size(); ++use) {
    samples.push_back(
        {static_cast<double>(s.gauges.memory_bytes[use]), {std::string{s.labels.memory_uses[use]}}});
  }
  return samples;
}

// clang-format off
const std::array kRows{
    MetricRow{"talus_build_info",
              "Versions of program, generator and world; always 1.",
              gauge, {"version", "generator", "fingerprint", "instruction_set"}, build_info},
    MetricRow{"talus_edits_revision",
              "Edits that changed something since the store was made; absent without --data, as all edit metrics.",
              gauge, {}, of_edits<&RuntimeGauges::Edits::revision>},
    MetricRow{"talus_edits_waiting",
              "Edits and Attaches that wait: intake, for their ground and turn; log, to be written.",
              gauge, {"where"}, edits_waiting},
    MetricRow{"talus_edit_latency_seconds",
              "Time from an edit's submission until it is stored and its session notified.",
              histogram, {}, edit_latency},
    MetricRow{"talus_edits_refused_total",
              "Edits and Attaches refused, except those that their session refuses as forbidden or too_large. "
              "out_of_range: a bound, or an unknown material; ground: its chunk failed; half_closed: the client sends "
              "no more, and the ground is not generated yet; unwritable: the store; cut_off: the cluster's log; "
              "index_full: too many edited chunks; unreadable: a damaged chunk; conflict: a guard; behind, "
              "editors_full, overtaken: Attaches.",
              counter, {"reason"}, LabelledMetric{&Metrics::edits_refused, &MetricLabels::edits_refused}},
    MetricRow{"talus_editors", "Known editors, at most 65,536.", gauge, {}, of_edits<&RuntimeGauges::Edits::editors>},
    MetricRow{"talus_edit_index_bytes",
              "Memory of the index of edited chunks.",
              gauge, {}, of_edits<&RuntimeGauges::Edits::index_bytes>},
    MetricRow{"talus_edit_index_limit_bytes",
              "Size of the index at which only chunks edited before may be edited.",
              gauge, {}, of_edits<&RuntimeGauges::Edits::index_limit_bytes>},
    MetricRow{"talus_edits_read_only",
              "1 while no edits are taken or they wait, as the store or the cluster's log cannot be written.",
              gauge, {}, edits_read_only},
    MetricRow{"talus_edits_clock_jumps_total",
              "Jumps of this machine's clock by over a minute: ahead, or behind the date of the last edit.",
              counter, {}, of_edits<&RuntimeGauges::Edits::clock_jumps>},
    MetricRow{"talus_edits_history_bytes",
              "Bytes of the history of edits.",
              gauge, {}, of_edits<&RuntimeGauges::Edits::history_bytes>},
    MetricRow{"talus_edits_history_limit_bytes",
              "edits.history_bytes.",
              gauge, {}, of_edits<&RuntimeGauges::Edits::history_limit_bytes>},
    MetricRow{"talus_edits_history_start_timestamp_seconds",
              "Time from which on the history has all edits; absent without a history.",
              gauge, {}, edits_history_start},
    MetricRow{"talus_checkpoints_sent_total",
              "Checkpoints of the store sent whole to other servers.",
              counter, {}, &Metrics::checkpoints_sent},
    MetricRow{"talus_checkpoints_refused_total",
              "Checkpoints refused because of the token, or because enough are being sent.",
              counter, {}, &Metrics::checkpoints_refused},
    MetricRow{"talus_checkpoint_bytes_sent_total",
              "Bytes of checkpoints sent.",
              counter, {}, &Metrics::checkpoint_bytes_sent},
    MetricRow{"talus_checkpoints_open", "Checkpoints being made or sent.", gauge, {}, &Metrics::checkpoints_open},
    MetricRow{"talus_cluster_connected",
              "1 while a NATS server is connected; absent if the server is alone, as all cluster metrics.",
              gauge, {}, of_cluster<&ClusterGauges::connected>},
    MetricRow{"talus_cluster_quorum",
              "1 while the log's leader answers, lets messages be read and takes edits.",
              gauge, {}, of_cluster<&ClusterGauges::quorum>},
    MetricRow{"talus_cluster_lag_messages",
              "Messages of the log not applied here, by the leader's last report.",
              gauge, {}, of_cluster<&ClusterGauges::lag>},
    MetricRow{"talus_cluster_sequence",
              "Last message of the log applied here.",
              gauge, {}, of_cluster<&ClusterGauges::sequence>},
    MetricRow{"talus_cluster_publish_seconds",
              "Time from a message's first publication until a majority of the NATS servers has it.",
              histogram, {}, cluster_publishing},
    MetricRow{"talus_cluster_republished_total",
              "Messages published again, as they were not acknowledged.",
              counter, {}, of_cluster<&ClusterGauges::republished>},
    MetricRow{"talus_cluster_gaps_total",
              "Times that messages were missing in the log's tail and were requested.",
              counter, {}, of_cluster<&ClusterGauges::gaps>},
    MetricRow{"talus_cluster_state_differs",
              "1 while this server's state and another's differ at one revision, so that one is wrong.",
              gauge, {}, of_cluster<&ClusterGauges::differs>},
    MetricRow{"talus_cluster_messages_skipped_total",
              "Messages passed over: not written by a talusd, or of a format not enabled.",
              counter, {}, of_cluster<&ClusterGauges::skipped>},
    MetricRow{"talus_cluster_times_bounded_total",
              "Batches of a server whose clock was over a minute ahead of the log's, which dates them.",
              counter, {}, of_cluster<&ClusterGauges::bounded>},
    MetricRow{"talus_cluster_stuck",
              "1 while the next message of the log needs a newer talusd.",
              gauge, {}, of_cluster<&ClusterGauges::stuck>},
    MetricRow{"talus_cluster_tail",
              "1 while the log's tail is subscribed; 0: NATS refuses that, and other servers' edits arrive up to a "
              "second late.",
              gauge, {}, of_cluster<&ClusterGauges::tail>},
    MetricRow{"talus_cluster_false_messages_total",
              "Messages of the tail altered or published by another user; the leader's copies are applied.",
              counter, {}, of_cluster<&ClusterGauges::false_messages>},
    MetricRow{"talus_cluster_joins_total",
              "Checkpoints of other servers' stores taken at this start.",
              counter, {}, of_cluster<&ClusterGauges::joins>},
    MetricRow{"talus_draining", "1 from the signal that ends the server on.", gauge, {}, draining},

    MetricRow{"talus_sessions", "Open connections, by state.", gauge, {"state"}, sessions},
    MetricRow{"talus_connections_total", "Connections admitted.", counter, {}, &Metrics::accepted},
    MetricRow{"talus_sessions_sent_elsewhere_total",
              "Sessions sent to other servers because this one had more than its share.",
              counter, {}, &Metrics::sent_elsewhere},
    MetricRow{"talus_connections_refused_total",
              "Connections refused before they had a session. places: limits.connections or connections_per_address; "
              "memory: limits.memory_bytes; pace: limits.handshakes_per_address_*; handshakes: "
              "limits.handshakes_in_flight; proxy: no valid header from one of proxies; descriptors: too few open "
              "files allowed; blocked: access.blocked_file.",
              counter, {"reason"}, LabelledMetric{&Metrics::refused, &MetricLabels::refusals}},
    MetricRow{"talus_http_connections",
              "Open HTTP connections of players, without WebSockets.",
              gauge, {}, &Metrics::web_open},
    MetricRow{"talus_http_responses_total",
              "HTTP responses to players, by class of status (2xx).",
              counter, {"status"}, LabelledMetric{&Metrics::web_responses, &MetricLabels::status_classes}},
    MetricRow{"talus_http_latency_seconds",
              "Time from a player's whole HTTP request until its response is ready, with waits for generators and "
              "rates.",
              histogram, {"kind"}, web_latency},
    MetricRow{"talus_received_bytes_total",
              "Bytes of frames from clients, without TLS records and PROXY headers.",
              counter, {}, &Metrics::received_bytes},
    MetricRow{"talus_sent_bytes_total",
              "Bytes of frames to clients, without TLS records and refusals.",
              counter, {}, &Metrics::sent_bytes},
    MetricRow{"talus_errors_total",
              "Error messages sent to clients, by protocol code.",
              counter, {"code"}, LabelledMetric{&Metrics::errors, &MetricLabels::error_codes}},
    MetricRow{"talus_rates_held_total",
              "Times that a rate refused a request or delayed chunks.",
              counter, {"rate"}, LabelledMetric{&Metrics::throttled_by, &MetricLabels::rates}},
    MetricRow{"talus_tokens_refused_total",
              "Clients refused or disconnected because of their token; blocked: because of subject, or, if connected, "
              "address.",
              counter, {"reason"}, LabelledMetric{&Metrics::auth_failures, &MetricLabels::auth_failures}},
    MetricRow{"talus_flows",
              "Flows (addresses or token subjects) with a recent session.",
              gauge, {}, &RuntimeGauges::flows},
    MetricRow{"talus_flow_refusals_total",
              "Requests and connections refused as too many, too fast or because the server was full.",
              counter, {}, &RuntimeGauges::flow_refusals},

    MetricRow{"talus_handshakes", "PROXY headers and TLS handshakes in flight.", gauge, {}, &Metrics::handshakes},
    MetricRow{"talus_tls_handshakes_total",
              "TLS handshakes, by result; late: after limits.handshake_timeout_ms.",
              counter, {"result"}, tls_handshakes},
    MetricRow{"talus_tls_certificate_expiry_timestamp_seconds",
              "Expiry of the certificate in use; absent without TLS.",
              gauge, {}, certificate_expiry},

    MetricRow{"talus_chunk_latency_seconds",
              "Time from a session's start on a chunk's request until the chunk is ready; hot: cached, cold: "
              "generated.",
              histogram, {"source"}, chunk_latency},
    MetricRow{"talus_chunks_sent_total", "Chunk messages sent.", counter, {}, &Metrics::chunks_sent},
    MetricRow{"talus_chunk_bytes_sent_total", "Bytes of Chunk messages sent.", counter, {}, &Metrics::chunk_bytes_sent},
    MetricRow{"talus_columns_sent_total",
              "UniformColumn messages sent, each for a column's uniform chunks.",
              counter, {}, &Metrics::columns_sent},
    MetricRow{"talus_unchanged_sent_total", "Unchanged messages sent.", counter, {}, &Metrics::unchanged_sent},
    MetricRow{"talus_edit_broadcasts_sent_total",
              "EditBroadcast messages sent.",
              counter, {}, &Metrics::broadcasts_sent},
    MetricRow{"talus_views",
              "Sessions with a View; local: the client makes chunks and is sent only edits.",
              gauge, {"base"}, views},
    MetricRow{"talus_proofs_failed_total",
              "Chunks made by a client of base=\"local\" that differ from the server's.",
              counter, {}, &Metrics::proofs_failed},

    MetricRow{"talus_cache_hits_total", "Chunks found in the cache.", counter, {}, &Metrics::cache_hits},
    MetricRow{"talus_cache_misses_total", "Chunks not found in the cache.", counter, {}, &Metrics::cache_misses},
    MetricRow{"talus_uniform_answers_total",
              "Chunks found to be all rock or all air.",
              counter, {}, &Metrics::uniform_answers},
    MetricRow{"talus_cache_bytes", "Bytes in each cache.", gauge, {"cache"}, cache_bytes},
    MetricRow{"talus_disk_columns_total",
              "Columns asked of the cache on disk (found, missing) and given to it (kept; lost: damaged, or the disk "
              "was slow, nearly full or failing); absent without it.",
              counter, {"outcome"}, disk_columns},
    MetricRow{"talus_patches_generated_total", "Patches of terrain generated.", counter, {}, &Metrics::patches_made},
    MetricRow{"talus_chunks_generated_total", "Chunks extracted and encoded.", counter, {}, &Metrics::chunks_made},
    MetricRow{"talus_generation_seconds_total",
              "CPU time of generator threads, by stage.",
              counter, {"stage"}, generation_seconds},
    MetricRow{"talus_heights_generated_total",
              "Columns whose height was looked up.",
              counter, {}, &Metrics::heights_made},
    MetricRow{"talus_map_tiles_total", "Tiles of the map, drawn or cached.", counter, {"source"}, map_tiles},
    MetricRow{"talus_jobs", "Chunks that wait for a generator or are in one.", gauge, {}, &RuntimeGauges::jobs},
    MetricRow{"talus_waiting_sessions",
              "Sessions that wait for a generator.",
              gauge, {}, &RuntimeGauges::waiting_clients},
    MetricRow{"talus_jobs_refused_total",
              "Requests for chunks refused, as the generators' queue or the memory was full.",
              counter, {}, &Metrics::jobs_refused},
    MetricRow{"talus_jobs_cancelled_total",
              "Jobs dropped, as no client waited for them any more.",
              counter, {}, &Metrics::jobs_cancelled},

    MetricRow{"talus_memory_bytes", "Memory that the server accounts for, by use.", gauge, {"use"}, memory_bytes},
    MetricRow{"talus_memory_limit_bytes", "Memory budget; 0: no limit.", gauge, {}, &RuntimeGauges::memory_limit_bytes},

    MetricRow{"process_cpu_seconds_total", "User and system CPU time.", counter, {}, &ProcessStats::cpu_seconds},
    MetricRow{"process_start_time_seconds",
              "Start of the process, in seconds since 1970.",
              gauge, {}, &ProcessStats::start_seconds},
    MetricRow{"process_resident_memory_bytes", "Resident memory.", gauge, {}, &ProcessStats::resident_bytes},
    MetricRow{"process_virtual_memory_bytes", "Virtual memory.", gauge, {}, &ProcessStats::virtual_bytes},
    MetricRow{"process_open_fds", "Open file descriptors.", gauge, {}, &ProcessStats::open_descriptors},
    MetricRow{"process_max_fds", "Limit of open file descriptors.", gauge, {}, &ProcessStats::max_descriptors},
    MetricRow{"process_threads", "Threads.", gauge, {}, &ProcessStats::threads},
};
// clang-format on

/// Reads the samples of a row.
struct SampleReader {
  const MetricSources& from;

  Samples operator()(Counter Metrics::*member) const {
    return {{static_cast<double>((from.metrics.*member).total())}};
  }
  Samples operator()(Gauge Metrics::*member) const {
    return {{static_cast<double>((from.metrics.*member).now())}};
  }
  Samples operator()(std::uint64_t RuntimeGauges::*member) const {
    return {{static_cast<double>(from.gauges.*member)}};
  }
  Samples operator()(double ProcessStats::*member) const { return {{from.process.*member}}; }
  Samples operator()(std::uint64_t ProcessStats::*member) const {
    return {{static_cast<double>(from.process.*member)}};
  }
  Samples operator()(const LabelledMetric& metric) const {
    const MetricLabels::Names names = from.labels.*metric.names;
    assert(names.size() <= LabelledCounters::kMaxValues);
    Samples samples;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].empty()) continue;
      const auto total = static_cast<double>((from.metrics.*metric.counters).total(i));
      samples.push_back({total, {std::string{names[i]}}});
    }
    return samples;
  }
  Samples operator()(Samples (*function)(const MetricSources&)) const { return function(from); }
};

prometheus::MetricType type_of(MetricType type) {
  return type == counter ? prometheus::MetricType::Counter
         : type == gauge ? prometheus::MetricType::Gauge
                         : prometheus::MetricType::Histogram;
}

void set_histogram(prometheus::ClientMetric::Histogram& into, const LatencyHistogram& from) {
  const LatencyHistogram::Snapshot snapshot = from.read();
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < LatencyHistogram::kBoundsSeconds.size(); ++i) {
    sum += snapshot.counts[i];
    into.bucket.push_back({sum, LatencyHistogram::kBoundsSeconds[i]});
  }
  into.sample_count = sum + snapshot.counts.back();
  into.sample_sum = snapshot.sum_seconds;
}

prometheus::ClientMetric metric_of(const MetricRow& row, const Sample& sample) {
  assert(sample.labels.size() == row.labels.size());
  prometheus::ClientMetric metric;
  for (std::size_t i = 0; i < row.labels.size(); ++i) {
    metric.label.push_back({std::string{row.labels[i]}, sample.labels[i]});
  }
  if (sample.histogram != nullptr) set_histogram(metric.histogram, *sample.histogram);
  metric.counter.value = sample.value;
  metric.gauge.value = sample.value;
  return metric;
}

}  // namespace

std::span<const MetricRow> metric_rows() {
  return kRows;
}

std::string metrics_page(const MetricSources& sources) {
  std::vector<prometheus::MetricFamily> families;
  for (const MetricRow& row : kRows) {
    const Samples samples = std::visit(SampleReader{sources}, row.value);
    if (samples.empty()) continue;
    prometheus::MetricFamily& family = families.emplace_back();
    family.name = row.name;
    family.help = row.help;
    family.type = type_of(row.type);
    for (const Sample& sample : samples) family.metric.push_back(metric_of(row, sample));
  }
  return prometheus::TextSerializer{}.Serialize(families);
}

}  // namespace talus::server
