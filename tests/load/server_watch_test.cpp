#include "server_watch.h"

#include <unistd.h>

#include <catch2/catch.hpp>

using namespace talus::load;

TEST_CASE("metrics are read, labels summed") {
  const ServerSample sample = read_metrics(
      "# HELP process_cpu_seconds_total Time\n"
      "# TYPE process_cpu_seconds_total counter\n"
      "process_cpu_seconds_total 12.5\n"
      "process_resident_memory_bytes 1.5e6\n"
      "process_open_fds 33\n"
      "talus_chunks_total{source=\"hot\"} 5\n"
      "talus_chunks_total{source=\"a } b\"} 7 1700000000\n"
      "talus_latency_seconds_bucket{le=\"0.1\"} 9\n"
      "broken\n\n");
  CHECK(sample.cpu_seconds == 12.5);
  CHECK(sample.resident_bytes == 1.5e6);
  CHECK(sample.open_files == 33);
  CHECK(sample.counters.at("talus_chunks_total") == 12);
  CHECK(sample.counters.count("talus_latency_seconds_bucket") == 0);
}

TEST_CASE("a process is read from the system's tables") {
  const auto sample = ServerWatch{std::nullopt, ::getpid()}.sample();
  REQUIRE(sample.has_value());
  CHECK(sample->cpu_seconds.has_value());
  CHECK(sample->resident_bytes > 1e5);
  CHECK(sample->open_files > 2);
}

TEST_CASE("a process that is not there is named") {
  const auto sample = ServerWatch{std::nullopt, 0x3FFFFFFF}.sample();
  REQUIRE_FALSE(sample.has_value());
  CHECK(sample.error().find("--server-pid 1073741823") == 0);
}

TEST_CASE("missing metrics are named") {
  const auto sample = ServerWatch{talus::protocol::Endpoint{"127.0.0.1", 1}, 0}.sample();
  REQUIRE_FALSE(sample.has_value());
  CHECK(sample.error().find("--metrics: http://127.0.0.1:1/metrics") == 0);
}
