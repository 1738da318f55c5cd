// Work that a client waits for, and checks that the server gives it up.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <talus/protocol/message.h>

#include "http_client.h"
#include "server_process.h"

namespace talus::e2e {

/// A world whose far columns cost a tenth of a millisecond and more each.
inline const Settings kDearColumns{{"TALUS_WORLD", TALUS_SOURCE_DIR "/core/worlds/default.toml"},
                                   {"TALUS_THREADS_GENERATOR", "1"},
                                   {"TALUS_LIMITS_QUEUED_BYTES_PER_SESSION", "65536"}};
inline constexpr std::uint32_t kDearClients = 20;
inline constexpr std::uint32_t kDearRequests = 8;  // of each

inline std::vector<wire::ColumnPos> far_columns(std::uint32_t request) {
  std::vector<wire::ColumnPos> columns;
  for (std::int64_t i = 0; i < 2048; ++i) columns.emplace_back(i * 100'000, std::int64_t{request} * 100'000);
  return columns;
}

inline double metric(std::uint16_t admin, const std::string& series) {
  const std::string text = HttpClient{admin}.get("/metrics").body;
  const std::size_t at = text.find("\n" + series + " ");
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + series.size() + 2));
}

inline void await_metric(std::uint16_t admin, const std::string& series,
                         const std::function<bool(double)>& enough) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes{1};
  while (!enough(metric(admin, series))) {
    INFO(series);
    REQUIRE(std::chrono::steady_clock::now() < give_up);
    std::this_thread::yield();
  }
}
/// Waits until more columns were generated than `before`.
inline void await_work(std::uint16_t admin, double before = 0) {
  await_metric(admin, "talus_heights_generated_total", [&](double heights) { return heights > before; });
}
/// Waits until the server reads nothing more from any session, as too many of its answers wait. Returns the
/// columns generated until then: on a quick machine many, while the clients still connect.
[[nodiscard]] inline double await_pauses(std::uint16_t admin) {
  await_work(admin);
  await_metric(admin, "talus_memory_bytes{use=\"sessions\"}",
               [](double bytes) { return bytes > kDearClients * (65'536 + 32'768); });
  return metric(admin, "talus_heights_generated_total");
}
/// All that the client held is free, and the server does not finish its work.
inline void check_given_up(std::uint16_t admin, double before) {
  await_metric(admin, "talus_memory_bytes{use=\"sessions\"}", [](double bytes) { return bytes == 0; });
  CHECK(metric(admin, "talus_sessions{state=\"greeted\"}") == 0);
  CHECK(metric(admin, "talus_http_connections") == 0);
  CHECK(metric(admin, "talus_waiting_sessions") == 0);
  // The first answers alone, whose writing would show that the clients are gone, are four times as many.
  CHECK(metric(admin, "talus_heights_generated_total") < before + kDearClients * 2048 / 4);
}

}  // namespace talus::e2e
