// Attacks that the operators' port outlives: every probe is answered while they last.
//
// Each takes a tenth of TALUS_HOSTILE_SECONDS (siege.h), with ten probes a second. How long the answers took
// is printed, and no verdict.
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <atomic>
#include <catch2/catch.hpp>
#include <deque>
#include <iomanip>
#include <iostream>
#include <memory>
#include <stop_token>
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
using asio::ip::tcp;
using std::chrono::milliseconds;

namespace {

using Clock = std::chrono::steady_clock;

const std::vector<std::string> kWithOperators{"--admin", "127.0.0.1:0"};

/// Limits of one address that do not hold an attack from this machine.
Settings unlimited(Settings more = {}) {
  more.merge(Settings{{"TALUS_LIMITS_CONNECTIONS_PER_ADDRESS", "2048"},
                      {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND", "1000000"},
                      {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST", "1000000"},
                      {"TALUS_LOG_LEVEL", "error"}});
  return more;
}

tcp::endpoint at_port(std::uint16_t port) {
  return {asio::ip::address_v4::loopback(), port};
}

/// What the operators' server answers on a connection of its own, as a probe asks; "" where nothing came.
std::string ask(std::uint16_t port, const std::string& path) {
  asio::io_context io;
  tcp::socket socket{io};
  const std::string request = "GET " + path + " HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n";
  std::string said;
  std::string answer;
  socket.async_connect(at_port(port), [&](std::error_code failed) {
    if (!failed) asio::write(socket, asio::buffer(request), failed);
    asio::async_read(socket, asio::dynamic_buffer(said),
                     [&](std::error_code, std::size_t bytes) { answer = said.substr(0, bytes); });
  });
  io.run_for(std::chrono::seconds{60});  // a server that works is not waited for
  return answer;
}

/// How long probes took, all of them answered with 200.
struct Probes {
  std::vector<double> took_ms;

  void probe(std::uint16_t port, const std::string& path) {
    const auto begin = Clock::now();
    const std::string answer = ask(port, path);
    took_ms.push_back(std::chrono::duration<double, std::milli>{Clock::now() - begin}.count());
    CAPTURE(took_ms.size());
    REQUIRE_THAT(answer, Catch::StartsWith("HTTP/1.1 200 "));
  }
  void print(const std::string& what) {
    std::sort(took_ms.begin(), took_ms.end());
    std::cout << what << ": " << took_ms.size() << " answered" << std::fixed << std::setprecision(1)
              << ", median " << took_ms[took_ms.size() / 2] << " ms, worst " << took_ms.back() << " ms\n";
  }
};

/// Probes health and metrics for the time of one attack, checks that each probe is answered, and prints how
/// long that took.
void probe_during(const std::string& attack, std::uint16_t port) {
  const auto probes = std::max<long>(1, siege_time().count());  // ten a second, for a tenth of that time
  Probes health;
  Probes metrics;
  auto due = Clock::now();
  for (long probe = 0; probe < probes; ++probe) {
    std::this_thread::sleep_until(due += milliseconds{100});
    health.probe(port, "/-/healthy");
    metrics.probe(port, "/metrics");
  }
  health.print(attack + ": health");
  metrics.print(attack + ": metrics");
}

double metric(std::uint16_t port, const std::string& series) {
  const std::string text = ask(port, "/metrics");
  const std::size_t at = text.find("\n" + series + " ");
  INFO(text);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + series.size() + 2));
}

/// Connects, and resets the connection at once.
void reset_one(asio::io_context& io, std::uint16_t port) {
  tcp::socket socket{io};
  std::error_code failed;
  socket.connect(at_port(port), failed);
  if (!failed) socket.set_option(asio::socket_base::linger{true, 0}, failed);
}

}  // namespace

