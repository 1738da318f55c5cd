// What a session does between its socket, its rates and the source of chunks.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "scratch_directory.h"
#include "session_runner_bench.h"
#include "waiting_taker.h"

namespace talus::server::session_runner_test {

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

TEST_CASE("a chunk that an update needs is requested at once, even if the stream takes bytes at once") {
  Bench bench;
  const auto client = std::make_shared<Loopback>(bench.io);
  const auto runner = bench.begin(EagerLoopbackStream{client}, 1);
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

TEST_CASE("an exception of a session's work ends only that session") {
  struct ThrowingSource final : ChunkSource {
    EncodedChunkPtr find(ChunkKey, Version) override { throw std::bad_alloc{}; }
    EncodedChunkPtr newer(ChunkKey, std::uint64_t) override { return nullptr; }
    MixedRows column(ChunkKey, Version) override { return {}; }
    int columns_together() const override { return 1; }
    std::size_t submit(const MailboxPtr&, std::span<const ChunkKey> keys, Urgency, Version) override {
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
  const auto runner = Runner::make(session_stream(LoopbackStream{client}), {9, "test", bench.clock.now()},
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

TEST_CASE("Views of one session are applied twenty milliseconds apart at least") {
  Bench bench;
  bench.source.rows = {0, -1, MaterialId{1}};
  const auto client = bench.greeted();
  const auto send_view = [&](std::int64_t x) { bench.send(*client, view_at(x)); };
  send_view(0);
  CHECK_FALSE(bench.frames(*client).empty());
  send_view(100);
  CHECK(bench.frames(*client).empty());
  bench.advance(20ms);
  CHECK_FALSE(bench.frames(*client).empty());
}

TEST_CASE("a client whose View waits to be applied is read, until it sends another") {
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

TEST_CASE("a chunk that stays in many Views at once is not sent twice") {
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

TEST_CASE("a Pong waits for two batches of another client at most") {
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

TEST_CASE("a client's waiting edits are read until they take a quarter of the queue's bytes") {
  WaitingTaker taker;
  Access who_may;
  who_may.without_token = "read,edit";
  Bench bench{0, who_may, &taker};
  const auto client = bench.connect();
  bench.send(*client, hello());
  bench.send(*client, protocol::make_frame([](auto& builder) { return wire::CreateAttach(builder); }));
  REQUIRE(taker.mailbox);
  const auto answer = [&](Mail mail) {
    taker.mailbox->put(std::move(mail));
    taker.mailbox->wake();
    bench.io.poll();
  };
  answer(AttachAnswer{EditorSession{{1, 2}, 3, 0, false, 9}});
  constexpr std::uint32_t kEdits = 32;
  for (std::uint32_t id = 1; id <= kEdits; ++id) bench.send(*client, guarded_edit(id, 1500));
  const std::size_t taken = taker.edits.size();
  const std::size_t quarter = bench.context.limits.queued_bytes / 4;
  CHECK(taken >= 2);
  CHECK(taken < kEdits / 2);
  bench.send(*client, ping());
  for (const wire::Body kind : bench.kinds(*client)) CHECK(kind != wire::Body::Pong);
  CHECK(bench.memory.used(MemoryUse::sessions) < 2 * quarter);
  for (std::uint32_t id = 1; id <= kEdits; ++id) {
    REQUIRE(taker.edits.size() >= id);
    answer(EditAnswer{id, edits::EditResult{id, 1, 1, {}}});
  }
  const auto said = bench.kinds(*client);
  CHECK(std::count(said.begin(), said.end(), wire::Body::EditResult) == kEdits);
  CHECK(std::count(said.begin(), said.end(), wire::Body::Pong) == 1);
}

}  // namespace talus::server::session_runner_test
