#include "metrics/exposition.h"

#include <array>
#include <utility>
#include <vector>

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

namespace talus::server {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

constexpr double kSecondsInNanosecond = 1e-9;

/// One number under its label, if it has one.
struct Labelled {
  std::vector<ClientMetric::Label> labels;
  double value = 0;
};

class Page {
 public:
  void counter(std::string name, std::string help, double total) {
    counters(std::move(name), std::move(help), {{{}, total}});
  }
  void counter(std::string name, std::string help, const Counter& counter) {
    this->counter(std::move(name), std::move(help), static_cast<double>(counter.total()));
  }
  void counters(std::string name, std::string help, const std::vector<Labelled>& values) {
    MetricFamily& family = add(std::move(name), std::move(help), MetricType::Counter);
    for (const Labelled& each : values) {
      ClientMetric& metric = family.metric.emplace_back();
      metric.label = each.labels;
      metric.counter.value = each.value;
    }
  }
  void gauge(std::string name, std::string help, double value) {
    gauges(std::move(name), std::move(help), {{{}, value}});
  }
  void gauges(std::string name, std::string help, const std::vector<Labelled>& values) {
    MetricFamily& family = add(std::move(name), std::move(help), MetricType::Gauge);
    for (const Labelled& each : values) {
      ClientMetric& metric = family.metric.emplace_back();
      metric.label = each.labels;
      metric.gauge.value = each.value;
    }
  }
  MetricFamily& histograms(std::string name, std::string help) {
    return add(std::move(name), std::move(help), MetricType::Histogram);
  }

  [[nodiscard]] std::string text() const { return prometheus::TextSerializer{}.Serialize(families_); }

 private:
  MetricFamily& add(std::string name, std::string help, MetricType type) {
    MetricFamily& family = families_.emplace_back();
    family.name = std::move(name);
    family.help = std::move(help);
    family.type = type;
    return family;
  }

  std::vector<MetricFamily> families_;
};

void add_histogram(MetricFamily& family, const char* source, const LatencyTally& tally) {
  const LatencyTally::Reading reading = tally.read();
  ClientMetric& metric = family.metric.emplace_back();
  metric.label = {{"source", source}};
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < LatencyTally::kBoundsSeconds.size(); ++i) {
    sum += reading.counts[i];
    metric.histogram.bucket.push_back({sum, LatencyTally::kBoundsSeconds[i]});
  }
  metric.histogram.sample_count = sum + reading.counts.back();
  metric.histogram.sample_sum = reading.sum_seconds;
}

void add_connections(const Metrics& metrics, Page& page) {
  const auto open = static_cast<double>(metrics.open.now());
  const auto greeted = static_cast<double>(metrics.greeted.now());
  page.gauges("talus_sessions", "Connections open now, by how far they are.",
              {{{{"state", "handshake"}}, open - greeted}, {{{"state", "greeted"}}, greeted}});
  page.counter("talus_connections_total", "Connections that got a place.", metrics.accepted);
  constexpr std::array<const char*, kRefusals> kReasons{"places", "memory", "pace", "handshakes", "proxy"};
  std::vector<Labelled> refused;
  for (std::size_t why = 0; why < kRefusals; ++why) {
    refused.push_back({{{"reason", kReasons[why]}}, static_cast<double>(metrics.refused[why].total())});
  }
  page.counters("talus_connections_refused_total", "Connections turned away, by reason.", refused);
  page.counter("talus_received_bytes_total", "Bytes received from clients.", metrics.received_bytes);
  page.counter("talus_sent_bytes_total", "Bytes written to clients.", metrics.sent_bytes);
  std::vector<Labelled> errors;
  for (std::size_t code = 1; code < metrics.errors.size(); ++code) {
    errors.push_back({{{"code", wire::EnumNameErrorCode(static_cast<wire::ErrorCode>(code))}},
                      static_cast<double>(metrics.errors[code].total())});
  }
  page.counters("talus_errors_total", "Error messages to clients, by code.", errors);
  std::vector<Labelled> held;
  for (std::size_t rate = 0; rate < kRateNames.size(); ++rate) {
    held.push_back({{{"rate", kRateNames[rate]}}, static_cast<double>(metrics.rates_held[rate].total())});
  }
  page.counters("talus_rates_held_total", "How often a rate refused a request or made chunks wait.", held);
  const auto denied = [&](Denial denial) {
    return static_cast<double>(metrics.tokens_denied[static_cast<std::size_t>(denial)].total());
  };
  page.counters("talus_tokens_refused_total", "Clients turned away or sent away for their token, by reason.",
                {{{{"reason", "missing"}}, denied(Denial::missing)},
                 {{{"reason", "expired"}}, denied(Denial::expired)},
                 {{{"reason", "not_accepted"}}, denied(Denial::not_accepted)}});
}

void add_handshakes(const Metrics& metrics, const Depths& depths, Page& page) {
  page.gauge("talus_handshakes", "Handshakes with proxies and by TLS that are under way.",
             static_cast<double>(metrics.handshakes.now()));
  page.counters("talus_tls_handshakes_total", "TLS handshakes, by how they ended.",
                {{{{"result", "done"}}, static_cast<double>(metrics.tls_handshakes.total())},
                 {{{"result", "failed"}}, static_cast<double>(metrics.tls_failed.total())},
                 {{{"result", "late"}}, static_cast<double>(metrics.tls_late.total())}});
  if (depths.certificate_expires == 0) return;
  page.gauge("talus_tls_certificate_expiry_timestamp_seconds", "When the certificate ends, since 1970.",
             static_cast<double>(depths.certificate_expires));
}

