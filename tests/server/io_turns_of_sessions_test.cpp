// The order in which an io thread serves the sessions of two addresses.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "net/io_turns.h"
#include "net/websocket/stream.h"
#include "session_runner_bench.h"
#include "websocket_frames.h"

namespace talus::server::session_runner_test {
namespace {

using asio::ip::make_address_v4;

protocol::Frame numbered_ping(std::uint64_t nonce) {
  return protocol::make_frame([&](auto& builder) { return wire::CreatePing(builder, nonce); });
}

/// Sessions of two addresses, by TCP or WebSocket.
struct Sessions {
  Bench bench;
  const bool by_websocket;
  std::vector<std::shared_ptr<Loopback>> greedy;
  std::shared_ptr<Loopback> probe;

  Sessions(bool websocket, int floods) : by_websocket{websocket} {
    bench.admission.change({1000, 1000, {}, {}});
    for (int i = 0; i < floods; ++i) greedy.push_back(begin("192.0.2.1"));
    probe = begin("192.0.2.2");
  }
  std::shared_ptr<Loopback> begin(const char* address) {
    auto client = std::make_shared<Loopback>(bench.io);
    auto stream =
        by_websocket
            ? session_stream(server::websocket::WebSocketStream<LoopbackStream>{LoopbackStream{client}, {}})
            : session_stream(LoopbackStream{client});
    bench.runners.push_back(
        Runner::make(std::move(stream), {bench.runners.size() + 1, address, bench.clock.now()},
                     *bench.admission.enter(make_address_v4(address)), kept(bench.context)));
    bench.runners.back()->start();
    client->send(wrapped(hello()));
    bench.io.poll();
    REQUIRE_FALSE(client->received.empty());
    client->received.clear();
    return client;
  }
  [[nodiscard]] std::vector<std::byte> wrapped(const protocol::Frame& frame) const {
    if (!by_websocket) return {frame.begin(), frame.end()};
    std::vector<std::byte> bytes;
    append_client_frame(bytes, 2, frame, 5);
    return bytes;
  }
  /// Handlers that run until the probe is answered.
  int ask() {
    probe->received.clear();
    probe->send(wrapped(numbered_ping(1)));
    int handlers = 0;
    for (; probe->received.empty(); ++handlers) REQUIRE(bench.io.poll_one() == 1);
    return handlers;
  }
  [[nodiscard]] std::size_t greedy_bytes() const {
    std::size_t all = 0;
    for (const auto& each : greedy) all += each->received.size();
    return all;
  }
};

}  // namespace

TEST_CASE("a session is answered after a turn of another address, however many sessions flood from there") {
  const bool websocket = GENERATE(false, true);
  CAPTURE(websocket);
  Sessions sessions{websocket, 20};
  std::vector<std::byte> flood;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const auto one = sessions.wrapped(numbered_ping(i));
    flood.insert(flood.end(), one.begin(), one.end());
  }
  for (const auto& each : sessions.greedy) each->send(flood);
  const std::size_t before = sessions.greedy_bytes();
  (void)sessions.ask();
  const std::size_t pong = sessions.probe->received.size();
  // Its own turn, and another flow's; a Pong costs as much as a Ping, or less.
  CHECK(sessions.greedy_bytes() - before <= 2 * IoTurns::kTurn * pong);
  sessions.bench.io.poll();
  for (const auto& each : sessions.greedy) CHECK(each->received.size() >= 200 * (pong - 4));
}

TEST_CASE("WebSocket frames without payload cost their flow turns by their bytes") {
  Sessions sessions{true, 300};
  std::vector<std::byte> controls;
  while (controls.size() < 100'000) append_client_frame(controls, 10, {}, 5);  // Pongs
  for (const auto& each : sessions.greedy) each->send(controls);
  (void)sessions.ask();  // behind the first read of each
  // A read of 8 KiB costs two turns: between two questions one session of the greedy flow goes on.
  for (int i = 0; i < 10; ++i) CHECK(sessions.ask() < 16);
}

}  // namespace talus::server::session_runner_test