TEST_CASE("under siege operators are answered: connections that are reset before they are accepted") {
  ServerProcess server{unlimited(), kWithOperators};
  const std::uint16_t operators = server.admin_port();
  std::atomic<std::uint64_t> resets = 0;
  std::jthread attack{[&, players = server.port()](const std::stop_token& stop) {
    asio::io_context io;
    while (!stop.stop_requested() || resets < 10'000) {
      reset_one(io, operators);
      reset_one(io, players);
      resets += 2;
    }
  }};
  probe_during("resets", operators);
  attack.request_stop();
  attack.join();
  std::cout << "resets: " << resets << " connections\n";
  CHECK_THAT(ask(operators, "/-/healthy"), Catch::StartsWith("HTTP/1.1 200 "));
  (void)greeted(server.port());
}

TEST_CASE("under siege operators are answered: players take every descriptor") {
  constexpr rlim_t kDescriptors = 64;
  constexpr std::size_t kSilent = 60;
  ServerProcess server{unlimited(), kWithOperators};
  const std::uint16_t operators = server.admin_port();
  (void)greeted(server.port());  // it has set its limit
  const rlimit few{kDescriptors, kDescriptors};
  REQUIRE(::prlimit(server.pid(), RLIMIT_NOFILE, &few, nullptr) == 0);
  {
    std::vector<RawClient> silent;
    // By WebSocket those are silent who have not asked for one.
    for (std::size_t i = 0; i < kSilent; ++i) silent.emplace_back(server.port(), kLoopback, Transport::tcp);
    std::jthread attack{[players = server.port()](const std::stop_token& stop) {
      asio::io_context io;
      std::deque<tcp::socket> held;
      while (!stop.stop_requested()) {
        std::error_code refused;
        held.emplace_back(io).connect(at_port(players), refused);
        if (held.size() > 100) held.pop_front();
      }
    }};
    probe_during("no descriptors", operators);
  }
  CHECK(metric(operators, R"(talus_connections_refused_total{reason="descriptors"})") > 0);
  // Once they have left, players come in again.
  const auto comes_in = [&] {
    if (tested_transport() == Transport::websocket) {
      return ask(server.port(), "/v1/world").starts_with("HTTP/1.1 200 ");
    }
    RawClient client{server.port()};
    const auto sent = client.send(hello());
    const auto said = sent ? client.receive() : std::nullopt;
    return said && said->kind() == wire::Body::Welcome;
  };
  while (!comes_in()) continue;
  (void)greeted(server.port());
}

TEST_CASE("under siege operators are answered: a thousand sessions send Views without end") {
  constexpr std::size_t kSessions = 1000;
  allow_many_sockets();
  ServerProcess server{unlimited({{"TALUS_RATES_SESSION_REQUESTS", "0"},
                                  {"TALUS_RATES_ADDRESS_REQUESTS", "0"},
                                  {"TALUS_RATES_SESSION_CHUNKS", "0"},
                                  {"TALUS_RATES_ADDRESS_CHUNKS", "0"},
                                  {"TALUS_RATES_SESSION_BYTES", "0"},
                                  {"TALUS_RATES_ADDRESS_BYTES", "0"}}),
                       kWithOperators};
  const std::uint16_t operators = server.admin_port();
  ViewFloods flood{kSessions, 1, server.port()};
  probe_during("Views", operators);
  std::cout << "Views: about " << flood.stop() << " sent\n";
  CHECK(metric(operators, R"(talus_sessions{state="greeted"})") == kSessions);
}

TEST_CASE("under siege operators are answered: a drain that a thousand clients hold up") {
  constexpr std::size_t kSessions = 1000;
  allow_many_sockets();
  ServerProcess server{unlimited({{"TALUS_SHUTDOWN_DRAIN_MS", "3600000"}, kClassicWorld}), kWithOperators};
  const std::uint16_t operators = server.admin_port();
  std::vector<RawClient> held;
  for (std::size_t i = 0; i < kSessions; ++i) {
    // Credit for one of two answers: the session cannot end.
    held.push_back(greeted(server.port(), 1));
    REQUIRE(held.back().send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0))})));
    (void)held.back().expect_kind<wire::Chunk>();
  }
  server.signal(SIGTERM);
  for (RawClient& client : held) (void)client.expect_kind<wire::GoAway>();
  probe_during("drain", operators);
  CHECK_THAT(ask(operators, "/-/ready"), Catch::StartsWith("HTTP/1.1 503 "));
  held.clear();
  CHECK(server.wait().status == 0);
}
