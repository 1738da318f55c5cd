// HTTP over a stream in memory and a clock that stands still until the test moves it.
#include "net/http/connection.h"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "loopback_stream.h"
#include "net/http/connections.h"
#include "runtime/manual_clock.h"

#include <asio/executor_work_guard.hpp>

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

/// Of streams that take bytes when they are waited for, and of those that take them at once.
template <typename S>
struct Bench {
  ManualClock clock;
  asio::io_context io{1};
  asio::executor_work_guard<asio::io_context::executor_type> guard{io.get_executor()};
  http::Service service{clock, make_logger("off", "text")};
  http::Connections<S> connections{service, 2};

  Bench() {
    connections.set_handler(
        std::make_shared<http::FunctionHandler>([](const http::Request& request) -> http::Response {
          if (request.path() == "/throw") throw std::runtime_error{"no"};
          return {200, http::kPlainText, std::string{request.path()} + "\n"};
        }));
  }

  std::shared_ptr<Loopback> connect() {
    auto client = std::make_shared<Loopback>(io);
    connections.add(S{client});
    io.poll();
    return client;
  }
  void send(Loopback& client, const std::string& text) {
    client.send(text);
    io.poll();
  }
  void advance(Clock::duration by) {
    clock.advance(by);
    connections.clock_moved();
    io.poll();
  }
};

std::string get(const std::string& path, const std::string& fields = "") {
  return "GET " + path + " HTTP/1.1\r\nHost: a\r\n" + fields + "\r\n";
}

/// Statuses of all responses, and their bodies one after the other.
std::string statuses(std::string_view text) {
  std::string all;
  for (std::size_t at = text.find("HTTP/1.1 "); at != text.npos; at = text.find("HTTP/1.1 ", at + 1)) {
    all += std::string{text.substr(at + 9, 3)} + " ";
  }
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("a request is answered and the connection kept", "", LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.send(*client, get("/a"));
  CHECK_THAT(std::string{client->text()},
             Catch::StartsWith("HTTP/1.1 200 OK") && Catch::EndsWith("\r\n\r\n/a\n"));
  CHECK_FALSE(client->closed);
  bench.send(*client, get("/b"));
  CHECK(statuses(client->text()) == "200 200 ");
}

TEMPLATE_TEST_CASE("pipelined requests are answered in their order, however they are cut", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const std::string text = get("/a") + get("/b") + get("/c", "Connection: close\r\n");
  for (const std::size_t piece : {std::size_t{1}, std::size_t{11}, SIZE_MAX}) {
    const auto client = bench.connect();
    client->read_bytes = piece;
    bench.send(*client, text);
    CHECK(statuses(client->text()) == "200 200 200 ");
    const std::string said{client->text()};
    CHECK(said.find("/a\n") < said.find("/b\n"));
    CHECK(said.find("/b\n") < said.find("/c\n"));
    CHECK(client->shut);
  }
}

TEMPLATE_TEST_CASE("bytes after the last request of a connection are not answered", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.send(*client, get("/a", "Connection: close\r\n") + get("/b"));
  CHECK(statuses(client->text()) == "200 ");
}

TEMPLATE_TEST_CASE("a connection whose upgrade was refused ends with the answer", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.send(*client, get("/a", "Connection: Upgrade\r\nUpgrade: websocket\r\n") + get("/b"));
  CHECK(statuses(client->text()) == "200 ");
  CHECK(client->text().find("Connection: close") != std::string::npos);
}

TEMPLATE_TEST_CASE("HEAD gets the length of GET's body and no body", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.send(*client, "HEAD /path HTTP/1.1\r\nHost: a\r\n\r\n");
  CHECK_THAT(std::string{client->text()},
             Catch::Contains("Content-Length: 6\r\n") && Catch::EndsWith("\r\n\r\n"));
}

TEMPLATE_TEST_CASE("an invalid request gets its error, and the connection ends when the client closes", "",
                   LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.send(*client, "nonsense\r\n\r\n" + get("/a"));
  CHECK(statuses(client->text()) == "400 ");
  CHECK(client->said_end);
  CHECK(client->shut);
  CHECK_FALSE(client->closed);
  client->end();
  bench.io.poll();
  CHECK(client->closed);
}

TEMPLATE_TEST_CASE("a handler that throws is a 500, and the next request is answered", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.send(*client, get("/throw") + get("/a"));
  CHECK(statuses(client->text()) == "500 200 ");
}

TEMPLATE_TEST_CASE("a client without a whole request in time is closed, however steadily its bytes arrive",
                   "", LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  for (const char* const byte : {"G", "E", "T", " ", "/"}) {
    CHECK_FALSE(client->closed);
    bench.send(*client, byte);
    bench.advance(1s);
  }
  CHECK(client->closed);
  CHECK(client->received.empty());
}

TEMPLATE_TEST_CASE("a response begins the time for the next request anew", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  bench.advance(4s);
  bench.send(*client, get("/a"));
  bench.advance(4s);
  CHECK_FALSE(client->closed);
  bench.advance(1s);
  CHECK(client->closed);
}

TEMPLATE_TEST_CASE("a client that reads no response in time is closed", "", LoopbackStream,
                   EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  client->room = 10;
  bench.send(*client, get("/a"));
  bench.advance(4999ms);
  CHECK_FALSE(client->closed);
  bench.advance(1ms);
  CHECK(client->closed);
}

TEMPLATE_TEST_CASE("a response goes on after each short write", "", LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto client = bench.connect();
  client->write_bytes = 3;
  bench.send(*client, get("/a"));
  CHECK_THAT(std::string{client->text()}, Catch::EndsWith("\r\n\r\n/a\n"));
}

TEMPLATE_TEST_CASE("an error of the stream ends the connection", "", LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto reader = bench.connect();
  reader->read_error = asio::error::connection_reset;
  reader->changed();
  bench.io.poll();
  const auto writer = bench.connect();
  writer->write_error = asio::error::broken_pipe;
  bench.send(*writer, get("/a"));
  CHECK(writer->closed);
  reader->end();
  bench.io.poll();
  CHECK(reader->closed);
}

TEMPLATE_TEST_CASE("one connection too many takes the place of the one that was quiet longest", "",
                   LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto first = bench.connect();
  const auto second = bench.connect();
  bench.advance(1s);
  bench.send(*first, get("/a"));
  const auto third = bench.connect();
  CHECK_FALSE(first->closed);
  CHECK(second->closed);
  bench.send(*third, get("/a"));
  CHECK(statuses(third->text()) == "200 ");
}

TEMPLATE_TEST_CASE("room is made by closing the one that was quiet longest, as long as one is open", "",
                   LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto first = bench.connect();
  bench.advance(1s);
  const auto second = bench.connect();
  CHECK(bench.connections.make_room());
  CHECK(first->closed);
  CHECK_FALSE(second->closed);
  CHECK(bench.connections.make_room());
  CHECK(second->closed);
  CHECK_FALSE(bench.connections.make_room());
}

TEMPLATE_TEST_CASE("connections that have ended hold no place", "", LoopbackStream, EagerLoopbackStream) {
  Bench<TestType> bench;
  const auto first = bench.connect();
  for (int other = 0; other < 3; ++other) {
    const auto gone = bench.connect();
    gone->read_error = asio::error::connection_reset;
    gone->changed();
    bench.io.poll();
  }
  CHECK_FALSE(first->closed);
}
