#include "metrics/metrics_page.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

namespace talus::server {
namespace {

using Source = MetricSources;
using Samples = std::vector<Sample>;
using enum MetricType;

Samples one(double value) {
  return {{value}};
}
Samples one(const Counter& counter) {
  return one(static_cast<double>(counter.total()));
}
Samples one(std::uint64_t value) {
  return one(static_cast<double>(value));
}

Sample labelled(const char* label, double value) {
  return {value, {label}};
}
Sample labelled(const char* label, const Counter& counter) {
  return labelled(label, static_cast<double>(counter.total()));
}
Sample labelled(const char* label, std::uint64_t value) {
  return labelled(label, static_cast<double>(value));
}
Sample labelled(const char* label, const LatencyHistogram& histogram) {
  return {0, {label}, &histogram};
}

double seconds(const Counter& nanoseconds) {
  return static_cast<double>(nanoseconds.total()) * 1e-9;
}

/// A sample for each named value; `value_at` gives the number of one.
template <typename ValueAt>
Samples each(MetricLabels::Names names, ValueAt&& value_at) {
  Samples samples;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) samples.push_back({static_cast<double>(value_at(i)), {std::string{names[i]}}});
  }
  return samples;
}
Samples each(MetricLabels::Names names, const LabelledCounters& counters) {
  assert(names.size() <= LabelledCounters::kMaxValues);
  return each(names, [&](std::size_t value) { return counters.total(value); });
}
Samples each(MetricLabels::Names names, const std::vector<std::uint64_t>& values) {
  return each(names.first(std::min(names.size(), values.size())),
              [&](std::size_t value) { return values[value]; });
}

