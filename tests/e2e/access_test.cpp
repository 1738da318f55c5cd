// Who may come in, and what the log says of it.
#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

/// A token as an operator makes it.
std::string made(const std::string& key_file, const std::string& subject, const std::string& rights) {
  const ProgramResult ended = run_talusd(
      {"token", "--key-file", key_file, "--subject", subject, "--rights", rights, "--valid", "1h"});
  REQUIRE(ended.status == 0);
  REQUIRE(ended.err.empty());
  REQUIRE(ended.out.ends_with('\n'));
  return ended.out.substr(0, ended.out.size() - 1);
}

/// What the server says first to a client with this token, which it then keeps or not.
ReceivedFrame answer_to(RawClient& client, const std::string& token, const std::string& name = "client") {
  REQUIRE(client.send(hello({.client = name, .token = token})));
  return client.expect();
}

}  // namespace

TEST_CASE("the shared secret opens, and no other word does") {
  const ScratchDirectory scratch;
  const ServerProcess server{{{"TALUS_ACCESS_SECRET_FILE", scratch.write("secret", "0123456789abcdef\n")}}};
  RawClient friendly{server.port()};
  CHECK(answer_to(friendly, "0123456789abcdef").kind() == wire::Body::Welcome);
  for (const std::string& token : {std::string{}, std::string{"0123456789abcdeF"}, std::string(4096, 'x')}) {
    RawClient stranger{server.port()};
    const ReceivedFrame received = answer_to(stranger, token);
    CHECK(received.as<wire::Error>().code() == wire::ErrorCode::unauthorized);
    CHECK(stranger.closed());
  }
}

TEST_CASE("a token that talusd makes gives the rights that it names") {
  const ScratchDirectory scratch;
  const std::string key = scratch.write("key", "0123456789abcdef0123456789abcdef");
  const ServerProcess server{{{"TALUS_ACCESS_SIGNING_KEY_FILE", key}}};
  for (const std::string rights : {"read", "read,edit"}) {
    RawClient client{server.port()};
    CHECK(answer_to(client, made(key, "alice", rights)).kind() == wire::Body::Welcome);
    REQUIRE(client.send(edit(1)));
    const ReceivedFrame refused = client.expect();
    CHECK(refused.as<wire::Error>().code() ==
          (rights == "read" ? wire::ErrorCode::forbidden : wire::ErrorCode::unsupported));
  }
}

TEST_CASE("after SIGHUP new keys let in, old ones no more, and who is in stays") {
  const ScratchDirectory scratch;
  const std::string key = scratch.write("key", "0123456789abcdef0123456789abcdef");
  ServerProcess server{{{"TALUS_ACCESS_SIGNING_KEY_FILE", key}}};
  const std::string old = made(key, "alice", "read");
  RawClient before{server.port()};
  REQUIRE(answer_to(before, old).kind() == wire::Body::Welcome);

  scratch.write("key", "fedcba9876543210fedcba9876543210");
  server.signal(SIGHUP);
  (void)server.await_line("SIGHUP: the tokens' keys were read again");
  RawClient stranger{server.port()};
  CHECK(answer_to(stranger, old).as<wire::Error>().code() == wire::ErrorCode::unauthorized);
  const std::string fresh = made(key, "bob", "read");
  RawClient after{server.port()};
  CHECK(answer_to(after, fresh).kind() == wire::Body::Welcome);

  scratch.write("key", "short");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("SIGHUP: "), Catch::Contains("error") && Catch::Contains("old keys stay"));
  RawClient still{server.port()};
  CHECK(answer_to(still, fresh).kind() == wire::Body::Welcome);
  REQUIRE(before.send(ping(7)));
  CHECK(before.expect().kind() == wire::Body::Pong);
}

TEST_CASE("a bad key file is one line, also where the configuration is only checked") {
  const ScratchDirectory scratch;
  const Settings settings{{"TALUS_ACCESS_SECRET_FILE", scratch.write("secret", "short")}};
  for (const std::vector<std::string>& flags : {std::vector<std::string>{}, {"--check-config"}}) {
    const ProgramResult ended = run_talusd(flags, settings);
    CHECK(ended.status == 1);
    CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
    CHECK_THAT(ended.err, Catch::StartsWith("talusd: TALUS_ACCESS_SECRET_FILE: access.secret_file "));
  }
}

TEST_CASE("no byte of a stranger's changes the log", "[tcp]") {
  const std::string format = GENERATE(as<std::string>{}, "text", "json");
  const ScratchDirectory scratch;
  const std::string key = scratch.write("key", "0123456789abcdef0123456789abcdef");
  ServerProcess server{
      {{"TALUS_ACCESS_SIGNING_KEY_FILE", key}, {"TALUS_LOG_FORMAT", format}, {"TALUS_LOG_LEVEL", "trace"}}};
  const std::string hostile =
      "x\n2026-01-01 error forged\r\x1b[2J\x1b]0;t\x07 \xff\xfe\xc3\x28 \xe2\x80\xae \"} \\";
  // As a subject it must be UTF-8, or no token could be made.
  const std::string subject = "y\nforged\r\x1b[2J\x07 \xe2\x80\xae \"} \\";
  {
    RawClient named{server.port()};
    CHECK(answer_to(named, made(key, subject, "read"), hostile).kind() == wire::Body::Welcome);
    REQUIRE(named.send(hello({.client = hostile})));
    (void)named.expect_kind<wire::Error>();
    CHECK(named.closed());
    RawClient stranger{server.port()};
    CHECK(answer_to(stranger, hostile, hostile).kind() == wire::Body::Error);
    CHECK(stranger.closed());
    RawClient noise{server.port()};
    REQUIRE(noise.send(std::as_bytes(std::span{hostile})));
    (void)noise.receive();
  }
  server.signal(SIGTERM);
  const std::string log = server.wait().out;
  INFO(log);
  CHECK(log.find("\\x0a2026") != std::string::npos);
  CHECK(log.find("forged") != std::string::npos);
  for (const char c : log) CHECK((c == '\n' || (c >= ' ' && c <= '~')));
  std::size_t from = 0;
  for (std::size_t end = 0; (end = log.find('\n', from)) != std::string::npos; from = end + 1) {
    const std::string line = log.substr(from, end - from);
    CHECK_FALSE((line.starts_with("2026-01-01") || line.starts_with("forged")));
    if (format == "json" && line.find("listening on ") != 0) {
      CHECK((line.front() == '{' && line.ends_with("\"}")));
    }
  }
}
