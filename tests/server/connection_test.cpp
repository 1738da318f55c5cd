// What a socket's own tests cannot bring about: trouble in the midst of a session's work.
#include "net/connection.h"

#include <asio/io_context.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <thread>

#include <talus/voxel/codec.h>

#include "fake_generator.h"

using namespace talus;
using namespace talus::server;
using asio::ip::tcp;

namespace {

/// A connection over loopback, served by a thread, and its other end.
struct Bench {
  FakeService fake;
  Limits limits;
  WorldInfo world;
  Admission admission{1, 1};
  Registry registry;
  asio::io_context io{1};
  tcp::socket client{io};
  std::thread thread;

  Bench() {
    tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
    client.connect(acceptor.local_endpoint());
    const ConnectionContext context{
        {limits, world, fake.service, fake.metrics}, registry, std::make_shared<spdlog::logger>("silent")};
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
    for (std::uint32_t id = 1; id <= Session::kServiceWindow + 1; ++id) {
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
