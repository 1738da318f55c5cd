// Sessions whose client is gone, whatever they wait for: the work is cancelled, memory and place are free.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "net/websocket/stream.h"
#include "session_runner_bench.h"
#include "waiting_taker.h"
#include "websocket_frames.h"

namespace talus::server::session_runner_test {
namespace {

using WebSocket = server::websocket::WebSocketStream<LoopbackStream>;

constexpr std::array kStates{"Hello",   "nothing",       "chunks",       "heights", "credit",   "memory",
                             "an edit", "a slow reader", "a full queue", "a View",  "the drain"};

protocol::Frame get_heights(std::uint32_t id) {
  return protocol::make_frame([&](auto& builder) {
    const std::vector columns(1000, wire::ColumnPos{5, 5});
    return wire::CreateGetHeights(builder, id, builder.CreateVectorOfStructs(columns));
  });
}

Access who_may_edit() {
  Access access;
  access.without_token = "read,edit";
  return access;
}

/// A client by TCP or WebSocket, and a session that waits for something.
struct Waiting {
  WaitingTaker taker;
  Bench bench{256U << 20, who_may_edit(), &taker};
  const std::shared_ptr<Loopback> client = std::make_shared<Loopback>(bench.io);
  const bool by_websocket;

  /// `much`: more input waits behind a pause than is read.
  Waiting(std::string_view state, bool websocket, bool much) : by_websocket{websocket} {
    bench.source.rows = {0, -1, MaterialId{1}};
    bench.context.limits.queued_bytes = 20'000;
    bench.runners.push_back(by_websocket ? bench.begin(WebSocket{LoopbackStream{client}, {}}, 1)
                                         : bench.begin(LoopbackStream{client}, 1));
    if (state == "Hello") return;
    say(protocol::make_frame([&](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
      return wire::CreateHello(builder, protocol::kOldestProtocol, protocol::kProtocolVersion, codecs, 0, 0,
                               state == "credit" ? 1 : 0);
    }));
    REQUIRE(bench.metrics.greeted.now() == 1);
    if (state == "chunks") say(get_chunks(1, 100));
    if (state == "heights") {
      for (std::uint32_t id = 1; id <= (much ? 20 : 1); ++id) say(get_heights(id));
    }
    if (state == "credit") {
      say(get_chunks(1, 100));
      bench.answer_all();
    }
    if (state == "memory") {
      bench.memory.set(MemoryUse::jobs, 256U << 20);
      client->room = 0;
      say_pings(much ? 2000 : 280);
    }
    if (state == "an edit") wait_for_edits(much ? 32 : 3);
    if (state == "a slow reader") {
      client->room = 100;
      say(get_chunks(1, 100));
      bench.answer_all();
    }
    if (state == "a full queue") {
      client->room = 0;
      say_pings(much ? 2000 : 280);
    }
    if (state == "a View") {
      for (std::int64_t x = 0; x < 3; ++x) say(view_at(100 * x));
    }
    if (state == "the drain") {
      say(get_chunks(1, 100));
      bench.registry.tell_all_to_go("the end", 5s);
      bench.io.poll();
    }
  }

  void say(const protocol::Frame& frame) {
    if (!by_websocket) return bench.send(*client, frame);
    std::vector<std::byte> wrapped;
    append_client_frame(wrapped, 2, frame, 5);
    client->send(wrapped);
    bench.io.poll();
  }
  void say_pings(int count) {
    for (int i = 0; i < count; ++i) say(ping());
  }
  void wait_for_edits(std::uint32_t count) {
    say(protocol::make_frame([](auto& builder) { return wire::CreateAttach(builder); }));
    REQUIRE(taker.mailbox);
    taker.mailbox->put(AttachAnswer{EditorSession{{1, 2}, 3, 0, false, 9}});
    taker.mailbox->wake();
    bench.io.poll();
    for (std::uint32_t id = 1; id <= count; ++id) say(guarded_edit(id, 100));
    REQUIRE_FALSE(taker.edits.empty());
  }