void add_chunks(const Metrics& metrics, Page& page) {
  MetricFamily& latency = page.histograms(
      "talus_chunk_latency_seconds",
      "From when a session takes up a wish for a chunk to when the chunk is ready to be sent.");
  add_histogram(latency, "hot", metrics.hot_latency);
  add_histogram(latency, "cold", metrics.cold_latency);
  page.counter("talus_chunks_sent_total", "Chunk messages.", metrics.chunks_sent);
  page.counter("talus_chunk_bytes_sent_total", "Bytes of Chunk messages.", metrics.chunk_bytes_sent);
  page.counter("talus_columns_sent_total", "Column messages, which stand for a column's uniform chunks.",
               metrics.columns_sent);
  page.counter("talus_unchanged_sent_total", "Unchanged messages.", metrics.unchanged_sent);
}

void add_generation(const Metrics& metrics, const Depths& depths, Page& page) {
  page.counter("talus_cache_hits_total", "Chunks found in memory.", metrics.cache_hits);
  page.counter("talus_cache_misses_total", "Chunks looked for in memory and not found.",
               metrics.cache_misses);
  page.counter("talus_uniform_answers_total", "Chunks known without looking: rock or air throughout.",
               metrics.uniform_answers);
  page.gauges("talus_cache_bytes", "Bytes held by each cache.",
              {{{{"cache", "chunks"}}, static_cast<double>(depths.chunk_cache_bytes)},
               {{{"cache", "patches"}}, static_cast<double>(depths.patch_cache_bytes)}});
  page.counter("talus_patches_generated_total", "Patches of terrain generated.", metrics.patches_made);
  page.counter("talus_chunks_generated_total", "Chunks cut and encoded.", metrics.chunks_made);
  page.counters(
      "talus_generation_seconds_total", "CPU time of generator threads, by what they did.",
      {{{{"stage", "patch"}}, static_cast<double>(metrics.patch_ns.total()) * kSecondsInNanosecond},
       {{{"stage", "chunk"}}, static_cast<double>(metrics.chunk_ns.total()) * kSecondsInNanosecond},
       {{{"stage", "heights"}}, static_cast<double>(metrics.heights_ns.total()) * kSecondsInNanosecond}});
  page.counter("talus_heights_generated_total", "Columns whose height was looked up.", metrics.heights_made);
  page.gauge("talus_jobs", "Chunks that wait for a generator or are in one.",
             static_cast<double>(depths.jobs));
  page.gauge("talus_waiting_sessions", "Sessions with something waiting for a generator.",
             static_cast<double>(depths.waiting_clients));
  page.counter("talus_jobs_refused_total",
               "Wishes refused because the generators' queue was full or memory all in use.",
               metrics.jobs_refused);
  page.counter("talus_jobs_cancelled_total", "Jobs dropped because nobody waited any more.",
               metrics.jobs_cancelled);
}

void add_memory(const Depths& depths, Page& page) {
  std::vector<Labelled> used;
  for (std::size_t use = 0; use < kMemoryUses.size(); ++use) {
    used.push_back({{{"use", kMemoryUses[use]}}, static_cast<double>(depths.memory_bytes[use])});
  }
  page.gauges("talus_memory_bytes", "Memory that the server knows it holds, by what for.", used);
  page.gauge("talus_memory_limit_bytes", "What it may hold; 0 where there is no limit.",
             static_cast<double>(depths.memory_limit_bytes));
}

void add_process(const ProcessReading& process, Page& page) {
  page.counter("process_cpu_seconds_total", "User and system time spent.", process.cpu_seconds);
  page.gauge("process_start_time_seconds", "When the process began, since 1970.", process.start_seconds);
  page.gauge("process_resident_memory_bytes", "Memory in use.", static_cast<double>(process.resident_bytes));
  page.gauge("process_virtual_memory_bytes", "Memory mapped.", static_cast<double>(process.virtual_bytes));
  page.gauge("process_open_fds", "Open files and sockets.", static_cast<double>(process.open_descriptors));
  page.gauge("process_max_fds", "How many there may be.", static_cast<double>(process.most_descriptors));
  page.gauge("process_threads", "Threads.", static_cast<double>(process.threads));
}

}  // namespace

std::string prometheus_text(const Metrics& metrics, const Depths& depths, const ProcessReading& process,
                            const BuildInfo& build) {
  Page page;
  page.gauges("talus_build_info", "What runs; always 1.",
              {{{{"version", build.version},
                 {"generator", std::to_string(build.generator)},
                 {"fingerprint", build.fingerprint},
                 {"instruction_set", build.instruction_set}},
                1}});
  page.gauge("talus_draining", "1 from the signal to end until the end.", depths.draining ? 1 : 0);
  add_connections(metrics, page);
  add_handshakes(metrics, depths, page);
  add_chunks(metrics, page);
  add_generation(metrics, depths, page);
  add_memory(depths, page);
  add_process(process, page);
  return page.text();
}

}  // namespace talus::server
