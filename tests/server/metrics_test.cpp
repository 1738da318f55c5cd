// Counters, and the page that operators read.
#include "runtime/metrics/metrics_page.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

/// The value after a line's name and labels; empty where no such line is.
std::string value_of(const std::string& text, const std::string& series) {
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(series + ' ')) return line.substr(series.size() + 1);
  }
  return {};
}

/// Stands for an enum of another module.
enum class Reason : std::uint8_t { nothing, late, broken };
constexpr std::array<std::string_view, 3> kReasons{"", "late", "broken"};

std::string text_of(const Metrics& metrics, const RuntimeGauges& gauges = {
                                                .memory_bytes = {1, 2, 3},
                                                .certificate_expires = 1'900'000'000,
                                                .edits = RuntimeGauges::Edits{.history_start = 1'700'000'000},
                                                .cluster = RuntimeGauges::Cluster{}}) {
  const BuildInfo build{"1.2.3", 2, "abc", "avx2"};
  const MetricLabels labels{kReasons, kReasons, kReasons, kReasons, kReasons, kReasons, kReasons};
  return metrics_page({metrics, gauges, read_process(), build, labels});
}

std::string file_text(const std::string& path) {
  std::ifstream in{TALUS_SOURCE_DIR "/" + path};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// The names of metrics in a text.
std::set<std::string> names_in(const std::string& text) {
  const std::regex name{"\\b(talus|process)_[a-z_]+\\b"};
  std::set<std::string> names;
  for (auto found = std::sregex_iterator{text.begin(), text.end(), name}; found != std::sregex_iterator{};
       ++found) {
    names.insert(found->str());
  }
  return names;
}

}  // namespace

TEST_CASE("a latency is counted in the bucket whose bound it does not exceed") {
  LatencyHistogram histogram;
  histogram.add(1ms);
  histogram.add(1ms + 1ns);
  histogram.add(11s);
  histogram.add(-1ns);  // a clock may go back
  const LatencyHistogram::Snapshot reading = histogram.read();
  std::uint64_t counted = 0;
  for (std::size_t i = 0; i < reading.counts.size(); ++i) {
    CAPTURE(i);
    const bool bound_ms =
        i < LatencyHistogram::kBoundsSeconds.size() && LatencyHistogram::kBoundsSeconds[i] == 1e-3;
    const bool bound_2ms =
        i < LatencyHistogram::kBoundsSeconds.size() && LatencyHistogram::kBoundsSeconds[i] == 2e-3;
    CHECK(reading.counts[i] == (bound_ms || bound_2ms || i == 0 || i + 1 == reading.counts.size() ? 1 : 0));
    counted += reading.counts[i];
  }
  CHECK(counted == 4);
  CHECK(reading.sum_seconds == Approx(11.002).epsilon(1e-6));
}

TEST_CASE("no addition of many threads is lost") {
  Counter counter;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (int i = 0; i < 10'000; ++i) counter.add();
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(counter.total() == 40'000);
}

TEST_CASE("the text has what was counted under the name and label that dashboards know") {
  Metrics metrics;
  metrics.open.rise();
  metrics.open.rise();
  metrics.greeted.rise();
  metrics.error(Reason::late).add(3);
  metrics.cold_latency.add(3ms);
  metrics.cold_latency.add(20s);
  metrics.patch_ns.add(1'500'000'000);
  const std::string text = text_of(metrics);
  CHECK(value_of(text, R"(talus_sessions{state="handshake"})") == "1");
  CHECK(value_of(text, R"(talus_sessions{state="greeted"})") == "1");
  CHECK(value_of(text, R"(talus_errors_total{code="late"})") == "3");
  CHECK(value_of(text, R"(talus_errors_total{code="broken"})") == "0");
  CHECK(value_of(text, R"(talus_chunk_latency_seconds_bucket{source="cold",le="0.002"})") == "0");
  CHECK(value_of(text, R"(talus_chunk_latency_seconds_bucket{source="cold",le="0.005"})") == "1");
  CHECK(value_of(text, R"(talus_chunk_latency_seconds_bucket{source="cold",le="10"})") == "1");
  CHECK(value_of(text, R"(talus_chunk_latency_seconds_bucket{source="cold",le="+Inf"})") == "2");
  CHECK(value_of(text, R"(talus_chunk_latency_seconds_count{source="cold"})") == "2");
  CHECK(value_of(text, R"(talus_generation_seconds_total{stage="patch"})") == "1.5");
}

TEST_CASE("every series has a help line and a type") {
  std::istringstream lines{text_of({})};
  std::string help;
  std::string type;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line};
    std::string hash, kind, name;
    words >> hash >> kind >> name;
    if (hash == "#") {
      (kind == "HELP" ? help : type) = name;
      continue;
    }
    CAPTURE(line);
    CHECK(line.starts_with(help));
    CHECK(help == type);
  }
}

TEST_CASE("alerts and dashboard use only metrics that exist") {
  const LatencyHistogram publishing;
  const std::string text = text_of({}, {.memory_bytes = {1, 2, 3},
                                        .certificate_expires = 1'900'000'000,
                                        .edits = RuntimeGauges::Edits{.history_start = 1'700'000'000},
                                        .cluster = RuntimeGauges::Cluster{.publishing = &publishing}});
  const std::string file = GENERATE(as<std::string>{}, "docker/alerts.yml", "docker/grafana/talus.json");
  const std::set<std::string> used = names_in(file_text(file));
  CHECK(used.size() > 5);
  for (const std::string& name : used) {
    CAPTURE(file, name);
    const bool sample = text.find("\n" + name + " ") != std::string::npos ||
                        text.find("\n" + name + "{") != std::string::npos;
    CHECK((sample || text.find("# HELP " + name + " ") != std::string::npos));
  }
}

TEST_CASE("every alert has a name, and each of its keys once") {
  std::istringstream lines{file_text("docker/alerts.yml")};
  std::set<std::string> names;
  std::set<std::string> keys;
  const std::set<std::string> all{"expr", "for", "labels", "annotations", "summary", "description"};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || line[begin] == '#') continue;
    constexpr std::string_view kAlert{"- alert: "};
    if (line.compare(begin, kAlert.size(), kAlert) == 0) {
      CAPTURE(line);
      keys.insert("for");  // not every alert waits
      CHECK((names.empty() || keys == all));
      CHECK(names.insert(line.substr(begin + kAlert.size())).second);
      keys.clear();
      continue;
    }
    const std::string key = line.substr(begin, line.find(':') - begin);
    CAPTURE(line);
    if (!names.empty() && all.contains(key)) CHECK(keys.insert(key).second);
  }
  CHECK(keys == all);
  CHECK(names.contains("TalusColdChunksSlow"));
}

TEST_CASE("documents name only metrics of the table") {
  std::set<std::string> known;
  for (const MetricRow& row : metric_rows()) known.emplace(row.name);
  for (const char* const file : {"docs/OPERATIONS.md", "docs/CLUSTER.md", "docs/REFERENCE.md"}) {
    for (const std::string& name : names_in(file_text(file))) {
      CAPTURE(file, name);
      CHECK(known.contains(name));
    }
  }
}

TEST_CASE("a metric's name says its type as Prometheus' rules want it") {
  for (const MetricRow& row : metric_rows()) {
    CAPTURE(row.name);
    CHECK((row.type == MetricType::counter) == row.name.ends_with("_total"));
    CHECK(row.help.ends_with('.'));
  }
}

TEST_CASE("the process knows its memory, its threads and its files") {
  const ProcessStats process = read_process();
  CHECK(process.resident_bytes > 1 << 20);
  CHECK(process.threads >= 1);
  CHECK(process.open_descriptors >= 3);
  CHECK(process.max_descriptors >= process.open_descriptors);
  const auto now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  CHECK(process.start_seconds == Approx(now).margin(3600.0));
  CHECK(process.start_seconds <= now + 1);
}

TEST_CASE("counters by label are printed under the owner's names, and a value without a name is not") {
  Metrics metrics;
  metrics.refused_for(Reason::late).add(3);
  metrics.refused_for(Reason::nothing).add(7);
  metrics.throttled(Reason::broken).add();
  metrics.denied(Reason::broken).add(2);
  const std::string text = text_of(metrics, {.memory_bytes = {1, 4096, 5}});
  CHECK(value_of(text, "talus_connections_refused_total{reason=\"late\"}") == "3");
  CHECK(value_of(text, "talus_connections_refused_total{reason=\"broken\"}") == "0");
  CHECK(text.find("reason=\"\"") == std::string::npos);
  CHECK(value_of(text, "talus_rates_held_total{rate=\"broken\"}") == "1");
  CHECK(value_of(text, "talus_tokens_refused_total{reason=\"broken\"}") == "2");
  CHECK(value_of(text, "talus_memory_bytes{use=\"late\"}") == "4096");
}

TEST_CASE("TLS handshakes are counted by their result") {
  Metrics metrics;
  metrics.tls_late.add(2);
  metrics.handshakes.rise();
  const std::string text = text_of(metrics);
  CHECK(value_of(text, "talus_tls_handshakes_total{result=\"late\"}") == "2");
  CHECK(value_of(text, "talus_tls_handshakes_total{result=\"done\"}") == "0");
  CHECK(value_of(text, "talus_handshakes") == "1");
  CHECK(value_of(text, "talus_tls_certificate_expiry_timestamp_seconds") == "1900000000");
}

TEST_CASE("without a certificate the series of its expiry is absent") {
  CHECK(text_of({}, {}).find("certificate") == std::string::npos);
}

TEST_CASE("metrics of the shared log are shown if there is one") {
  const Metrics metrics;
  LatencyHistogram publishing;
  publishing.add(3ms);
  RuntimeGauges gauges;
  gauges.cluster = {true, false, true, 5, 6, 7, 8, &publishing, 9, 0, 0, false, true, 10};
  const std::string text = text_of(metrics, gauges);
  CHECK(value_of(text, "talus_cluster_connected") == "1");
  CHECK(value_of(text, "talus_cluster_quorum") == "0");
  CHECK(value_of(text, "talus_cluster_state_differs") == "1");
  CHECK(value_of(text, "talus_cluster_lag_messages") == "5");
  CHECK(value_of(text, "talus_cluster_sequence") == "6");
  CHECK(value_of(text, "talus_cluster_republished_total") == "7");
  CHECK(value_of(text, "talus_cluster_gaps_total") == "8");
  CHECK(value_of(text, "talus_cluster_publish_seconds_count") == "1");
  CHECK(value_of(text, "talus_cluster_joins_total") == "9");
  CHECK(value_of(text, "talus_cluster_tail") == "1");
  CHECK(value_of(text, "talus_cluster_false_messages_total") == "10");
  CHECK(text_of(metrics, {}).find("talus_cluster") == std::string::npos);
}

TEST_CASE("edits have metrics if they are stored: waiting edits, editors and latencies") {
  Metrics metrics;
  metrics.edit_latency.add(3ms);
  metrics.edits_refused[Reason::broken].add(4);
  const std::string text =
      text_of(metrics, {.edits = RuntimeGauges::Edits{5, 6, 7, 8, true, 9, 10, 11, 12, 13, 14}});
  CHECK(value_of(text, "talus_edits_revision") == "5");
  CHECK(value_of(text, "talus_edits_waiting{where=\"intake\"}") == "6");
  CHECK(value_of(text, "talus_edits_waiting{where=\"log\"}") == "7");
  CHECK(value_of(text, "talus_editors") == "8");
  CHECK(value_of(text, "talus_edits_read_only") == "1");
  CHECK(value_of(text, "talus_edit_index_bytes") == "9");
  CHECK(value_of(text, "talus_edit_index_limit_bytes") == "10");
  CHECK(value_of(text, "talus_edits_history_bytes") == "11");
  CHECK(value_of(text, "talus_edits_history_limit_bytes") == "12");
  CHECK(value_of(text, "talus_edits_history_start_timestamp_seconds") == "13");
  CHECK(value_of(text, "talus_edits_clock_jumps_total") == "14");
  CHECK(value_of(text, "talus_edits_refused_total{reason=\"broken\"}") == "4");
  CHECK(value_of(text, "talus_edit_latency_seconds_count") == "1");
  const std::string none = text_of(metrics, {});
  CHECK(none.find("talus_edit_latency") == std::string::npos);
  CHECK(none.find("talus_editors") == std::string::npos);
}
