// Where a stream's leader is looked for: servers that do not answer.
#include <array>
#include <chrono>
#include <list>
#include <memory>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <asio.hpp>
#include <catch2/catch.hpp>

#include "cluster/jetstream/leader_scout.h"
#include "cluster/jetstream/stream_info.h"
#include "log_of_tests.h"
#include "scripted_stream.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;

namespace {

/// Greets as a NATS server that wants TLS, and says nothing more to who then begins with it.
class NeverShakesHands {
 public:
  [[nodiscard]] std::string url() const {
    return fmt::format("nats://127.0.0.1:{}", acceptor_.local_endpoint().port());
  }
  NeverShakesHands() : thread_{[this] { serve(); }} {}
  ~NeverShakesHands() {
    asio::post(context_, [this] { sockets_.clear(), context_.stop(); });
    thread_.join();
  }

 private:
  void serve() {
    accept();
    context_.run();
  }
  void accept() {
    acceptor_.async_accept([this](const asio::error_code& error, asio::ip::tcp::socket socket) {
      if (error) return;
      static const std::string kGreeting =
          R"(INFO {"server_id":"x","version":"2.9.10","max_payload":1048576,"headers":true,"tls_required":true})"
          "\r\n";
      asio::write(sockets_.emplace_back(std::move(socket)), asio::buffer(kGreeting));
      accept();
    });
  }

  asio::io_context context_;
  asio::ip::tcp::acceptor acceptor_{context_, {asio::ip::address_v4::loopback(), 0}};
  std::list<asio::ip::tcp::socket> sockets_;
  std::thread thread_;
};

ServerUrls url_of(const std::string& url) {
  constexpr std::array<std::string_view, 1> kSchemes{"nats"};
  return *ServerUrls::parse(url, kSchemes);
}

}  // namespace

TEST_CASE("a server that never ends its handshake delays the search, and no caller") {
  auto silent = std::make_unique<NeverShakesHands>();
  Credentials credentials;
  credentials.tls = true;
  LeaderScout scout{url_of(silent->url()), std::make_shared<const Credentials>(std::move(credentials)),
                    test_names()};
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < 10; ++i) CHECK_FALSE(scout.probe(100ms, {}));
  CHECK(std::chrono::steady_clock::now() - began < 30s);
  CHECK(scout.is_probing());
  silent.reset();  // else libnats would wait for it while the program ends
  const auto until = from_now(kPatience);
  while (scout.is_probing()) {
    (void)scout.probe(100ms, {});
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

TEST_CASE("a leader is found where it answers, and leads the stream that is wanted") {
  ScriptedStream stream{test_names()};
  stream.set({true, {{1, "message"}}, {}});
  const auto found = [&](LeaderScout::Requirement wanted) {
    LeaderScout scout{url_of(stream.url()), std::make_shared<const Credentials>(), stream.names()};
    std::optional<ServerUrls> server;
    const auto until = from_now(kPatience);
    do {
      server = scout.probe(500ms, wanted);
    } while (scout.is_probing() && std::chrono::steady_clock::now() < until);
    return server;
  };
  const auto created = nanoseconds_of("2026-01-01T00:00:00Z").value();
  const auto server = found({created, 1});
  REQUIRE(server);
  CHECK(server->text() == stream.url());
  CHECK(found({}));
  CHECK_FALSE(found({created - 1, 1}));
  CHECK_FALSE(found({created, 2}));
  stream.set({false, {}, {}});
  CHECK_FALSE(found({}));
}
