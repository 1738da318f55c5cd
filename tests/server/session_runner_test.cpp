// A session over a stream in memory, a scripted source of chunks, and a clock that stands still until the
// test moves it: everything happens in the test's own thread, and nothing waits.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <string>

#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>

#include "access/access_control.h"
#include "clock/manual_clock.h"
#include "loopback_stream.h"

#include <asio/executor_work_guard.hpp>
#include "net/session_runner_impl.h"
#include "scratch_directory.h"
#include "scripted_source.h"
#include "session_limits_of_tests.h"
#include "websocket/stream.h"
#include "websocket_frames.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

using Runner = SessionRunner<LoopbackStream>;

protocol::Frame hello() {
  return protocol::make_frame([](auto& builder) {
    const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
    return wire::CreateHello(builder, 1, 1, codecs);
  });
}
protocol::Frame ping() {
  return protocol::make_frame([](auto& builder) { return wire::CreatePing(builder, 7); });
}
protocol::Frame get_chunks(std::uint32_t first_id, std::uint32_t count) {
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
protocol::Frame view_at(std::int64_t x) {
  return protocol::make_frame([&](auto& builder) {
    const wire::Voxel centre{x * kChunkSize, 0, 0};
    return wire::CreateView(builder, &centre, nullptr, 1, 0);
  });
}

/// A context that the test keeps.
RunnerContextPtr kept(const RunnerContext& context) {
  return {RunnerContextPtr{}, &context};
}

/// What sessions share, and an io_context that the test runs.
struct Bench {
  explicit Bench(std::uint64_t memory_bytes = 0) : memory{memory_bytes} {}

  ManualClock clock{std::chrono::sys_seconds{1'700'000'000s}};
  ScriptedSource source;
  MemoryBudget memory;
  Metrics metrics;
  SessionLimits limits = test_limits(1U << 30);
  WorldInfo world;
  CurrentRates rates;
  FlowUses flows;
  AccessControl access{Access{}, *load_keys(Access{})};
  Admission admission{{10, 10}, clock};
  Registry registry;
  RunnerContext context{{limits, world, source, memory, metrics, access, rates, flows, clock},
                        {65'536, 1U << 20, {10s, 60s, 15s}},
                        registry,
                        std::make_shared<spdlog::logger>("silent")};
  // Sessions that are left when the context is destroyed use what stands above.
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  std::vector<std::shared_ptr<Runner>> runners;

  /// The client's end of a new session.
  std::shared_ptr<Loopback> connect() {
    auto client = std::make_shared<Loopback>(io);
    runners.push_back(begin<Runner>(LoopbackStream{client}, runners.size() + 1));
    return client;
  }
  template <typename R, typename S>
  std::shared_ptr<R> begin(S stream, ConnectionId id) {
    auto runner = R::make(std::move(stream), {id, "test", clock.now()},
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

}  // namespace

TEST_CASE("sessions of one address are one flow") {
  Bench bench;
  const FlowId flow = flow_of(asio::ip::address_v4::loopback(), bench.flows)->id();
  for (std::uint32_t id = 1; id <= 2; ++id) {
    const auto client = bench.greeted();
    bench.send(*client, get_chunks(id, 1));
  }
  for (const auto& [key, mailbox] : bench.source.waiting) CHECK(mailbox->flow() == flow);
  CHECK_FALSE(bench.source.waiting.empty());
}

TEST_CASE("all bytes that the clients of a flow are sent are added to it") {
  Bench bench;
  std::uint64_t sent = 0;
  for (int clients = 0; clients < 2; ++clients) {
    const auto client = bench.connect();
    bench.send(*client, hello());
    bench.send(*client, get_chunks(1, 3));
    bench.answer_all();
    sent += client->received.size();
  }
  CHECK(sent > 0);
  CHECK(flow_of(asio::ip::address_v4::loopback(), bench.flows)->used(FlowMeasure::sent) == sent);
}

TEST_CASE("rates that change count for a session that is there, its own and its address's") {
  const bool of_address = GENERATE(true, false);
  Bench bench;
  const auto client = bench.greeted();
  const RateSet two_requests{{}, {}, {1, 2}};
  if (of_address) {
    bench.admission.change({10, 10, {}, two_requests});
  } else {
    bench.rates.set({two_requests, {}});
  }
  bench.registry.rates_changed();
  bench.io.poll();
  for (int i = 0; i < 3; ++i) bench.send(*client, ping());
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Pong, wire::Body::Pong, wire::Body::Error});
}

TEST_CASE("a chunk that waited for a rate goes at once when the rate is lifted") {
  Bench bench;
  bench.rates.set({{{1, 1}, {}, {}}, {}});
  const auto client = bench.greeted();
  bench.send(*client, get_chunks(1, 3));
  bench.answer_all();
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Chunk});
  bench.rates.set({});
  bench.registry.rates_changed();
  bench.io.poll();
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Chunk, wire::Body::Chunk});
}