  void answer_all() {
    bench.answer_all();
    while (!bench.source.waiting_heights.empty()) {
      const auto [ticket, mailbox] = *bench.source.waiting_heights.begin();
      bench.source.answer_heights(ticket);
      mailbox->wake();
      bench.io.poll();
    }
    for (std::size_t next = 0; next < taker.edits.size(); ++next) {
      const auto id = static_cast<std::uint32_t>(next + 1);
      taker.mailbox->put(EditAnswer{id, edits::EditResult{id, 1, 1, {}}});
      taker.mailbox->wake();
      bench.io.poll();
    }
  }
  void reset() {
    client->reset = true;
    client->read_error = client->write_error = asio::error::connection_reset;
    client->changed();
    bench.io.poll();
  }
  void check_gone() {
    bench.check_gone(*client);
    CHECK(bench.source.waiting.empty());
    CHECK(bench.source.waiting_heights.empty());
    CHECK(bench.source.watcher == nullptr);
    bench.runners.clear();  // no operation keeps it alive
    CHECK(bench.memory.used(MemoryUse::sessions) == 0);
  }
};

}  // namespace

TEST_CASE("a client that resets its connection is gone within a second, whatever its session waits for") {
  const auto* const state = GENERATE(from_range(kStates));
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(state, websocket, much);
  Waiting session{state, websocket, much};
  session.reset();
  session.bench.advance(500ms);
  session.check_gone();
}

TEST_CASE("a client that closes its connection is gone within a second, whatever its session waits for") {
  const auto* const state = GENERATE(from_range(kStates));
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(state, websocket, much);
  Waiting session{state, websocket, much};
  session.client->room = SIZE_MAX;  // with bytes that it did not read, closing is a reset
  session.client->gone = session.client->hung_up = true;
  session.client->end();
  for (int i = 0; i < 20; ++i) session.bench.advance(50ms);
  session.check_gone();
}

TEST_CASE("a client that shuts its sending side and reads nothing is given up as a slow reader") {
  const auto* const state = GENERATE(from_range(kStates));
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(state, websocket, much);
  Waiting session{state, websocket, much};
  session.client->room = 0;
  session.client->hung_up = true;
  session.client->end();
  for (int i = 0; i < 20; ++i) session.bench.advance(50ms);
  session.bench.advance(15s);
  session.bench.advance(2s);
  session.check_gone();
}

TEST_CASE("a client that shuts its sending side and reads is served, however long it takes") {
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(websocket, much);
  Waiting session{"an edit", websocket, much};
  session.client->hung_up = true;
  session.client->end();
  for (int i = 0; i < 1000; ++i) session.bench.advance(400ms);
  CHECK_FALSE(session.client->closed);
  session.answer_all();
  CHECK((session.client->said_end || session.client->closed));
}

TEST_CASE("a client that closes its WebSocket is gone, whatever its session waits for") {
  const auto* const state = GENERATE(from_range(kStates));
  CAPTURE(state);
  Waiting session{state, true, false};
  std::vector<std::byte> close;
  append_client_frame(close, 8, {}, 5);
  session.client->send(close);
  session.bench.io.poll();
  CHECK(session.bench.source.waiting.empty());
  CHECK(session.bench.source.waiting_heights.empty());
  session.bench.advance(2s);  // the time in which a client that reads nothing may take the answer
  session.check_gone();
}

TEST_CASE("a client that is silent is given up in time, whatever its session waits for") {
  const auto* const state = GENERATE(from_range(kStates));
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(state, websocket, much);
  Waiting session{state, websocket, much};
  session.bench.advance(20s);  // the time-outs of Hello and of writes, and the next View
  session.answer_all();        // a pause ends with the answers
  session.bench.advance(60s);
  session.bench.advance(2s);  // in which it may take the Error
  session.check_gone();
}

TEST_CASE("a client that is silent is given up in time, though what its session waits for does not come") {
  const auto* const state = GENERATE(from_range(kStates));
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(state, websocket, much);
  Waiting session{state, websocket, much};
  session.bench.advance(20s);
  session.bench.advance(60s);
  session.bench.advance(2s);
  session.check_gone();
}

TEST_CASE("a client that says something is not silent, though what it says is not read before its answers") {
  const bool websocket = GENERATE(false, true);
  const bool much = GENERATE(false, true);
  CAPTURE(websocket, much);
  Waiting session{"an edit", websocket, much};
  for (int i = 0; i < 20; ++i) {
    session.bench.advance(40s);
    session.say(ping());
  }
  CHECK_FALSE(session.client->closed);
  session.answer_all();
  CHECK_FALSE(session.client->closed);
}

}  // namespace talus::server::session_runner_test
