// Operators see who uses most, block one, and change limits: all while the server runs.
#include <signal.h>

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <string>

#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

std::string get(std::uint16_t port, const std::string& path) {
  asio::io_context io;
  asio::ip::tcp::socket socket{io};
  socket.connect({asio::ip::address_v4::loopback(), port});
  asio::write(socket, asio::buffer("GET " + path + " HTTP/1.1\r\nHost: talus\r\nConnection: close\r\n\r\n"));
  std::string reply;
  std::error_code ended;
  asio::read(socket, asio::dynamic_buffer(reply), ended);
  return reply;
}

/// The line of a table that begins with this; asks again until there is one, for the server counts once a
/// second.
std::string await_row(std::uint16_t admin, const std::string& table, const std::string& begin) {
  for (;;) {
    const std::string page = get(admin, "/flows");
    const std::size_t from = page.find("\n" + table);
    INFO(page);
    REQUIRE(from != std::string::npos);
    const std::size_t at = page.find("\n" + begin, from);
    if (at < page.find("\n\n", from)) return page.substr(at + 1, page.find('\n', at + 1) - at - 1);
  }
}

double value_of(const std::string& text, const std::string& series) {
  const std::size_t at = text.find("\n" + series + " ");
  INFO(text);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + series.size() + 2));
}

void check_blocked(RawClient& client) {
  const ReceivedFrame said = client.expect();
  CHECK(said.as<wire::Error>().code() == wire::ErrorCode::unauthorized);
  CHECK(said.as<wire::Error>().text()->str() == "this server's operator has blocked you");
  CHECK(client.closed());
}

}  // namespace

TEST_CASE("the flow that uses most is on the operators' port, and in talusd top") {
  const ScratchDirectory scratch;
  const std::string key = scratch.write("key", "0123456789abcdef0123456789abcdef");
  ServerProcess server{{{"TALUS_ACCESS_SIGNING_KEY_FILE", key},
                        {"TALUS_RATES_SESSION_REQUESTS", "3"},
                        {"TALUS_RATES_BURST_MS", "1000"}},
                       {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  const ProgramResult token =
      run_talusd({"token", "--key-file", key, "--subject", "greedy", "--valid", "1h"});
  RawClient client{server.port()};
  REQUIRE(client.send(hello({.token = token.out.substr(0, token.out.size() - 1)})));
  (void)client.expect_kind<wire::Welcome>();
  // Three are served: one for each chunk, of a patch of its own.
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(1000, 0, 0)),
                                  chunk_request(3, at(2000, 0, 0)), chunk_request(4, at(3000, 0, 0))})));
  for (int answers = 0; answers < 4; ++answers) (void)client.expect();

  (void)await_row(admin, "GENERATOR TIME", "subject greedy");
  CHECK_THAT(await_row(admin, "REFUSALS", "subject greedy"), Catch::EndsWith("   1"));
  CHECK_THAT(get(admin, "/flows.json"), Catch::Contains("\"subject\": \"greedy\""));
  const std::string metrics = get(admin, "/metrics");
  CHECK(value_of(metrics, "talus_flow_refusals_total") == 1);
  CHECK(value_of(metrics, "talus_flows") >= 1);
  CHECK(metrics.find("greedy") == std::string::npos);

  const std::string address = "127.0.0.1:" + std::to_string(admin);
  const ProgramResult top = run_talusd({"top"}, {{"TALUS_ADMIN", address}});
  CHECK(top.status == 0);
  CHECK(top.err.empty());
  CHECK_THAT(top.out, Catch::Contains("GENERATOR TIME") && Catch::Contains("subject greedy"));
  const ProgramResult nobody = run_talusd({"top", "--admin", "127.0.0.1:1"});
  CHECK(nobody.status == 1);
  CHECK_THAT(nobody.err, Catch::StartsWith("talusd top: http://127.0.0.1:1/flows: "));
}

TEST_CASE("an address is blocked and let in again while the server runs") {
  const ScratchDirectory scratch;
  const std::string list = scratch.write("blocked", "# empty\n");
  ServerProcess server{{{"TALUS_ACCESS_BLOCKED_FILE", list}}, {"--admin", "127.0.0.1:0"}};
  const std::uint16_t admin = server.admin_port();
  RawClient inside = greeted(server.port());
  RawClient silent{server.port()};

  (void)scratch.write("blocked", "127.0.0.0/8\n");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("SIGHUP: "), Catch::Contains("1 lines of blocked flows"));
  check_blocked(inside);
  check_blocked(silent);
  for (int attempts = 0; attempts < 3; ++attempts) {
    RawClient stranger{server.port()};
    check_blocked(stranger);
  }
  const std::string metrics = get(admin, "/metrics");
  CHECK(value_of(metrics, R"(talus_connections_refused_total{reason="blocked"})") == 3);
  CHECK(value_of(metrics, R"(talus_tokens_refused_total{reason="blocked"})") == 2);

  (void)scratch.write("blocked", "192.0.2.1\nrubbish\n");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("SIGHUP: "),
             Catch::Contains(list + ": line 2: \"rubbish\" is not an address"));
  {
    RawClient stranger{server.port()};
    check_blocked(stranger);
  }
  (void)scratch.write("blocked", "192.0.2.1\n");
  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: ");
  (void)greeted(server.port());

  server.signal(SIGTERM);
  const std::string log = server.wait().out;
  const std::size_t first = log.find("line 1 of access.blocked_file blocks it");
  REQUIRE(first != std::string::npos);
  CHECK(log.find("line 1 of access.blocked_file blocks it", first + 1) == std::string::npos);
}