TEST_CASE("a session that was admitted before its address was blocked, and begins after it, ends") {
  Bench bench;
  const ScratchDirectory lists;
  Access settings;
  settings.blocked_file = lists.write("blocked", "127.0.0.1\n");
  REQUIRE(bench.access.reload(settings).has_value());
  CHECK_THAT(bench.error(*bench.connect()), Catch::Contains("blocked you"));
}

TEST_CASE("a client is greeted and served, however its bytes are cut") {
  const std::size_t piece = GENERATE(as<std::size_t>{}, 1, 3, SIZE_MAX);
  Bench bench;
  const auto client = bench.connect();
  client->read_bytes = piece;
  client->write_bytes = piece;
  bench.send(*client, hello());
  bench.send(*client, get_chunks(1, 2));
  bench.answer_all();
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Welcome, wire::Body::Chunk, wire::Body::Chunk});
}

TEST_CASE("answers that come together are taken by one wake-up") {
  Bench bench;
  const auto client = bench.greeted();
  bench.send(*client, get_chunks(1, 5));
  const std::size_t writes = client->writes;
  bench.answer_all();
  CHECK(bench.frames(*client).size() == 5);
  CHECK(client->writes == writes + 1);
}

TEST_CASE("a chunk that an update needs is asked for at once, also where the stream takes bytes at once") {
  Bench bench;
  const auto client = std::make_shared<Loopback>(bench.io);
  const auto runner = bench.begin<SessionRunner<EagerLoopbackStream>>(EagerLoopbackStream{client}, 1);
  bench.send(*client, hello());
  bench.send(*client, view_at(0));
  bench.answer_all();
  CHECK(bench.frames(*client).size() == 10);  // Welcome and nine chunks
  const ChunkKey edited{{0, 0, 0}, Lod{}};
  bench.source.revisions[edited] = 5;
  bench.source.watcher->put_changes(
      std::make_shared<const std::vector<ChunkChange>>(std::vector{ChunkChange{edited, 0, 5}}));
  bench.source.watcher->wake();
  bench.io.poll();
  REQUIRE(bench.source.waiting.contains(edited));
  bench.source.in_memory[edited] = scripted_chunk(edited, 5);
  const std::size_t writes = client->writes;
  bench.answer_all();
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Chunk});
  CHECK(client->writes == writes + 1);
}

TEST_CASE("a client that closes ends its session") {
  Bench bench;
  const auto client = bench.greeted();
  client->end();
  bench.io.poll();
  bench.check_gone(*client);
}

TEST_CASE("a client that shuts its sending side is served what it asked, then the connection closes") {
  Bench bench;
  const auto client = bench.greeted();
  bench.send(*client, get_chunks(1, 100));
  bench.send(*client, view_at(5000));
  client->end();
  bench.io.poll();
  CHECK_FALSE(client->closed);
  bench.advance(70s);  // that is no silence
  CHECK_FALSE(client->closed);
  while (!bench.source.waiting.empty()) bench.answer_all();
  CHECK(bench.kinds(*client) == std::vector(109, wire::Body::Chunk));
  CHECK(client->said_end);
  bench.check_gone(*client);
}

