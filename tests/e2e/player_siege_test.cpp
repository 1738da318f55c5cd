// Attacks beside which other players are served. It takes a tenth of TALUS_HOSTILE_SECONDS (siege.h), with
// ten Pings a second of each player. How long the answers took is printed, and no verdict.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iomanip>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "messages.h"
#include "raw_client.h"
#include "server_process.h"
#include "siege.h"
#include "view_flood.h"

using namespace talus;
using namespace talus::e2e;
using std::chrono::milliseconds;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kAddresses = 4;  // of attackers: 127.0.0.1 and the following

/// Checks that all Pings of some players of another address are answered, and prints how long that took.
/// There are as many players that all of the server's threads serve some of them.
void ping_beside(const std::string& attack, std::uint16_t port) {
  constexpr std::size_t kPlayers = 4;
  std::vector<RawClient> players;
  for (std::size_t i = 0; i < kPlayers; ++i) players.push_back(greeted(port, 0, kLoopback + kAddresses));
  std::vector<double> took_ms;
  auto due = Clock::now();
  for (long round = 0; round < std::max<long>(1, siege_time().count()); ++round) {
    std::this_thread::sleep_until(due += milliseconds{100});
    for (RawClient& player : players) {
      const auto begin = Clock::now();
      REQUIRE(player.send(ping(static_cast<std::uint64_t>(round))));
      (void)player.expect_kind<wire::Pong>();
      took_ms.push_back(std::chrono::duration<double, std::milli>{Clock::now() - begin}.count());
    }
  }
  std::sort(took_ms.begin(), took_ms.end());
  std::cout << attack << ": " << took_ms.size() << " Pings of other players, " << std::fixed
            << std::setprecision(1) << "median " << took_ms[took_ms.size() / 2] << " ms, p99 "
            << took_ms[took_ms.size() * 99 / 100] << " ms, worst " << took_ms.back() << " ms\n";
}

void flood_with_views(const std::string& what, Settings settings) {
  constexpr std::size_t kSessions = kSanitized ? 50 : 1000;  // sanitizers take ten times as long
  allow_many_sockets();
  settings.emplace("TALUS_LOG_LEVEL", "error");
  const ServerProcess server{settings};
  ViewFloods flood{kSessions, kAddresses, server.port()};
  ping_beside(what, server.port());
  std::cout << what << ": about " << flood.stop() << " Views sent\n";
}

}  // namespace

TEST_CASE("under siege players' Pings are answered: a thousand sessions of four addresses send Views") {
  flood_with_views("Views by the rates as shipped", {});
}

TEST_CASE("under siege players' Pings are answered: the same without a rate") {
  flood_with_views("Views without a rate", {{"TALUS_RATES_SESSION_REQUESTS", "0"},
                                            {"TALUS_RATES_ADDRESS_REQUESTS", "0"},
                                            {"TALUS_RATES_SESSION_CHUNKS", "0"},
                                            {"TALUS_RATES_ADDRESS_CHUNKS", "0"},
                                            {"TALUS_RATES_SESSION_BYTES", "0"},
                                            {"TALUS_RATES_ADDRESS_BYTES", "0"}});
}
