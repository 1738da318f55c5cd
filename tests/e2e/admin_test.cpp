// What operators get over HTTP.
#include <signal.h>

#include <asio/buffer.hpp>
#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "messages.h"
#include "raw_client.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;
using asio::ip::tcp;

namespace {

/// All that the server says before it closes the connection, which it may do before it has read everything.
std::string ask(std::uint16_t port, const std::string& request) {
  asio::io_context io;
  tcp::socket socket{io};
  socket.connect({asio::ip::address_v4::loopback(), port});
  std::error_code ended;
  asio::write(socket, asio::buffer(request), ended);
  std::string reply;
  asio::read(socket, asio::dynamic_buffer(reply), ended);
  return reply;
}

std::string get(std::uint16_t port, const std::string& path) {
  return ask(port, "GET " + path + " HTTP/1.1\r\nHost: talus\r\nConnection: close\r\n\r\n");
}

double value_of(const std::string& text, const std::string& series) {
  const std::size_t at = text.find("\n" + series + " ");
  INFO(text);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + series.size() + 2));
}

}  // namespace

TEST_CASE("metrics count what a client was sent") {
  ServerProcess server{{}, {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 1000, 0))})));
  std::size_t bytes = client.expect_kind<wire::Chunk>().bytes();
  bytes += client.expect_kind<wire::Chunk>().bytes();

  const std::string text = get(admin, "/metrics");
  CHECK(text.starts_with("HTTP/1.1 200 "));
  CHECK(value_of(text, "talus_chunks_sent_total") == 2);
  CHECK(value_of(text, "talus_chunk_bytes_sent_total") == static_cast<double>(bytes));
  CHECK(value_of(text, R"(talus_sessions{state="greeted"})") == 1);
  CHECK(value_of(text, "talus_uniform_answers_total") >= 1);
  CHECK(value_of(text, "talus_chunks_generated_total") == 1);
  CHECK(value_of(text, "process_cpu_seconds_total") > 0);
}

TEST_CASE("a server is healthy and ready until it drains") {
  ServerProcess server{{{"TALUS_SHUTDOWN_DRAIN_MS", "3600000"}, kClassicWorld}, {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  CHECK(get(admin, "/-/healthy").starts_with("HTTP/1.1 200 "));
  CHECK(get(admin, "/-/ready").starts_with("HTTP/1.1 200 "));
  RawClient client = greeted(server.port(), 1);
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
  server.signal(SIGTERM);
  (void)client.expect_kind<wire::GoAway>();
  CHECK(get(admin, "/-/healthy").starts_with("HTTP/1.1 200 "));
  CHECK(get(admin, "/-/ready").starts_with("HTTP/1.1 503 "));
}

TEST_CASE("a server that has more than its share sends sessions elsewhere, as its balancer's checks say") {
  ServerProcess server{
      {{"TALUS_BALANCE_SESSION_MS", "0"}, {"TALUS_BALANCE_ABOVE_PERCENT", "0"}, kClassicWorld},
      {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  RawClient first = greeted(server.port());
  RawClient second = greeted(server.port());
  const std::string check = "GET /-/ready HTTP/1.1\r\nHost: talus\r\nConnection: close\r\n";
  const std::string state = "X-Haproxy-Server-State: UP; name=talus/a; weight=1/2; scur=2/2; qcur=0\r\n\r\n";
  CHECK(ask(admin, check + state).starts_with("HTTP/1.1 200 "));
  const ReceivedFrame away = first.expect_kind<wire::GoAway>();
  CHECK(away.as<wire::GoAway>().retry_after_ms() == 0);
  CHECK(first.closed());
  first.close();
  CHECK(ask(admin, check + "\r\n").starts_with("HTTP/1.1 200 "));
  REQUIRE(second.send(get_chunks({chunk_request(1, at(0, 0, 0))})));
  (void)second.expect_kind<wire::Chunk>();
  CHECK(value_of(get(admin, "/metrics"), "talus_sessions_sent_elsewhere_total") == 1);
}

TEST_CASE("an invalid request gets a 4xx, and harms nothing") {
  ServerProcess server{{}, {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  const std::string metrics = "GET /metrics HTTP/1.1\r\nHost: a\r\n";
  const std::string post = "POST /metrics HTTP/1.1\r\nHost: a\r\nConnection: close\r\n";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"404", "GET /metrics/.. HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n"},
      {"405", "DELETE /metrics HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n"},
      {"405", post + "\r\n"},
      {"414", "GET /" + std::string(100'000, 'a') + " HTTP/1.1\r\nHost: a\r\n\r\n"},
      {"431", metrics + "X: " + std::string(100'000, 'a') + "\r\n\r\n"},
      {"400", "FETCH /metrics HTTP/1.1\r\nHost: a\r\n\r\n"},
      {"400", "GET /metrics HTTP/3.0\r\nHost: a\r\n\r\n"},
      {"400", "GET /metrics\r\n\r\n"},
      {"400", "GET /metrics HTTP/1.1\r\n\r\n"},
      {"400", metrics + "no colon\r\n\r\n"},
      {"400", metrics + "X: \x01\r\n\r\n"},
      {"400", metrics + "X : y\r\n\r\n"},
      {"400", metrics + "X: y\n\r\n"},
      {"400", "GET /metrics HTTP/1.1\nHost: a\n\n"},
      {"400", "\x16\x03\x01\x02 this is not HTTP"},
      {"400", std::string(5000, '\xFF')},
      {"413", post + "Content-Length: 3\r\n\r\nabc"},
      {"413", post + "Content-Length: 99999999\r\n\r\nabc"},
      {"413", post + "Transfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n"},
      {"417", post + "Content-Length: 3\r\nExpect: 100-continue\r\n\r\n"}};
  for (const auto& [status, request] : wrong) {
    CAPTURE(request.substr(0, 100));
    CHECK_THAT(ask(admin, request), Catch::StartsWith("HTTP/1.1 " + status + " "));
  }
  CHECK(get(admin, "/-/healthy").starts_with("HTTP/1.1 200 "));
}

TEST_CASE("an address for operators that is taken is one line") {
  const ServerProcess server;
  const std::string address = "127.0.0.1:" + std::to_string(server.port());
  const ProgramResult ended = run_talusd({"--listen", "127.0.0.1:0", "--admin", address});
  CHECK(ended.status == 1);
  CHECK_THAT(ended.err, Catch::StartsWith("talusd: admin " + address + ": "));
}
