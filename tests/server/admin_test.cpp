// The operators' server, whole, on its own thread.
#include "admin/admin_server.h"

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <atomic>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "admin/operators_page.h"
#include "runtime/log/logger.h"

using namespace talus::server;
using asio::ip::tcp;

namespace {

http::Request request(http::Method method, const std::string& target) {
  return {method, target, {}, true};
}

const OperatorAnswers kAnswers{[] { return "metrics"; }, [] { return true; }, [] { return Readiness{}; },
                               [] { return FlowsReport{}; }};

struct Bench {
  SystemClock clock;
  AdminServer server{clock, make_logger("off", "text")};
  std::atomic<bool> ready = true;
  tcp::endpoint address;
  asio::io_context io;

  Bench() {
    const auto listening = server.listen({"127.0.0.1", 0});
    REQUIRE(listening.has_value());
    address = {asio::ip::address_v4::loopback(),
               static_cast<std::uint16_t>(std::stoi(listening->substr(listening->rfind(':') + 1)))};
    server.start({[] { return "talus_up 1\n"; }, [] { return true; },
                  [this] {
                    return ready.load() ? Readiness{} : Readiness{false, "draining"};
                  },
                  [] { return FlowsReport{}; }});
  }
  tcp::socket connect() {
    tcp::socket socket{io};
    socket.connect(address);
    return socket;
  }
  /// All that is said until the server closes.
  std::string ask(const std::string& text) {
    tcp::socket socket = connect();
    std::error_code ended;
    asio::write(socket, asio::buffer(text), ended);
    std::string said;
    asio::read(socket, asio::dynamic_buffer(said), ended);
    return said;
  }
  std::string get(const std::string& path) {
    return ask("GET " + path + " HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
  }
};

}  // namespace

TEST_CASE("operators get metrics, health and readiness, and a list of them elsewhere") {
  const auto status = [](const std::string& target, const OperatorAnswers& answers = kAnswers) {
    return answer_operator(request(http::Method::get, target), answers).status;
  };
  CHECK(answer_operator(request(http::Method::get, "/metrics"), kAnswers).body == "metrics");
  CHECK(status("/-/healthy") == 200);
  CHECK(status("/-/ready") == 200);
  CHECK(status("/-/ready", {kAnswers.metrics, kAnswers.healthy,
                            [] {
                              return Readiness{false, "draining"};
                            },
                            kAnswers.flows}) == 503);
  CHECK(status("/-/healthy", {kAnswers.metrics, [] { return false; }, kAnswers.ready, kAnswers.flows}) ==
        503);
  CHECK(status("/metrics?from=me") == 200);
  CHECK(status("/metrics/..") == 404);
}

TEST_CASE("other methods than GET and HEAD are a 405 that says which are allowed") {
  const http::Response response = answer_operator(request(http::Method::other, "/metrics"), kAnswers);
  CHECK(response.status == 405);
  REQUIRE(response.fields.size() == 1);
  CHECK(response.fields.front().name == "Allow");
  CHECK(response.fields.front().value == "GET, HEAD");
}

TEST_CASE("the operators' server answers over its socket") {
  Bench bench;
  CHECK_THAT(bench.get("/metrics"), Catch::StartsWith("HTTP/1.1 200 ") && Catch::EndsWith("talus_up 1\n"));
  CHECK_THAT(bench.get("/-/ready"), Catch::StartsWith("HTTP/1.1 200 "));
  bench.ready = false;
  CHECK_THAT(bench.get("/-/ready"), Catch::StartsWith("HTTP/1.1 503 "));
  CHECK_THAT(bench.get("/" + std::string(100'000, 'a')), Catch::StartsWith("HTTP/1.1 414 "));
}

TEST_CASE("HEAD gets the head of GET's answer, and no body") {
  Bench bench;
  for (const char* const path : {"/metrics", "/-/healthy", "/-/ready", "/nowhere"}) {
    const auto whole = bench.get(path);
    const auto head =
        bench.ask("HEAD " + std::string{path} + " HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
    const auto length_of = [](const std::string& answer) {
      const std::size_t at = answer.find("Content-Length: ");
      REQUIRE(at != std::string::npos);
      return answer.substr(at, answer.find("\r\n", at) - at);
    };
    CAPTURE(path);
    CHECK(length_of(head) == length_of(whole));
    CHECK_THAT(head, Catch::EndsWith("\r\n\r\n"));
    CHECK(head.substr(0, 12) == whole.substr(0, 12));
  }
}

TEST_CASE("the next connection is answered after any number of resets or open connections") {
  Bench bench;
  std::vector<tcp::socket> held;
  for (std::size_t i = 0; i < 3 * AdminServer::kMaxConnections; ++i) {
    tcp::socket gone = bench.connect();
    gone.set_option(asio::socket_base::linger{true, 0});
    gone.close();
    held.push_back(bench.connect());
    asio::write(held.back(), asio::buffer(std::string{"GET /-/hea"}));
  }
  CHECK_THAT(bench.get("/-/healthy"), Catch::StartsWith("HTTP/1.1 200 "));
}