TEST_CASE("a client that shuts its sending side and reads nothing is closed") {
  Bench bench;
  const auto client = bench.greeted();
  bench.send(*client, get_chunks(1, 1));
  client->end();
  client->room = 0;
  bench.answer_all();
  bench.advance(15s);
  bench.check_gone(*client);
}

TEST_CASE("a client that shuts its sending side gets the Error that ends its session") {
  Bench bench;
  const auto client = bench.connect();
  client->room = 0;
  bench.send(*client, ping());
  client->end();
  client->room = SIZE_MAX;
  client->changed();
  bench.io.poll();
  CHECK_THAT(bench.error(*client), Catch::Contains("the first message must be Hello"));
  bench.check_gone(*client);
}

TEST_CASE("a client that ends inside a frame is closed at once") {
  Bench bench;
  const auto client = bench.greeted();
  bench.send(*client, get_chunks(1, 1));
  client->send("half");
  client->end();
  bench.io.poll();
  bench.check_gone(*client);
}

TEST_CASE("an error of the stream ends its session") {
  Bench bench;
  const auto client = bench.greeted();
  SECTION("while it reads") {
    client->read_error = asio::error::connection_reset;
    client->changed();
  }
  SECTION("while it writes") {
    client->write_error = asio::error::broken_pipe;
    bench.send(*client, ping());
  }
  bench.io.poll();
  bench.check_gone(*client);
}

TEST_CASE("what a session's work throws ends it and no other") {
  struct ThrowingSource final : ChunkSource {
    EncodedChunkPtr find(ChunkKey) override { throw std::bad_alloc{}; }
    EncodedChunkPtr newer(ChunkKey, std::uint64_t) override { return nullptr; }
    MixedRows column(ChunkKey) override { return {}; }
    int columns_together() const override { return 1; }
    std::size_t submit(const MailboxPtr&, std::span<const ChunkKey> keys, Urgency) override {
      return keys.size();
    }
    void hasten(ClientId, std::span<const ChunkKey>) override {}
    void cancel(ClientId, std::span<const ChunkKey>) override {}
    void set_wanted(const MailboxPtr&, std::span<const LevelBox>) override {}
    void submit_heights(const MailboxPtr&, std::uint64_t, HeightsQuery) override {}
    void cancel_heights(ClientId, std::uint64_t) override {}
  } source;
  Bench bench;
  const RunnerContext context{{bench.limits, bench.world, source, bench.memory, bench.metrics, bench.access,
                               bench.rates, bench.flows, bench.clock},
                              bench.context.limits,
                              bench.registry,
                              bench.context.log};
  const auto other = bench.greeted();
  const auto client = std::make_shared<Loopback>(bench.io);
  const auto runner = Runner::make(LoopbackStream{client}, {9, "test", bench.clock.now()},
                                   *bench.admission.enter(asio::ip::address_v4::loopback()), kept(context));
  bench.registry.add(9, runner);
  runner->start();
  bench.send(*client, hello());
  bench.send(*client, get_chunks(1, 1));
  CHECK(client->closed);
  CHECK(bench.admission.connections() == 1);
  bench.send(*other, ping());
  CHECK(bench.kinds(*other) == std::vector{wire::Body::Pong});
}

TEST_CASE("who says no Hello in time is told so and closed") {
  Bench bench;
  const auto client = bench.connect();
  bench.advance(10s - 1ms);
  CHECK(client->received.empty());
  bench.advance(1ms);
  CHECK_THAT(bench.error(*client), Catch::Contains("no whole Hello within 10000 ms"));
  CHECK(client->said_end);
  CHECK(client->shut);
  CHECK_FALSE(client->closed);  // the client has two seconds to read it
  bench.advance(2s);
  bench.check_gone(*client);
}

TEST_CASE("who is silent after Hello is told so; a frame begins the time anew") {
  Bench bench;
  const auto client = bench.greeted();
  bench.advance(59s);
  bench.send(*client, ping());
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Pong});
  bench.advance(59s);
  CHECK(client->received.empty());
  bench.advance(1s);
  CHECK_THAT(bench.error(*client), Catch::Contains("no whole frame for 60000 ms"));
}

