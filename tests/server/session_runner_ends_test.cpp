// How connections end: who closes, shuts one side, is silent, reads nothing, or is told to go away.
#include <catch2/catch.hpp>

#include "net/websocket/stream.h"
#include "session_runner_bench.h"
#include "websocket_frames.h"

namespace talus::server::session_runner_test {

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
  CHECK(bench.kinds(*client) == std::vector{wire::Body::ViewComplete});  // TCP would answer if it were gone
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

TEST_CASE("an HTTP request on the port of game clients is answered by one line of HTTP") {
  Bench bench;
  bench.context.http_place = "the viewer is at http://HOST:4782/";
  const auto [request, answer] = GENERATE(
      table<const char*, const char*>({{"GET / HTTP/1.1\r\nHost: a\r\n\r\n", "HTTP/1.1 400 Bad Request\r\n"},
                                       {"HEAD / HTTP/1.1\r\nHost: a\r\n\r\n", "HTTP/1.1 400 Bad Request\r\n"},
                                       {"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", "HTTP/1.1 400 Bad Request\r\n"},
                                       {"\x16\x03\x01\x02 a TLS hello", ""}}));  // an Error
  const auto client = bench.connect();
  client->send(request);
  bench.io.poll();
  const std::string sent{client->text()};
  CHECK_THAT(sent, Catch::StartsWith(answer));
  const std::string line = *answer == 0 ? "" : "\r\n\r\nthe viewer is at http://HOST:4782/\n";
  CHECK_THAT(sent, Catch::EndsWith(line));
  CHECK(client->shut);
  client->end();
  bench.io.poll();
  bench.check_gone(*client);
}

TEST_CASE("a client without Hello in time gets the reason and is closed") {
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

TEST_CASE("a client that is silent after Hello gets the reason; a frame begins the time anew") {
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

TEST_CASE("a client that reads nothing while frames are sent is closed") {
  Bench bench;
  const auto client = bench.greeted();
  client->room = 10;
  bench.send(*client, ping());
  bench.advance(15s - 1ms);
  CHECK_FALSE(client->closed);
  bench.advance(1ms);
  bench.check_gone(*client);
}

TEST_CASE("a client that closes its WebSocket and reads nothing is closed after two seconds") {
  using WebSocketStream = server::websocket::WebSocketStream<LoopbackStream>;
  Bench bench;
  const auto client = std::make_shared<Loopback>(bench.io);
  const auto runner = bench.begin(WebSocketStream{LoopbackStream{client}, {}}, 1);
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
  }
  SECTION("when it is sent nothing but the answer to its Close") {
    client->room = 0;
  }
  say(8, {});
  advance(2s - 1ms);
  CHECK_FALSE(client->closed);
  advance(1ms);
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

TEST_CASE("if memory is short little is read from a client that does not read its answers") {
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

TEST_CASE("a session that is asked to leave answers pending requests, then closes") {
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

}  // namespace talus::server::session_runner_test