const std::array kRows{
    MetricRow{"talus_build_info",
              "Versions of the program, the generator and the world; always 1.",
              gauge,
              {"version", "generator", "fingerprint", "instruction_set"},
              [](const Source& s) -> Samples {
                return {{1,
                         {s.build.version, std::to_string(s.build.generator), s.build.fingerprint,
                          s.build.instruction_set}}};
              }},
    MetricRow{"talus_draining",
              "1 from the signal that ends the server until it ends, else 0.",
              gauge,
              {},
              [](const Source& s) { return one(s.gauges.draining ? 1.0 : 0.0); }},

    MetricRow{"talus_sessions",
              "Open connections, by state.",
              gauge,
              {"state"},
              [](const Source& s) -> Samples {
                const auto open = static_cast<double>(s.metrics.open.now());
                const auto greeted = static_cast<double>(s.metrics.greeted.now());
                return {labelled("handshake", open - greeted), labelled("greeted", greeted)};
              }},
    MetricRow{"talus_connections_total",
              "Connections admitted.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.accepted); }},
    MetricRow{"talus_connections_refused_total",
              "Connections refused before they had a session, by reason.",
              counter,
              {"reason"},
              [](const Source& s) { return each(s.labels.refusals, s.metrics.refused); }},
    MetricRow{"talus_received_bytes_total",
              "Bytes received from clients.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.received_bytes); }},
    MetricRow{"talus_sent_bytes_total",
              "Bytes written to clients.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.sent_bytes); }},
    MetricRow{"talus_errors_total",
              "Error messages sent to clients, by code.",
              counter,
              {"code"},
              [](const Source& s) { return each(s.labels.error_codes, s.metrics.errors); }},
    MetricRow{"talus_rates_held_total",
              "How often a rate refused a request or made chunks wait.",
              counter,
              {"rate"},
              [](const Source& s) { return each(s.labels.rates, s.metrics.throttled_by); }},
    MetricRow{"talus_tokens_refused_total",
              "Clients refused or disconnected because of their token, by reason.",
              counter,
              {"reason"},
              [](const Source& s) { return each(s.labels.auth_failures, s.metrics.auth_failures); }},

    MetricRow{"talus_handshakes",
              "PROXY headers and TLS handshakes in flight.",
              gauge,
              {},
              [](const Source& s) { return one(static_cast<double>(s.metrics.handshakes.now())); }},
    MetricRow{"talus_tls_handshakes_total",
              "TLS handshakes, by result.",
              counter,
              {"result"},
              [](const Source& s) -> Samples {
                return {labelled("done", s.metrics.tls_handshakes), labelled("failed", s.metrics.tls_failed),
                        labelled("late", s.metrics.tls_late)};
              }},
    MetricRow{"talus_tls_certificate_expiry_timestamp_seconds",
              "When the certificate expires, in seconds since 1970.",
              gauge,
              {},
              [](const Source& s) {
                if (s.gauges.certificate_expires == 0) return Samples{};
                return one(static_cast<double>(s.gauges.certificate_expires));
              }},

    MetricRow{"talus_chunk_latency_seconds",
              "From when a session starts on a request for a chunk to when the chunk is ready to be sent.",
              histogram,
              {"source"},
              [](const Source& s) -> Samples {
                return {labelled("hot", s.metrics.hot_latency), labelled("cold", s.metrics.cold_latency)};
              }},
    MetricRow{"talus_chunks_sent_total",
              "Chunk messages sent.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.chunks_sent); }},
    MetricRow{"talus_chunk_bytes_sent_total",
              "Bytes of Chunk messages sent.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.chunk_bytes_sent); }},
    MetricRow{"talus_columns_sent_total",
              "Column messages sent; each stands for the uniform chunks of a column.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.columns_sent); }},
    MetricRow{"talus_unchanged_sent_total",
              "Unchanged messages sent.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.unchanged_sent); }},

    MetricRow{"talus_cache_hits_total",
              "Chunks found in the cache.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.cache_hits); }},
    MetricRow{"talus_cache_misses_total",
              "Chunks not found in the cache.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.cache_misses); }},
    MetricRow{"talus_uniform_answers_total",
              "Chunks known to be all rock or all air without a look at the cache.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.uniform_answers); }},
    MetricRow{"talus_cache_bytes",
              "Bytes in each cache.",
              gauge,
              {"cache"},
              [](const Source& s) -> Samples {
                return {labelled("chunks", s.gauges.chunk_cache_bytes),
                        labelled("patches", s.gauges.patch_cache_bytes)};
              }},
    MetricRow{"talus_patches_generated_total",
              "Patches of terrain generated.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.patches_made); }},
    MetricRow{"talus_chunks_generated_total",
              "Chunks extracted and encoded.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.chunks_made); }},
    MetricRow{"talus_generation_seconds_total",
              "CPU time of generator threads, by stage.",
              counter,
              {"stage"},
              [](const Source& s) -> Samples {
                return {labelled("patch", seconds(s.metrics.patch_ns)),
                        labelled("chunk", seconds(s.metrics.chunk_ns)),
                        labelled("heights", seconds(s.metrics.heights_ns))};
              }},
    MetricRow{"talus_heights_generated_total",
              "Columns whose height was looked up.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.heights_made); }},
    MetricRow{"talus_jobs",
              "Chunks that wait for a generator or are in one.",
              gauge,
              {},
              [](const Source& s) { return one(s.gauges.jobs); }},
    MetricRow{"talus_waiting_sessions",
              "Sessions that wait for a generator.",
              gauge,
              {},
              [](const Source& s) { return one(s.gauges.waiting_clients); }},
    MetricRow{"talus_jobs_refused_total",
              "Requests for chunks refused because the generators' queue or the memory was full.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.jobs_refused); }},
    MetricRow{"talus_jobs_cancelled_total",
              "Jobs dropped because no client waited for them any more.",
              counter,
              {},
              [](const Source& s) { return one(s.metrics.jobs_cancelled); }},

    MetricRow{"talus_memory_bytes",
              "Memory that the server accounts for, by use.",
              gauge,
              {"use"},
              [](const Source& s) { return each(s.labels.memory_uses, s.gauges.memory_bytes); }},
    MetricRow{"talus_memory_limit_bytes",
              "The memory budget; 0: none.",
              gauge,
              {},
              [](const Source& s) { return one(s.gauges.memory_limit_bytes); }},

    MetricRow{"process_cpu_seconds_total",
              "User and system CPU time.",
              counter,
              {},
              [](const Source& s) { return one(s.process.cpu_seconds); }},
    MetricRow{"process_start_time_seconds",
              "When the process started, in seconds since 1970.",
              gauge,
              {},
              [](const Source& s) { return one(s.process.start_seconds); }},
    MetricRow{"process_resident_memory_bytes",
              "Resident memory.",
              gauge,
              {},
              [](const Source& s) { return one(s.process.resident_bytes); }},
    MetricRow{"process_virtual_memory_bytes",
              "Virtual memory.",
              gauge,
              {},
              [](const Source& s) { return one(s.process.virtual_bytes); }},
    MetricRow{"process_open_fds",
              "Open file descriptors.",
              gauge,
              {},
              [](const Source& s) { return one(s.process.open_descriptors); }},
    MetricRow{"process_max_fds",
              "Limit of open file descriptors.",
              gauge,
              {},
              [](const Source& s) { return one(s.process.max_descriptors); }},
    MetricRow{
        "process_threads", "Threads.", gauge, {}, [](const Source& s) { return one(s.process.threads); }},
};

prometheus::MetricType type_of(MetricType type) {
  return type == counter ? prometheus::MetricType::Counter
         : type == gauge ? prometheus::MetricType::Gauge
                         : prometheus::MetricType::Histogram;
}

void set_histogram(prometheus::ClientMetric::Histogram& into, const LatencyHistogram& histogram) {
  const LatencyHistogram::Reading reading = histogram.read();
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < LatencyHistogram::kBoundsSeconds.size(); ++i) {
    sum += reading.counts[i];
    into.bucket.push_back({sum, LatencyHistogram::kBoundsSeconds[i]});
  }
  into.sample_count = sum + reading.counts.back();
  into.sample_sum = reading.sum_seconds;
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
    const Samples samples = row.read(sources);
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
