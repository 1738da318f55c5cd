// What operators read: tallies, and their text.
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "log/json_lines.h"
#include "metrics/exposition.h"

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

std::string text_of(const Metrics& metrics) {
  return prometheus_text(metrics, {.certificate_expires = 1'900'000'000}, read_process(),
                         {"1.2.3", 2, "abc", "avx2"});
}

std::string json_line(const std::string& text) {
  spdlog::memory_buf_t out;
  JsonLines{}.format({"talusd", spdlog::level::warn, text}, out);
  return {out.data(), out.size()};
}

}  // namespace

TEST_CASE("a latency is counted in the bucket whose bound it does not exceed") {
  LatencyTally tally;
  tally.add(1ms);
  tally.add(1ms + 1ns);
  tally.add(11s);
  tally.add(-1ns);  // a clock that goes back is no reason to fall over
  const LatencyTally::Reading reading = tally.read();
  std::uint64_t counted = 0;
  for (std::size_t i = 0; i < reading.counts.size(); ++i) {
    CAPTURE(i);
    const bool bound_ms = i < LatencyTally::kBoundsSeconds.size() && LatencyTally::kBoundsSeconds[i] == 1e-3;
    const bool bound_2ms = i < LatencyTally::kBoundsSeconds.size() && LatencyTally::kBoundsSeconds[i] == 2e-3;
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
  metrics.error(talus::wire::ErrorCode::overloaded).add(3);
  metrics.cold_latency.add(3ms);
  metrics.cold_latency.add(20s);
  metrics.patch_ns.add(1'500'000'000);
  const std::string text = text_of(metrics);
  CHECK(value_of(text, R"(talus_sessions{state="handshake"})") == "1");
  CHECK(value_of(text, R"(talus_sessions{state="greeted"})") == "1");
  CHECK(value_of(text, R"(talus_errors_total{code="overloaded"})") == "3");
  CHECK(value_of(text, R"(talus_errors_total{code="malformed"})") == "0");
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

TEST_CASE("alerts and dashboard ask for nothing that is not there") {
  const std::string text = text_of({});
  const std::string file = GENERATE(as<std::string>{}, "alerts.yml", "grafana/talus.json");
  std::ifstream in{TALUS_SOURCE_DIR "/docker/" + file};
  const std::string asked{std::istreambuf_iterator<char>{in}, {}};
  const std::regex name{"\\b(talus|process)_[a-z_]+\\b"};
  std::size_t names = 0;
  for (auto found = std::sregex_iterator{asked.begin(), asked.end(), name}; found != std::sregex_iterator{};
       ++found, ++names) {
    CAPTURE(file, found->str());
    const bool there = text.find("\n" + found->str() + " ") != std::string::npos ||
                       text.find("\n" + found->str() + "{") != std::string::npos;
    CHECK((there || text.starts_with("# HELP " + found->str() + " ")));
  }
  CHECK(names > 5);
}

TEST_CASE("the process knows its memory, its threads and its files") {
  const ProcessReading process = read_process();
  CHECK(process.resident_bytes > 1 << 20);
  CHECK(process.threads >= 1);
  CHECK(process.open_descriptors >= 3);
  CHECK(process.most_descriptors >= process.open_descriptors);
  const auto now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  CHECK(process.start_seconds == Approx(now).margin(3600.0));
  CHECK(process.start_seconds <= now + 1);
}

TEST_CASE("a log line is one JSON object, whatever its text") {
  const std::string text = GENERATE(as<std::string>{}, "plain", "a \"quote\"\nand a line",
                                    "not UTF-8: \xff\xfe", std::string{"nul\0here", 8});
  const std::string line = json_line(text);
  CHECK(std::count(line.begin(), line.end(), '\n') == 1);
  const auto object = nlohmann::json::parse(line);
  CHECK(object.at("level") == "warning");
  if (text.find('\xff') == std::string::npos) CHECK(object.at("text") == text);
  CHECK(object.at("time").get<std::string>().size() == std::string{"2026-01-01T00:00:00.000Z"}.size());
}

TEST_CASE("who was turned away at the door, and how TLS ended, is counted by reason") {
  Metrics metrics;
  metrics.refused_for(Refusal::pace).add(3);
  metrics.tls_late.add(2);
  metrics.handshakes.rise();
  const std::string text = text_of(metrics);
  CHECK(value_of(text, "talus_connections_refused_total{reason=\"pace\"}") == "3");
  CHECK(value_of(text, "talus_connections_refused_total{reason=\"places\"}") == "0");
  CHECK(value_of(text, "talus_tls_handshakes_total{result=\"late\"}") == "2");
  CHECK(value_of(text, "talus_handshakes") == "1");
  CHECK(value_of(text, "talus_tls_certificate_expiry_timestamp_seconds") == "1900000000");
}

TEST_CASE("without a certificate there is no series of its end") {
  const std::string text = prometheus_text({}, {}, read_process(), {"1.2.3", 2, "abc", "avx2"});
  CHECK(text.find("certificate") == std::string::npos);
}