TEST_CASE("SIGHUP says which settings have changed, and they count") {
  const ScratchDirectory scratch;
  const std::string head = "admin = \"127.0.0.1:0\"\n[cache]\nchunk_bytes = 2000000\n";
  const std::string file = scratch.write("talusd.toml", head + "[rates]\nburst_ms = 1000\n");
  ServerProcess server{{}, {"--config", file}};
  RawClient inside = greeted(server.port());

  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: no setting has changed");
  (void)scratch.write("talusd.toml",
                      "admin = \"127.0.0.1:0\"\n[cache]\nchunk_bytes = 3000000\n"
                      "[limits]\nrequests_in_flight = 2\nconnections = 2\n"
                      "[rates]\nburst_ms = 1000\nsession_requests = 1\n");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("limits.connections"),
             Catch::EndsWith("SIGHUP: limits.connections: 2048 -> 2, for new sessions"));
  CHECK_THAT(server.await_line("limits.requests"),
             Catch::EndsWith("SIGHUP: limits.requests_in_flight: 1024 -> 2, for new sessions"));
  CHECK_THAT(server.await_line("rates."), Catch::EndsWith("SIGHUP: rates.session_requests: 2048 -> 1"));
  CHECK_THAT(
      server.await_line("cache."),
      Catch::Contains("warning") && Catch::EndsWith("SIGHUP: cache.chunk_bytes: 2000000 -> 3000000 needs a "
                                                    "restart; until then the old value counts"));

  {
    RawClient fresh{server.port()};  // the second connection, and the last
    REQUIRE(fresh.send(hello({})));
    const ReceivedFrame welcome = fresh.expect_kind<wire::Welcome>();
    const auto* limits = welcome.as<wire::Welcome>().limits();
    CHECK(limits->requests_in_flight() == 2);
    CHECK(limits->session_rates()->requests() == 1);
    RawClient third{server.port()};
    const ReceivedFrame full = third.expect();
    CHECK_THAT(full.as<wire::Error>().text()->str(), Catch::Contains("2 connections"));
  }
  // Who was there has its old limits, and the new rates. All Pings come before a token is earned back, or
  // few enough are.
  for (int i = 0; i < 12; ++i) REQUIRE(inside.send(ping(static_cast<std::uint64_t>(i))));
  int refused = 0;
  for (int i = 0; i < 12; ++i) refused += inside.expect().kind() == wire::Body::Error ? 1 : 0;
  CHECK(refused > 0);

  (void)scratch.write("talusd.toml", head + "[rates]\nsession_requests = -1\n");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("old settings"),
             Catch::Contains("error") && Catch::Contains(file + ":5: rates.session_requests: "));
  server.signal(SIGHUP);
  (void)server.await_line("old settings");
  (void)scratch.write("talusd.toml", head);
  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: limits.connections: 2 -> 2048");
  CHECK_THAT(server.await_line("rates.session_requests"), Catch::EndsWith("1 -> 2048"));
}

TEST_CASE("the first list of blocked flows is set while the server runs") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("talusd.toml", "[access]\nblocked_file = \"\"\n");
  ServerProcess server{{}, {"--config", file}};
  RawClient inside = greeted(server.port());
  const std::string list = scratch.write("blocked", "nonsense\n");
  (void)scratch.write("talusd.toml", "[access]\nblocked_file = \"" + list + "\"\n");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("old list stays"), Catch::Contains("line 1: \"nonsense\""));
  (void)scratch.write("blocked", "127.0.0.1\n");
  server.signal(SIGHUP);
  (void)server.await_line("access.blocked_file: \"\" -> \"" + list + "\"");
  (void)server.await_line("1 lines of blocked flows");
  check_blocked(inside);
  // And taken away.
  (void)scratch.write("talusd.toml", "");
  server.signal(SIGHUP);
  (void)server.await_line("access.blocked_file: \"" + list + "\" -> \"\"");
  (void)server.await_line("SIGHUP: no token keys");
  (void)greeted(server.port());
}

TEST_CASE("a subject is blocked while the server runs, and others of its address go on") {
  const ScratchDirectory scratch;
  const std::string key = scratch.write("key", "0123456789abcdef0123456789abcdef");
  const std::string list = scratch.write("blocked", "");
  ServerProcess server{{{"TALUS_ACCESS_SIGNING_KEY_FILE", key}, {"TALUS_ACCESS_BLOCKED_FILE", list}}};
  const auto enter = [&](const std::string& subject) {
    const ProgramResult token =
        run_talusd({"token", "--key-file", key, "--subject", subject, "--valid", "1h"});
    RawClient client{server.port()};
    REQUIRE(client.send(hello({.token = token.out.substr(0, token.out.size() - 1)})));
    return client;
  };
  RawClient alice = enter("alice");
  RawClient bob = enter("bob");
  (void)alice.expect_kind<wire::Welcome>();
  (void)bob.expect_kind<wire::Welcome>();
  (void)scratch.write("blocked", "subject alice\n");
  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: ");
  check_blocked(alice);
  RawClient again = enter("alice");
  check_blocked(again);
  REQUIRE(bob.send(ping(7)));
  (void)bob.expect_kind<wire::Pong>();
}
