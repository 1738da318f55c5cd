// The log of a cluster by real nats-servers: what is published and read, and when hosts fail.
#include <atomic>
#include <set>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "cluster/jetstream/stream_settings.h"
#include "log_of_tests.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;

TEST_CASE("a server's messages are read by another, in order, from the first on") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto writer = open_log(one.servers.url_list(), one.names);
  CHECK(publish(*writer, "a") == 1);
  CHECK(publish(*writer, std::string(512U << 10U, 'b')) == 2);

  const auto reader = open_log(one.servers.url_list(), one.names);
  CHECK(read(*reader, 0) == "a");
  CHECK(read(*reader, 1).size() == 512U << 10U);
  CHECK(publish(*writer, "c") == 3);
  CHECK(read(*reader, 2) == "c");
  CHECK(read(*writer, 0) == "a");
  CHECK(reader->figures().connected);

  const auto state = reader->state();
  REQUIRE(state);
  CHECK(state->first == 1);
  CHECK(state->last == 3);
  CHECK(state->created_ns > 1'700'000'000'000'000'000);
}

TEST_CASE("next() waits until its time, or until it is woken, and no longer") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto nothing = log->next(0, from_now(10ms));
  REQUIRE(nothing);
  CHECK_FALSE(*nothing);

  std::atomic<bool> returned{false};
  std::thread reader{[&] {
    const auto none = log->next(0, from_now(1h));
    returned = none.has_value() && !*none;
  }};
  log->wake();
  reader.join();
  CHECK(returned);
}

TEST_CASE("stop() ends what waits, and all that comes after") {
  OneServer one;
  const auto log = open_log(one.servers.url_list(), one.names);  // no stream: nobody answers
  std::thread reader{[&] {
    for (;;) {
      const auto message = log->next(0, from_now(1h));
      if (!message && message.error().reason == "stopped") return;
    }
  }};
  log->stop();
  reader.join();
  CHECK_FALSE(log->next(0, from_now(1h)));
  CHECK_FALSE(log->publish(bytes_of("a")));
  CHECK_FALSE(log->state());
}

TEST_CASE("a log without servers opens, and says so until they are there") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  one.servers.kill(0);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto published = log->publish(bytes_of("a"));
  REQUIRE_FALSE(published);
  CHECK(published.error().kind == Kind::unavailable);
  const auto message = log->next(0, from_now(50ms));
  REQUIRE_FALSE(message);
  CHECK(message.error().kind == Kind::unavailable);
  CHECK_FALSE(log->figures().connected);
  one.servers.start(0);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("a NATS server that accepts connections and sends nothing refuses no client") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  one.servers.freeze(0);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto until = from_now(3s);  // longer than the attempts that libnats makes by itself
  while (std::chrono::steady_clock::now() < until) {
    const auto state = log->state();
    REQUIRE_FALSE(state);
    REQUIRE(state.error().kind == Kind::unavailable);
    (void)log->next(0, from_now(50ms));
  }
  one.servers.go_on(0);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("a long absence is read by number, many at once") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto writer = open_log(one.servers.url_list(), one.names);
  constexpr std::uint64_t kMessages = 2000;
  for (std::uint64_t i = 1; i <= kMessages; ++i) REQUIRE(publish(*writer, std::to_string(i)) == i);
  const auto reader = open_log(one.servers.url_list(), one.names);
  for (std::uint64_t i = 0; i < kMessages; ++i) REQUIRE(read(*reader, i) == std::to_string(i + 1));
  // From anywhere, also back.
  CHECK(read(*reader, 500) == "501");
  CHECK(read(*reader, 1700) == "1701");
}

TEST_CASE("when the stream took a message is the same for all who ask, and is not the publisher's to say") {
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["max_msgs"] = 3;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto time_of = [](LogStream& of, std::uint64_t sequence) {
    const auto until = from_now(kPatience);
    for (;;) {
      const auto time_ms = of.time_of(sequence);
      if (time_ms || time_ms.error().kind != Kind::unavailable) return time_ms;
      REQUIRE(std::chrono::steady_clock::now() < until);
    }
  };
  const auto now_ms = [] {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
  };
  const std::int64_t before_ms = now_ms();
  publish(*log, "a");
  send_as_stream(one.servers, one.names.log, one.names.stream, 999, "b");
  publish(*log, "c");
  const std::int64_t after_ms = now_ms();
  std::int64_t last_ms = before_ms;
  const auto other = open_log(one.servers.url_list(), one.names);
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    const auto time_ms = time_of(*log, sequence);
    REQUIRE(time_ms.has_value());
    CHECK(*time_ms >= last_ms);
    CHECK(*time_ms <= after_ms);
    CHECK(time_of(*other, sequence).value_or(0) == *time_ms);
    last_ms = *time_ms;
  }
  CHECK(log->time_of(4).error().kind == Kind::unavailable);
  publish(*log, "d");
  CHECK(time_of(*log, 1).error().kind == Kind::gone);
}

