// What a socket's own tests cannot bring about: trouble in the midst of a session's work.
#include "net/connection.h"

#include <algorithm>
#include <asio/io_context.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <cstdint>
#include <thread>

#include <talus/voxel/codec.h>

#include "app/session_settings.h"
#include "fake_generator.h"
#include "net/chunk_service_source.h"

using namespace talus;
using namespace talus::server;
using asio::ip::tcp;

namespace {

/// A connection over loopback, served by a thread, and its other end.
struct Bench {
  FakeService fake;
  ChunkServiceSource source{fake.service};
  Limits limits;
  SessionLimits for_sessions{session_limits(limits)};
  WorldInfo world;
  RateLimits rates;
  SystemClock clock;
  AccessControl access{Access{}, *load_keys(Access{})};
  Admission admission{1, 1};
  Registry registry;
  asio::io_context io{1};
  tcp::socket client{io};
  std::thread thread;

  Bench() {
    tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
    client.connect(acceptor.local_endpoint());
    const ConnectionContext context{
        {for_sessions, world, source, fake.memory, fake.metrics, access, rates, clock},
        limits,
        registry,
        std::make_shared<spdlog::logger>("silent")};
    const auto connection = std::make_shared<Connection>(
        Guest{1, Wire{acceptor.accept()}, "test", *admission.enter(asio::ip::address_v4::loopback()),
              std::chrono::steady_clock::now()},
        context);
    registry.add(1, connection);
    connection->start();
    thread = std::thread{[this] { io.run(); }};
  }
  ~Bench() {
    fake.work->open_gate();
    std::error_code ignored;
    client.shutdown(tcp::socket::shutdown_both, ignored);
    await_end();
  }

  /// The thread ends with the connection: nothing else is in its context.
  void await_end() {
    if (thread.joinable()) thread.join();
  }

  void send(const protocol::Frame& frame) { asio::write(client, asio::buffer(frame)); }
};

}  // namespace

TEST_CASE("what an answer's handler throws ends its connection, and no more") {
  Bench bench;
  bench.fake.work->close_gate();
  bench.send(protocol::make_frame([](auto& builder) {
    const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
    return wire::CreateHello(builder, 1, 1, codecs);
  }));
  // One more than may wait for a generator, so that the first answer has the session look for another.
  bench.send(protocol::make_frame([](auto& builder) {
    std::vector<wire::ChunkRequest> requests;
    for (std::uint32_t id = 1; id <= Delivery::kMaxWaits + 1; ++id) {
      requests.emplace_back(id, wire::ChunkKey{static_cast<std::int32_t>(id), 0, 0, 0}, false,
                            wire::Hash128{});
    }
    return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
  }));
  bench.fake.work->await_somebody_at_gate();
  // The Pong tells that the requests were all looked at.
  bench.send(protocol::make_frame([](auto& builder) { return wire::CreatePing(builder, 1); }));
  protocol::FrameReader frames{protocol::kServerFrameBytes};
  for (bool ponged = false; !ponged;) {
    std::array<std::byte, 4096> buffer{};
    std::span<const std::byte> bytes{buffer.data(), bench.client.read_some(asio::buffer(buffer))};
    while (!bytes.empty()) {
      bytes = bytes.subspan(*frames.feed(bytes));
      if (!frames.has_frame()) continue;
      ponged = (*protocol::read_message(frames.frame()))->body_type() == wire::Body::Pong;
      frames.pop();
    }
  }

  bench.fake.work->finding_throws = true;
  bench.fake.work->open_gate();
  std::error_code ended;
  std::array<std::byte, 65536> rest{};
  while (!ended) (void)bench.client.read_some(asio::buffer(rest), ended);
  bench.await_end();
  CHECK(bench.registry.all().empty());
  CHECK(bench.admission.connections() == 0);
}

