// A session over a stream in memory, a scripted source of chunks, and a clock that stands still until the
// test moves it: everything happens in the test's own thread, and nothing waits.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>

#include "config/access/access_control.h"
#include "loopback_stream.h"
#include "runtime/manual_clock.h"

#include <asio/executor_work_guard.hpp>
#include "net/session_runner.h"
#include "scripted_source.h"
#include "session_limits_of_tests.h"

namespace talus::server::session_runner_test {

using namespace std::chrono_literals;

using Runner = SessionRunner;

template <Stream S>
std::unique_ptr<SessionStream> session_stream(S stream) {
  return std::make_unique<SessionStreamOf<S>>(std::move(stream));
}

inline protocol::Frame hello() {
  return protocol::make_frame([&](auto& builder) {
    const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
    return wire::CreateHello(builder, protocol::kOldestProtocol, protocol::kProtocolVersion, codecs);
  });
}
inline protocol::Frame ping() {
  return protocol::make_frame([](auto& builder) { return wire::CreatePing(builder, 7); });
}
inline protocol::Frame get_chunks(std::uint32_t first_id, std::uint32_t count) {
  return protocol::make_frame([&](auto& builder) {
    std::vector<wire::ChunkRequest> requests;
    for (std::uint32_t id = first_id; id < first_id + count; ++id) {
      requests.emplace_back(id, wire::ChunkKey{static_cast<std::int32_t>(id), 0, 0, 0}, false,
                            wire::Hash128{});
    }
    return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
  });
}

/// A View of nine chunks.
inline protocol::Frame view_at(std::int64_t x) {
  return protocol::make_frame([&](auto& builder) {
    const wire::Voxel centre{x * kChunkSize, 0, 0};
    return wire::CreateView(builder, &centre, nullptr, 1, 0);
  });
}

/// A context that the test keeps.
inline RunnerContextPtr kept(const RunnerContext& context) {
  return {RunnerContextPtr{}, &context};
}

/// What sessions share, and an io_context that the test runs.
struct Bench {
  explicit Bench(std::uint64_t memory_bytes = 0, const Access& who_may = {}, EditTaker* taker = nullptr)
      : memory{memory_bytes}, access{who_may, *load_keys(who_may)}, edits{taker} {}

  ManualClock clock{std::chrono::sys_seconds{1'700'000'000s}};
  ScriptedSource source;
  MemoryBudget memory;
  Metrics metrics;
  SessionLimits limits = test_limits(1U << 30);
  WorldInfo world;
  CurrentRates rates;
  FlowUses flows;
  AccessControl access;
  EditTaker* edits;
  Admission admission{{10, 10}, clock};
  Registry registry;
  RunnerContext context{{limits, world, source, memory, metrics, access, rates, flows, clock, edits},
                        {65'536, 1U << 20, {10s, 60s, 15s}},
                        registry,
                        make_logger("off", "text")};
  // Sessions that are left when the context is destroyed use what stands above.
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  std::vector<std::shared_ptr<Runner>> runners;

  /// The client's end of a new session.
  std::shared_ptr<Loopback> connect() {
    auto client = std::make_shared<Loopback>(io);
    runners.push_back(begin(LoopbackStream{client}, runners.size() + 1));
    return client;
  }
  template <Stream S>
  std::shared_ptr<Runner> begin(S stream, ConnectionId id) {
    auto runner = Runner::make(session_stream(std::move(stream)), {id, "test", clock.now()},
                               *admission.enter(asio::ip::address_v4::loopback()), kept(context));
    registry.add(id, runner);
    runner->start();
    io.poll();
    return runner;
  }
  std::shared_ptr<Loopback> greeted() {
    auto client = connect();
    send(*client, hello());
    REQUIRE(kinds(*client) == std::vector{wire::Body::Welcome});
    return client;
  }
  void send(Loopback& client, const protocol::Frame& frame) {
    client.send(std::span<const std::byte>{frame});
    io.poll();
  }
  void advance(Clock::duration by) {
    clock.advance(by);
    for (const auto& runner : runners) runner->clock_moved();
    io.poll();
  }
  /// All answers of the source at once, as a generator would give them.
  void answer_all() {
    const auto waiting = source.waiting;
    source.answer_all();
    for (const auto& [key, mailbox] : waiting) mailbox->wake();
    io.poll();
  }

  /// What the client was sent since it was asked last.
  std::vector<protocol::Frame> frames(Loopback& client) {
    std::vector<protocol::Frame> all;
    protocol::FrameReader reader{protocol::kServerFrameBytes};
    std::span<const std::byte> bytes{client.received};
    while (!bytes.empty()) {
      bytes = bytes.subspan(reader.feed(bytes).value());
      if (!reader.has_frame()) continue;
      all.emplace_back(reader.frame().begin(), reader.frame().end());
      reader.pop();
    }
    client.received.clear();
    return all;
  }
  std::vector<wire::Body> kinds(Loopback& client) {
    std::vector<wire::Body> all;
    for (const auto& frame : frames(client)) all.push_back((*protocol::read_message(frame))->body_type());
    return all;
  }
  /// Text of the one Error that the client was sent.
  std::string error(Loopback& client) {
    const auto all = frames(client);
    REQUIRE(all.size() == 1);
    const auto message = protocol::read_message(all.front());
    REQUIRE((*message)->body_type() == wire::Body::Error);
    return (*message)->body_as_Error()->text()->str();
  }
  void check_gone(const Loopback& client) {
    CHECK(client.closed);
    CHECK(registry.empty());
    CHECK(admission.connections() == 0);
    CHECK(metrics.open.now() == 0);
    CHECK(metrics.greeted.now() == 0);
  }
};

}  // namespace talus::server::session_runner_test