TEST_CASE("who reads nothing while it is sent something is closed") {
  Bench bench;
  const auto client = bench.greeted();
  client->room = 10;
  bench.send(*client, ping());
  bench.advance(15s - 1ms);
  CHECK_FALSE(client->closed);
  bench.advance(1ms);
  bench.check_gone(*client);
}

TEST_CASE("who closes its WebSocket and reads nothing is closed in the end") {
  using WebSocketStream = server::websocket::WebSocketStream<LoopbackStream>;
  Bench bench;
  const auto client = std::make_shared<Loopback>(bench.io);
  const auto runner =
      bench.begin<SessionRunner<WebSocketStream>>(WebSocketStream{LoopbackStream{client}, {}}, 1);
  const auto say = [&](int opcode, std::span<const std::byte> payload) {
    std::vector<std::byte> frame;
    append_client_frame(frame, opcode, payload, 5);
    client->send(frame);
    bench.io.poll();
  };
  const auto advance = [&](Clock::duration by) {
    bench.clock.advance(by);
    runner->clock_moved();
    bench.io.poll();
  };
  say(2, hello());
  REQUIRE(bench.metrics.greeted.now() == 1);
  SECTION("behind what it is being sent") {
    client->room = 10;
    say(2, ping());
    say(8, {});
    advance(15s - 1ms);
    CHECK_FALSE(client->closed);
    advance(1ms);
  }
  SECTION("when it is sent nothing but the answer to its Close") {
    client->room = 0;
    say(8, {});
    advance(60s - 1ms);
    CHECK_FALSE(client->closed);
    advance(1ms);  // silent for too long, which it is told
    CHECK_FALSE(client->closed);
    advance(2s);
  }
  bench.check_gone(*client);
}

TEST_CASE("a client that takes a few bytes at a time is not closed") {
  Bench bench;
  const auto client = bench.greeted();
  client->room = 1;
  bench.send(*client, ping());
  for (int step = 0; step < 5; ++step) {
    bench.advance(14s);
    client->room = 1;
    bench.send(*client, ping());
  }
  CHECK_FALSE(client->closed);
}

TEST_CASE("nothing more is read from a client that does not read its answers") {
  Bench bench;
  bench.context.limits.queued_bytes = 1000;
  const auto client = bench.greeted();
  client->room = 0;
  for (int i = 0; i < 1000; ++i) client->send(std::span<const std::byte>{ping()});
  bench.io.poll();
  const std::uint64_t read = bench.metrics.received_bytes.total();
  bench.send(*client, ping());
  CHECK(bench.metrics.received_bytes.total() == read);
  client->room = SIZE_MAX;
  client->changed();
  bench.io.poll();
  CHECK(bench.frames(*client).size() == 1001);
}

TEST_CASE("where memory is short little is read from a client that does not read its answers") {
  Bench bench{256U << 20};
  const auto client = bench.greeted();
  client->room = 0;
  bench.memory.set(MemoryUse::jobs, 256U << 20);
  // Read by read, so that the session looks at the memory between them.
  for (int i = 0; i < 3000; ++i) bench.send(*client, ping());
  const std::uint64_t read = bench.metrics.received_bytes.total();
  bench.send(*client, ping());
  CHECK(bench.metrics.received_bytes.total() == read);
  client->room = SIZE_MAX;
  client->changed();
  bench.io.poll();
  CHECK(bench.frames(*client).size() == 3001);
}

TEST_CASE("a session that is told to go away answers what is pending, then closes") {
  Bench bench;
  const auto client = bench.greeted();
  bench.send(*client, get_chunks(1, 1));
  bench.registry.tell_all_to_go("the end", 5s);
  bench.io.poll();
  CHECK(bench.kinds(*client) == std::vector{wire::Body::GoAway});
  CHECK_FALSE(client->shut);
  bench.answer_all();
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Chunk});
  CHECK(client->shut);
  client->end();
  bench.io.poll();
  bench.check_gone(*client);
}