TEST_CASE("what is gathered grows while the kernel takes it whole, and shrinks while it does not") {
  GatherSize gather;
  CHECK(gather.bytes() == GatherSize::kLeast);
  gather.wrote(gather.bytes() - 1, true);  // there was no more to say
  CHECK(gather.bytes() == GatherSize::kLeast);
  for (int write = 0; write < 10; ++write) gather.wrote(gather.bytes() + 100, true);
  CHECK(gather.bytes() == GatherSize::kMost);
  gather.wrote(100, false);
  CHECK(gather.bytes() == GatherSize::kMost / 2);
  for (int write = 0; write < 10; ++write) gather.wrote(100, false);
  CHECK(gather.bytes() == GatherSize::kLeast);
}

TEST_CASE("however much one client takes, another's Pong waits for two of its turns at most") {
  // Both connections and both clients in this thread: what happens between two steps is all that happens.
  FakeService fake;
  fake.work->payload_bytes = 20'000;
  Limits limits;
  limits.window_bytes = std::uint64_t{1} << 30;
  limits.queued_bytes_per_session = std::uint64_t{1} << 30;
  const SessionLimits for_sessions = session_limits(limits);
  ChunkServiceSource source{fake.service};
  const WorldInfo world;
  const RateLimits rates;
  const SystemClock clock;
  AccessControl access{Access{}, *load_keys(Access{})};
  Admission admission{2, 2};
  Registry registry;
  asio::io_context io{1};
  tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  const ConnectionContext context{
      {for_sessions, world, source, fake.memory, fake.metrics, access, rates, clock},
      limits,
      registry,
      std::make_shared<spdlog::logger>("silent")};
  std::vector<tcp::socket> clients;
  for (ConnectionId id = 0; id < 2; ++id) {
    clients.emplace_back(io).connect(acceptor.local_endpoint());
    const auto connection = std::make_shared<Connection>(
        Guest{id, Wire{acceptor.accept()}, "test", *admission.enter(asio::ip::address_v4::loopback()),
              std::chrono::steady_clock::now()},
        context);
    registry.add(id, connection);
    connection->start();
    asio::write(clients[id], asio::buffer(protocol::make_frame([](auto& builder) {
                  const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
                  return wire::CreateHello(builder, 1, 1, codecs);
                })));
    clients[id].non_blocking(true);
  }
  std::vector<std::byte> buffer(1 << 20);
  std::array<std::uint64_t, 2> got{};
  const auto drain = [&](std::size_t who) {
    for (std::error_code none;;) {
      const std::size_t bytes = clients[who].read_some(asio::buffer(buffer), none);
      if (none) return;
      got[who] += bytes;
    }
  };
  // The greedy one wants more than ever comes, and takes everything as soon as it comes.
  asio::write(clients[0], asio::buffer(protocol::make_frame([](auto& builder) {
                const wire::Voxel centre{};
                return wire::CreateView(builder, &centre, nullptr, 40, 0);
              })));
  const auto run_until = [&](auto&& holds) {
    while (!holds()) {
      io.run_one();
      drain(0);
      drain(1);
    }
  };
  run_until([&] { return got[0] > 1'000'000 && got[1] > 0; });
  std::uint64_t longest = 0;
  for (int ping = 0; ping < 50; ++ping) {
    const std::uint64_t greedy_before = fake.metrics.sent_bytes.total();
    const std::uint64_t before = got[1];
    asio::write(
        clients[1],
        asio::buffer(protocol::make_frame([](auto& builder) { return wire::CreatePing(builder, 1); })));
    run_until([&] { return got[1] > before; });
    longest = std::max(longest, fake.metrics.sent_bytes.total() - greedy_before);
  }
  CHECK(longest <= 2 * (GatherSize::kMost + 20'000 + 1000));
  for (const auto& connection : registry.all()) connection->go_away("the test is over", {});
  for (tcp::socket& client : clients) client.close();
  while (!registry.all().empty()) io.run_one();
}
