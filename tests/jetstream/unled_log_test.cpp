// A log of which no leader answers: what replicas give, and how the leader confirms it.
#include <string>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "log_of_tests.h"
#include "scripted_stream.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;

namespace {

ScriptedStream::Script::Messages messages(std::uint64_t last, const std::string& text = "message") {
  ScriptedStream::Script::Messages all;
  for (std::uint64_t i = 1; i <= last; ++i) all[i] = fmt::format("{} {}", text, i);
  return all;
}

/// Those up to `last`, which come some time.
void read_up_to(JetStreamLog& log, std::uint64_t after, std::uint64_t last) {
  const auto until = from_now(kPatience);
  while (after < last) {
    const auto message = log.next(after, from_now(100ms));
    REQUIRE(std::chrono::steady_clock::now() < until);
    if (!message || !*message) continue;
    REQUIRE((*message)->sequence == ++after);
    CHECK((*message)->time_ms);  // nobody need ask for it
  }
}

/// What it says once it is not that something may come yet.
tl::expected<StreamState, StreamFailure> settled_state(JetStreamLog& log) {
  const auto until = from_now(kPatience);
  for (;;) {
    auto state = log.state();
    if (state || state.error().kind != Kind::unavailable) return state;
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

/// Until the leader, which is silent, is known to be.
void await_silence(JetStreamLog& log) {
  for (int i = 0; i < 4; ++i) CHECK_FALSE(log.state());
}

}  // namespace

TEST_CASE("without a leader a replica's messages are read, and count once the leader has confirmed them") {
  NatsServers servers;
  const StreamNames names = test_names();
  make_stream(servers, names, 3);
  const auto writer = open_log(servers.url_list(), names);
  const auto log = open_log(servers.url(0), names);
  const auto until = from_now(kPatience);
  while (!log->state()) REQUIRE(std::chrono::steady_clock::now() < until);
  constexpr std::uint64_t kMessages = 300;
  for (std::uint64_t i = 1; i <= kMessages; ++i) publish(*writer, std::to_string(i));
  servers.await_replicas(names.stream);
  servers.kill(1);
  servers.kill(2);
  while (log->state()) REQUIRE(std::chrono::steady_clock::now() < until);  // a leader may lead on for seconds
  for (std::uint64_t after = 0; after < kMessages;) {
    (void)log->state();
    for (auto message = log->next(after, from_now(50ms)); message && *message;
         message = log->next(after, from_now(50ms))) {
      CHECK(text_of((*message)->bytes) == std::to_string(++after));
    }
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
  CHECK_FALSE(log->state());
  servers.start(1);
  servers.start(2);
  while (!log->state()) REQUIRE(std::chrono::steady_clock::now() < until);
  CHECK(publish(*log, "b") > kMessages);
}

TEST_CASE("a replica's messages are compared with the leader's before anything else counts") {
  ScriptedStream stream{test_names()};
  stream.set({true, messages(2), messages(2)});
  const auto log = open_log(stream.url(), stream.names());
  REQUIRE(log->state());
  CHECK(read(*log, 0) == "message 1");
  CHECK(read(*log, 1) == "message 2");
  CHECK(stream.asked_of_replicas() == 0);
  auto of_replicas = messages(200);
  const std::string differs = GENERATE("nothing", "a message", "their time");
  if (differs == "a message") of_replicas[120] = "message 119";  // of one replica, the others are sound
  ScriptedStream::Script unled{false, {}, of_replicas};
  if (differs == "their time") unled.replicas_time = "2032-01-01T00:00:00Z";
  stream.set(unled);
  await_silence(*log);
  read_up_to(*log, 2, 200);
  const auto unconfirmed = log->publish(bytes_of("a"));
  REQUIRE_FALSE(unconfirmed);
  CHECK_THAT(unconfirmed.error().reason, Catch::Contains("has not confirmed"));

  SECTION("less: it may have been deposed, and is waited for") {
    stream.set({true, messages(119), of_replicas});
    const auto state = log->state();
    REQUIRE_FALSE(state);
    if (differs != "their time") {  // else its first answer may have told already
      CHECK(state.error().kind == Kind::unavailable);
      CHECK_THAT(state.error().reason, Catch::Contains("the log's leader not yet"));
    }
  }
  SECTION("all") {}
  stream.set({true, messages(210), of_replicas});
  const auto state = settled_state(*log);
  if (differs != "nothing") {
    REQUIRE_FALSE(state);
    CHECK(state.error().kind == Kind::false_message);
    CHECK_THAT(state.error().reason, Catch::Contains("that was applied is not the stream's") &&
                                         Catch::Contains("talusd cluster check"));
    CHECK(read_failure(*log, 200).kind == Kind::false_message);
    CHECK(publish_failure(*log).kind == Kind::false_message);
  } else {
    REQUIRE(state);
    CHECK(state->last == 210);
    const std::size_t asked = stream.asked_of_replicas();
    read_up_to(*log, 200, 210);
    CHECK(stream.asked_of_replicas() == asked);
  }
}

TEST_CASE("without the permission to ask replicas the leader is waited for") {
  ScriptedStream stream{test_names(), {.more = talusd_permissions()}};
  stream.set({true, messages(1), messages(1)});
  const auto log = open_log(stream.url(), stream.names(), as_talusd());
  REQUIRE(log->state());
  CHECK(read(*log, 0) == "message 1");
  stream.set({false, {}, messages(5)});
  await_silence(*log);
  // Not for a person: it is but a help.
  const auto until = from_now(1s);
  while (std::chrono::steady_clock::now() < until) {
    const auto message = log->next(1, from_now(100ms));
    CHECK((message ? !*message : message.error().kind == Kind::unavailable));
  }
  stream.set({true, messages(5), messages(5)});
  REQUIRE(log->state());
  read_up_to(*log, 1, 5);
}

TEST_CASE("a message that the leader lost is named, while the stream goes on behind it") {
  ScriptedStream stream{test_names()};
  auto all = messages(4);
  all.erase(3);
  stream.set({.leader = all});
  const auto log = open_log(stream.url(), stream.names());
  read_up_to(*log, 0, 2);
  const auto until = from_now(kPatience);
  for (;;) {
    (void)log->state();
    const auto message = log->next(2, from_now(100ms));
    REQUIRE(std::chrono::steady_clock::now() < until);
    if (message) {
      REQUIRE_FALSE(*message);
      continue;
    }
    if (message.error().kind == Kind::unavailable) continue;
    CHECK(message.error().kind == Kind::refused);
    CHECK(message.error().reason.find("message 3 of " + stream.names().stream + " is lost") !=
          std::string::npos);
    break;
  }
  stream.set({.leader = messages(4)});
  read_up_to(*log, 2, 4);
}