TEST_CASE("a message of any size reaches all who read, cut where no talusd would read on") {
  OneServer one("max_payload: 4MB");
  auto settings = wanted_settings(one.names, 1);
  settings["max_msg_size"] = -1;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  const auto somebody = connected_to(one.servers.url_list());
  REQUIRE(somebody->publish(one.names.log, bytes_of(std::string(3U << 20U, 'x')), 5s));
  publish(*log, "c");
  CHECK(read(*log, 1).size() == kStreamMessageBytes + 1);
  CHECK(read(*log, 2) == "c");
}

TEST_CASE("a NATS server that does not take every message is named, and a message too large fails for good") {
  OneServer one("max_payload: 64KB");
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind == Kind::refused);
  CHECK_THAT(state.error().reason, Catch::Contains("max_payload of nats-server is 65536"));
  const auto large = log->publish(bytes_of(std::string(65'537, 'x')));
  REQUIRE_FALSE(large);
  CHECK(large.error().kind == Kind::too_large);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("a message above the stream's own limit fails for good") {
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["max_msg_size"] = 4096;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto large = log->publish(bytes_of(std::string(5000, 'x')));
  REQUIRE_FALSE(large);
  CHECK(large.error().kind == Kind::too_large);
  publish(*log, "a");
}

TEST_CASE("the leader of three servers dies: no acknowledged message is lost, and the log continues") {
  NatsServers servers;
  const StreamNames names = test_names();
  make_stream(servers, names, 3);
  const auto log = open_log(servers.url_list(), names);
  const auto other = open_log(servers.url_list(), names);
  std::set<std::string> acknowledged;
  const auto publish_some = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      const std::string text = std::to_string(i);
      publish(*log, text);
      acknowledged.insert(text);
    }
  };
  publish_some(0, 50);
  servers.kill(servers.leader_of(names.stream));
  publish_some(50, 100);
  std::uint64_t after = 0;
  int newest = -1;
  while (!acknowledged.empty()) {
    const std::string text = read(*other, after++);
    acknowledged.erase(text);
    // A message may be there twice, where its first acknowledgement did not come; never out of order.
    CHECK(std::stoi(text) >= newest);
    newest = std::stoi(text);
  }
}

TEST_CASE("a frozen server is left for another one") {
  NatsServers servers;
  const StreamNames names = test_names();
  make_stream(servers, names, 3);
  const auto log = open_log(servers.url_list(), names);
  publish(*log, "a");
  for (std::size_t server = 0; server < servers.count(); ++server) {
    servers.freeze(server);
    publish(*log, "b");
    servers.go_on(server);
    servers.await_ready();
    servers.await_replicas(names.stream);
  }
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("a server by which no leader answers is left for one by which it does, and for no other") {
  NatsServers cut_off;  // knows of no leader
  cut_off.kill(1);
  cut_off.kill(2);
  NatsServers servers{{.servers = 1}};
  const StreamNames names = test_names();
  make_stream(servers, names, 1);
  servers.end(0);
  const auto log = open_log(fmt::format("{},{}", cut_off.url(0), servers.url(0)), names);
  while (!log->figures().connected) (void)log->next(0, from_now(10ms));
  const auto number_in = [&](std::string_view page, std::string_view name) {
    const std::string text = cut_off.page(0, page);
    const std::size_t at = text.find(name);
    REQUIRE(at != std::string::npos);
    return std::stoull(text.substr(at + name.size()));
  };
  const auto ever = [&] { return number_in("/varz", "\"total_connections\":"); };
  const auto oldest = [&] { return number_in("/connz", "\"cid\":"); };
  const auto connections = ever();
  const auto own = oldest();
  const auto until = from_now(kPatience);
  while (ever() < connections + 2) {  // of those who look
    CHECK_FALSE(log->state());
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
  CHECK(oldest() == own);
  servers.start(0);
  while (!log->state()) {
    (void)log->next(0, from_now(10ms));
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
  CHECK(publish(*log, "a") == 1);
}

TEST_CASE("a number that no message has is passed over as an empty message") {
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["deny_delete"] = false;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  {
    const auto writer = open_log(one.servers.url_list(), one.names);
    for (const char* const text : {"a", "b", "c", "d", "e"}) publish(*writer, text);
  }
  // nats-server 2.9 does the same when an account's limit refuses a message.
  for (const int sequence : {2, 3, 5}) {
    const auto answer = ask(one.servers, "$JS.API.STREAM.MSG.DELETE." + one.names.stream,
                            fmt::format("{{\"seq\":{}}}", sequence));
    REQUIRE(answer.find("\"success\":true") != std::string::npos);
  }
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto read_beside_state = [&](std::uint64_t after) {
    const auto until = from_now(kPatience);
    for (;;) {
      REQUIRE(log->state());
      const auto message = log->next(after, from_now(100ms));
      REQUIRE(std::chrono::steady_clock::now() < until);
      REQUIRE(message);
      if (*message) return **message;
    }
  };
  CHECK(read(*log, 0) == "a");
  for (const std::uint64_t after : {1, 2, 4}) {
    if (after == 4) CHECK(read(*log, 3) == "d");
    const auto message = read_beside_state(after);
    CHECK(message.sequence == after + 1);
    CHECK(message.bytes.empty());
    CHECK(message.of_leader);
  }
  CHECK(publish(*log, "f") == 6);
  CHECK(read(*log, 5) == "f");
}