TEST_CASE("Views of one session are applied twenty milliseconds apart at least") {
  Bench bench;
  bench.source.rows = {0, -1, MaterialId{1}};
  const auto client = bench.greeted();
  const auto look = [&](std::int64_t x) { bench.send(*client, view_at(x)); };
  look(0);
  CHECK_FALSE(bench.frames(*client).empty());
  look(100);
  CHECK(bench.frames(*client).empty());
  bench.advance(20ms);
  CHECK_FALSE(bench.frames(*client).empty());
}

TEST_CASE("a client whose View waits to be applied is heard, until it sends another") {
  Bench bench;
  bench.source.rows = {0, -1, MaterialId{1}};
  const auto client = bench.greeted();
  bench.send(*client, view_at(0));
  CHECK_FALSE(bench.frames(*client).empty());
  bench.send(*client, view_at(100));
  bench.send(*client, ping());
  CHECK(bench.kinds(*client) == std::vector{wire::Body::Pong});
  bench.send(*client, view_at(200));
  bench.send(*client, ping());
  CHECK(bench.kinds(*client).empty());
  bench.advance(20ms);
  const auto kinds = bench.kinds(*client);
  CHECK(kinds.front() == wire::Body::UniformColumn);
  CHECK(std::count(kinds.begin(), kinds.end(), wire::Body::Pong) == 1);
}

TEST_CASE("of many Views that come at once no chunk that stayed in all of them comes twice") {
  Bench bench;
  const auto client = bench.greeted();
  std::map<std::int32_t, int> came;  // by x
  const auto receive_all = [&] {
    while (!bench.source.waiting.empty()) bench.answer_all();
    for (const auto& frame : bench.frames(*client)) {
      const auto message = protocol::read_message(frame);
      if ((*message)->body_type() == wire::Body::Chunk) ++came[(*message)->body_as_Chunk()->key()->x()];
    }
  };
  bench.send(*client, view_at(0));
  receive_all();
  CHECK(came == std::map<std::int32_t, int>{{-1, 3}, {0, 3}, {1, 3}});
  protocol::Frame at_once;
  for (int i = 1; i <= 40; ++i) {
    const protocol::Frame frame = view_at(i % 2);
    at_once.insert(at_once.end(), frame.begin(), frame.end());
  }
  bench.send(*client, at_once);
  for (int i = 0; i < 40; ++i) {
    bench.advance(20ms);
    receive_all();
  }
  CHECK(came[-1] > 3);  // left, and came back
  CHECK(came[0] == 3);
  CHECK(came[1] == 3);
}

TEST_CASE("a View that waits when its client shuts its sending side is applied and served") {
  Bench bench;
  const auto client = bench.greeted();
  bench.send(*client, view_at(0));
  bench.send(*client, view_at(100 * 32));
  client->end();
  bench.io.poll();
  CHECK_FALSE(client->closed);
  bench.advance(20ms);
  while (!bench.source.waiting.empty()) bench.answer_all();
  CHECK(bench.kinds(*client) == std::vector(9, wire::Body::Chunk));
  bench.check_gone(*client);
}

TEST_CASE("however much one client takes, another's Pong waits for two of its batches at most") {
  Bench bench;
  bench.source.payload_bytes = 20'000;
  const auto greedy = bench.greeted();
  const auto other = bench.greeted();
  greedy->room = 0;
  for (std::uint32_t first = 1; first <= 1000; first += 100) {
    bench.send(*greedy, get_chunks(first, 100));
    bench.answer_all();
  }
  while (!bench.source.waiting.empty()) bench.answer_all();
  greedy->room = SIZE_MAX;
  greedy->changed();
  std::size_t longest = 0;
  for (int round = 0; round < 20; ++round) {
    const std::size_t before = greedy->received.size();
    other->received.clear();
    other->send(std::span<const std::byte>{ping()});
    while (other->received.empty()) bench.io.poll_one();
    longest = std::max(longest, greedy->received.size() - before);
  }
  CHECK(greedy->received.size() > 100'000);
  CHECK(longest <= 2 * (WriteBatchSize::kMax + 20'000 + 1000));
}
