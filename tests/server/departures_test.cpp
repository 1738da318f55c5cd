#include "net/departures.h"

#include <asio/io_context.hpp>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "runtime/manual_clock.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

struct Player final : Peer {
  Player(Clock::time_point began, std::optional<std::uint16_t> proxy_port) : since{began}, port{proxy_port} {}
  [[nodiscard]] std::optional<Clock::time_point> session_since() const override { return since; }
  [[nodiscard]] std::optional<std::uint16_t> proxy_port() const override { return port; }
  void go_away(const std::string&, std::chrono::milliseconds retry_after) override {
    ++told;
    wait = retry_after;
  }
  void access_changed() override {}
  void rates_changed() override {}
  Clock::time_point since;
  std::optional<std::uint16_t> port;
  int told = 0;
  std::chrono::milliseconds wait{-1};
};

struct Bench {
  asio::io_context io;
  ManualClock clock;
  Registry registry;
  Departures departures{io, registry, clock};
  std::vector<std::shared_ptr<Player>> players;

  void join(std::size_t count, std::optional<std::uint16_t> port = 4780) {
    for (std::size_t i = 0; i < count; ++i) {
      players.push_back(std::make_shared<Player>(clock.now(), port));
      registry.add(players.size(), players.back());
    }
  }
  [[nodiscard]] std::size_t told() const {
    std::size_t count = 0;
    for (const auto& player : players) count += player->told > 0 ? 1U : 0U;
    return count;
  }
  void all_told_leave() {
    for (std::size_t i = 0; i < players.size(); ++i) {
      if (players[i]->told > 0) registry.remove(i + 1);
    }
  }
};

const BalanceSettings kSettings{10, 10, 60s};

std::string of_balancer(std::size_t here, std::size_t all) {
  return "UP; weight=1/2; scur=" + std::to_string(here) + "/" + std::to_string(all);
}

}  // namespace

TEST_CASE("players are sent away evenly over the time, the longest connected first, and may come at once") {
  Bench bench;
  bench.join(100);
  bench.departures.send_all(1s);
  std::size_t before = bench.told();
  CHECK(before <= 3);
  for (int turn = 1; turn <= 60; ++turn) {
    bench.clock.advance(20ms);
    bench.io.restart();
    bench.io.run_one();
    const std::size_t now = bench.told();
    if (turn < 50) {
      CHECK(now - before <= 3);
      CHECK(now >= static_cast<std::size_t>(turn));
      // No gaps: who came first goes first.
      CHECK(bench.players[now - 1]->told == 1);
    }
    before = now;
    bench.all_told_leave();
    if (now == 100) break;
  }
  CHECK(before == 100);
  for (const auto& player : bench.players) {
    CHECK(player->told == 1);
    CHECK(player->wait == 0ms);
  }
}

TEST_CASE("a client that connects after all were sent away is sent away at once") {
  Bench bench;
  bench.departures.send_all(0s);
  bench.join(1);
  CHECK(bench.told() == 1);
}

TEST_CASE("the fullest server sends away what is more than its share, no faster than allowed") {
  Bench bench;
  bench.join(100);
  bench.clock.advance(60s + 1ms);
  CHECK(bench.departures.balancer_says(of_balancer(100, 100), kSettings) == 10);
  CHECK(bench.departures.balancer_says(of_balancer(100, 100), kSettings) == 0);
  CHECK(bench.players[9]->told == 1);
  CHECK(bench.players[10]->told == 0);
  bench.all_told_leave();
  std::size_t here = 90;
  for (int second = 0; second < 10; ++second) {
    bench.clock.advance(1s);
    here -= bench.departures.balancer_says(of_balancer(here, 100), kSettings);
    bench.all_told_leave();
  }
  CHECK(here == 55);  // a tenth more than its half
}

TEST_CASE("sessions that leave are not counted twice, and young ones stay") {
  Bench bench;
  bench.join(20);
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), kSettings) == 0);
  bench.clock.advance(61s);
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), kSettings) == 9);
  bench.clock.advance(1s);
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), kSettings) == 0);
  bench.all_told_leave();
  bench.join(9);  // as many come, and are the last to be sent on
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), kSettings) == 9);
  CHECK(bench.players.back()->told == 0);
}

TEST_CASE("a way through a balancer with too many players here sends some of its own") {
  Bench bench;
  bench.join(20, 4780);
  bench.join(20, 4810);
  bench.clock.advance(61s);
  CHECK(bench.departures.balancer_says(of_balancer(20, 40), kSettings, PortRange{4780, 4780}) == 0);
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), kSettings, PortRange{4800, 4863}) == 9);
  for (std::size_t i = 0; i < 20; ++i) CHECK(bench.players[i]->told == 0);
  CHECK(bench.told() == 9);
  // Those leave, and are none of the other way's.
  bench.clock.advance(1s);
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), kSettings, PortRange{4780, 4780}) == 9);
  CHECK(bench.told() == 18);
  CHECK(bench.departures.balancer_says(of_balancer(5, 5), kSettings, PortRange{0, 0}) == 0);
}

TEST_CASE("players without a proxy are never sent away for a balancer's ports") {
  Bench bench;
  bench.join(20, std::nullopt);
  bench.clock.advance(1s);
  bench.join(20, 0);  // by a proxy that says no port
  bench.clock.advance(61s);
  const auto says = [&](std::optional<PortRange> ports) {
    bench.clock.advance(1s);
    const std::size_t sent = bench.departures.balancer_says(of_balancer(20, 20), kSettings, ports);
    bench.all_told_leave();
    return sent;
  };
  CHECK(says(PortRange{0, 0}) == 9);
  CHECK(says(PortRange{0, UINT16_MAX}) == 9);
  CHECK(says(PortRange{0, 0}) == 2);
  CHECK(says(PortRange{0, UINT16_MAX}) == 0);
  for (std::size_t i = 0; i < 20; ++i) CHECK(bench.players[i]->told == 0);
  // A check that names no ports is of all.
  CHECK(says(std::nullopt) == 9);
}

TEST_CASE("a balancer's useless check sends no player away") {
  Bench bench;
  bench.join(20);
  bench.clock.advance(61s);
  CHECK(bench.departures.balancer_says("DOWN; weight=1/2; scur=20/20", kSettings) == 0);
  CHECK(bench.departures.balancer_says("", kSettings) == 0);
  CHECK(bench.departures.balancer_says(of_balancer(20, 20), {0, 10, 60s}) == 0);
  CHECK(bench.told() == 0);
}
